/* plain_regions.h - where a ray meets a region, for the plain tracer.
 *
 * A crossing can be seen where its primitive, and every part of the region's
 * tree that this belongs to, is another thing just behind it than just before:
 * both are asked of points, PLAIN_DELTA away along the ray.  So surfaces nearer
 * to each other than that vanish together, or are one: that of the first
 * primitive of which this is true.
 */
#ifndef PLAIN_REGIONS_H
#define PLAIN_REGIONS_H

#include "tests/oracle/plain_shapes.h"

#define PLAIN_DELTA 1e-7

struct plain_hit {
    const struct primitive *primitive; /* NULL: none */
    double distance;
    double normal[3]; /* world, unit, against the ray */
    bool entering;    /* what is solid lies behind it */
};

/* A ray's crossings with one region: room for any of the scene's. */
struct crossing_list;
struct crossing_list *crossing_list_new(const struct scene *scene);
void crossing_list_free(struct crossing_list *list);

/* All crossings of the line with the region's primitives. */
void plain_cross_region(struct crossing_list *list, const struct scene *scene,
                        const struct region *region, const struct ray *ray);

/* The nearest of them that can be seen beyond `last` and before `limit`; false
 * when there is none. */
bool plain_next_hit(const struct crossing_list *list, double last, double limit,
                    struct plain_hit *hit);

/* Is the line inside of the region at that distance? */
bool plain_holds(const struct crossing_list *list, double distance);

/* A point by a transform. */
void to_other_space(const struct transform *transform, const double in[3],
                    double out[3]);

#endif
