/* surfaces.h - the surfaces of a scene that exchange heat, with their areas and the
 * factors between them. They are its primitives, parts or materials.
 *
 * The factor between two surfaces is the mean over the primitives of the first surface,
 * weighted by area. Rays of different primitives are independent, and so are their
 * errors.
 */
#ifndef RT_SURFACES_H
#define RT_SURFACES_H

#include "rt/heat/factors.h"
#include "rt/heat/global_lines.h"
#include "rt/scene/named_parts.h"

enum surfaces_by { BY_PRIMITIVE, BY_PART, BY_MATERIAL, SURFACES_BY };

struct surface {
    const char *name; /* name of the part or material, or number of the primitive */
    const struct primitive *first; /* first primitive of the surface */
    size_t part;                   /* part of that primitive */
    struct estimate area;
    uint64_t tried, sent; /* numbers of points and rays; for lines, both are the number
                           * of ends of gaps */
    bool receives_alone;  /* one of its primitives has no emission */
    uint64_t *count;      /* [surfaces + 1]; the last element is the environment */
    struct estimate *factor;
    double *smooth; /* smoothed factors (smooth.h), or NULL */
};

struct surfaces {
    size_t count;
    struct surface *list;
    size_t primitive_count;
    size_t *surface_of; /* surface of each primitive */
    size_t *part_of;    /* part of each primitive */
    struct arena kept;
};

/* Lists the surfaces, without areas and factors. The arguments must outlive the
 * surfaces. Returns false if out of memory. */
bool surfaces_find(const struct scene *scene, const struct named_parts *parts,
                   enum surfaces_by by, struct surfaces *surfaces);
void surfaces_free(struct surfaces *surfaces);

/* Computes the areas of the surfaces and the factors between them from the rows of all
 * primitives. The receivers of the rows are surfaces. A primitive without emission has
 * an empty row. */
void surfaces_combine(struct surfaces *surfaces, const struct factor_row *rows);

/* Computes the areas of the surfaces and the factors between them from the counts of
 * lines. */
void surfaces_take_lines(struct surfaces *surfaces, const struct global_lines *found);

/* Returns the smoothed factor if it is available, else the factor. */
double surface_factor(const struct surface *from, size_t to);

/* Compares the flows between two surfaces in both directions. A flow is the area of a
 * surface times its factor to the other surface. Returns the difference of the flows in
 * standard errors. Returns NaN if both surfaces are the same, or if the other direction
 * has no estimate. */
double surfaces_reciprocity(const struct surfaces *surfaces, size_t from, size_t to);

#endif
