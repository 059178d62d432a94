/* surfaces.h - the surfaces of a scene between which heat goes: its primitives, its
 * parts or its materials, with their areas, and the factors between them.
 *
 * The factor from one to another is that of its primitives, each by its share of the area.
 * Rays of different primitives are independent, and so are their errors.
 */
#ifndef RT_SURFACES_H
#define RT_SURFACES_H

#include "rt/heat/factors.h"
#include "rt/heat/global_lines.h"
#include "rt/scene/scene_internal.h"

enum surfaces_by { BY_PRIMITIVE, BY_PART, BY_MATERIAL, SURFACES_BY };

struct surface {
    const char *name; /* of the part or the material, or the primitive's number */
    const struct primitive *first; /* of its primitives */
    size_t part;                   /* .. the part that it is of */
    struct estimate area;
    uint64_t tried, sent; /* points and rays; by lines, ends of gaps */
    bool receives_alone;  /* some of it has no emission */
    uint64_t *count;      /* [surfaces + 1], the last one the environment */
    struct estimate *factor;
    double *smooth; /* NULL, or those that are smoothed (smooth.h) */
};

struct surfaces {
    size_t count;
    struct surface *list;
    size_t primitive_count;
    size_t *surface_of; /* of each of the scene's primitives, */
    size_t *part_of;    /* .. and its part */
    struct arena kept;
};

/* Without areas and factors yet.  What is given must outlive them.  False: no memory. */
bool surfaces_find(const struct scene *scene, const struct named_parts *parts,
                   enum surfaces_by by, struct surfaces *surfaces);
void surfaces_free(struct surfaces *surfaces);

/* Of the rows of all primitives, which have surfaces as receivers; one that has no
 * emission has an empty one. */
void surfaces_combine(struct surfaces *surfaces, const struct factor_row *rows);

/* Of all of them at once. */
void surfaces_take_lines(struct surfaces *surfaces, const struct global_lines *found);

/* The factor from one to another, smoothed if they are. */
double surface_factor(const struct surface *from, size_t to);

/* By how many standard errors A F from one to the other differs from that back; NaN: of itself,
 * or where there is no way back. */
double surfaces_reciprocity(const struct surfaces *surfaces, size_t from, size_t to);

#endif
