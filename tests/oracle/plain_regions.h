/* plain_regions.h - crossings of a ray with a region, for the plain tracer.
 *
 * A crossing is visible if the inside tests of its primitive, and of every node of the
 * region's tree that contains it, differ just before and just after it: at points
 * PLAIN_DELTA away along the ray.  So surfaces nearer to each other than that vanish
 * together or count as one, which belongs to the first visible primitive.
 */
#ifndef PLAIN_REGIONS_H
#define PLAIN_REGIONS_H

#include "tests/oracle/plain_shapes.h"

#define PLAIN_DELTA 1e-7

struct plain_hit {
    const struct primitive *primitive; /* NULL: none */
    double distance;
    double normal[3]; /* world, unit, against the ray */
    bool entering;    /* the ray enters a solid */
};

/* A ray's crossings with one region, with room for any region of the scene. */
struct crossing_list;
struct crossing_list *crossing_list_new(const struct scene *scene);
void crossing_list_free(struct crossing_list *list);

/* Computes all crossings of the line with the region's primitives. */
void plain_cross_region(struct crossing_list *list, const struct scene *scene,
                        const struct region *region, const struct ray *ray);

/* Sets hit to the nearest visible crossing beyond `last` and before `limit`; returns
 * false if there is none. */
bool plain_next_hit(const struct crossing_list *list, double last, double limit,
                    struct plain_hit *hit);

/* Returns whether the line is inside the region at that distance. */
bool plain_holds(const struct crossing_list *list, double distance);

#endif
