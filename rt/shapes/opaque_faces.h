/* opaque_faces.h - the faces of the opaque surfaces of a region. */
#ifndef RT_OPAQUE_FACES_H
#define RT_OPAQUE_FACES_H

#include "rt/scene/scene.h"

enum face_sort { FACE_FLAT, FACE_QUADRIC, FACE_SHAPE };

/* Two faces that coincide have nearly the same key. */
struct face {
    enum face_sort sort;
    double key;
    size_t region;
    const struct primitive *primitive;
    double plane[4]; /* of a flat one: its normal of length one, distance */
    int side;        /* of a body that no ray enters: 1 if what is below the plane, or
                        inside of the quadric, is solid, -1 if the rest is; else 0 */
    double low[3], high[3];
};

/* Begins with zero; the faces are to be freed. */
struct face_list {
    size_t count;
    struct face *faces;
    bool failed; /* no memory */
};

/* Appends the faces of the region with a number in the scene.  Prisms without height
 * have none. */
void opaque_faces_add(struct face_list *list, const struct scene *scene, size_t region);

/* The order of qsort: by sort, key, left end, region. */
int face_compare(const void *a, const void *b);

/* Whether the keys of two faces in that order may be those of equal surfaces. */
bool face_is_near(const struct face *a, const struct face *b);

/* Whether the planes of two flat faces are one within a reach about a point. */
bool face_same_plane(const struct face *a, const struct face *b, const double at[3],
                     double reach);

/* The center of a box, and the distance from there to its corners. */
double face_middle(const double low[3], const double high[3], double center[3]);

#endif
