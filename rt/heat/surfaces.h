/* surfaces.h - the surfaces of a scene that exchange heat: its primitives, its
 * parts or its materials, with their areas and the factors between them.
 *
 * The factor between two surfaces is the mean over the first one's primitives,
 * weighted by area. Rays of different primitives are independent, so their errors
 * are, too.
 */
#ifndef RT_SURFACES_H
#define RT_SURFACES_H

#include "rt/heat/factors.h"
#include "rt/heat/global_lines.h"
#include "rt/scene/scene_internal.h"

enum surfaces_by { BY_PRIMITIVE, BY_PART, BY_MATERIAL, SURFACES_BY };

struct surface {
    const char *name; /* of the part or the material, or the primitive's number */
    const struct primitive *first; /* the first of its primitives */
    size_t part;                   /* the part of that primitive */
    struct estimate area;
    uint64_t tried, sent; /* points and rays; by lines, ends of gaps */
    bool receives_alone;  /* a part of it has no emission */
    uint64_t *count;      /* [surfaces + 1]; the last one is the environment */
    struct estimate *factor;
    double *smooth; /* NULL, or the smoothed factors (smooth.h) */
};

struct surfaces {
    size_t count;
    struct surface *list;
    size_t primitive_count;
    size_t *surface_of; /* for each of the scene's primitives */
    size_t *part_of;    /* the part of each primitive */
    struct arena kept;
};

/* Lists the surfaces, without areas and factors. The arguments must outlive the
 * surfaces. Returns false if out of memory. */
bool surfaces_find(const struct scene *scene, const struct named_parts *parts,
                   enum surfaces_by by, struct surfaces *surfaces);
void surfaces_free(struct surfaces *surfaces);

/* Computes areas and factors from the rows of all primitives, whose receivers are
 * surfaces. A primitive without emission has an empty row. */
void surfaces_combine(struct surfaces *surfaces, const struct factor_row *rows);

/* Computes areas and factors from the counts of lines. */
void surfaces_take_lines(struct surfaces *surfaces, const struct global_lines *found);

/* Returns a factor; the smoothed one if available. */
double surface_factor(const struct surface *from, size_t to);

/* Returns the difference between A F in one direction and in the other, in
 * standard errors. NaN if both surfaces are the same, or if the other direction
 * has no estimate. */
double surfaces_reciprocity(const struct surfaces *surfaces, size_t from, size_t to);

#endif
