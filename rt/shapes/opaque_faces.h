/* opaque_faces.h - collects the faces of the opaque surfaces of a region. */
#ifndef RT_OPAQUE_FACES_H
#define RT_OPAQUE_FACES_H

#include "rt/scene/scene.h"

enum face_sort { FACE_FLAT, FACE_QUADRIC, FACE_SHAPE };

/* A face. Faces that coincide have nearly equal keys. */
struct face {
    enum face_sort sort;
    double key;
    size_t region;
    const struct primitive *primitive;
    double plane[4]; /* unit normal and distance of a flat face */
    int side;        /* For a body that no ray enters: 1 if the solid is below the plane
                      * or inside the quadric, -1 if it is on the other side. For other
                      * bodies: 0. */
    double low[3], high[3];
};

/* A list of faces. It must be initialised with zeros. The caller frees the faces. */
struct face_list {
    size_t count;
    struct face *faces;
    bool failed; /* out of memory */
};

/* Appends the faces of a region, which is given by its index. Prisms without height
 * have no faces. */
void opaque_faces_add(struct face_list *list, const struct scene *scene, size_t region);

/* Compares two faces for qsort: first `sort`, then the keys, the left ends of the
 * boxes, and the regions. */
int face_compare(const void *a, const void *b);

/* Returns true if the keys of two faces are nearly equal. The faces must be adjacent in
 * the order of face_compare. */
bool face_is_near(const struct face *a, const struct face *b);

/* Returns true if the planes of two flat faces are equal within the distance `reach`
 * from a point. */
bool face_same_plane(const struct face *a, const struct face *b, const double at[3],
                     double reach);

/* Sets the centre of a box. Returns the distance from the centre to the corners. */
double face_middle(const double low[3], const double high[3], double center[3]);

#endif
