/* plain_regions.h - crossings of a ray with a region, for the plain tracer.
 *
 * A crossing is visible if the states of its primitive, and of every node of the
 * region's tree that contains the primitive, differ just before and just after the
 * crossing. These states are tested at the distance PLAIN_DELTA from it along the ray.
 * Surfaces that are nearer to each other therefore vanish together, or count as one
 * surface, which belongs to the first visible primitive.
 */
#ifndef PLAIN_REGIONS_H
#define PLAIN_REGIONS_H

#include "tests/oracle/plain_shapes.h"

#define PLAIN_DELTA 1e-7

struct plain_hit {
    const struct primitive *primitive; /* NULL: none */
    double distance;
    double normal[3]; /* unit normal in world space, opposed to the ray */
    bool entering;    /* the ray enters a solid */
};

/* The crossings of a ray with one region. There is room for any region of the scene. */
struct crossing_list;
struct crossing_list *crossing_list_new(const struct scene *scene);
void crossing_list_free(struct crossing_list *list);

/* Computes all crossings of the line with the region's primitives. */
void plain_cross_region(struct crossing_list *list, const struct scene *scene,
                        const struct region *region, const struct ray *ray);

/* Sets hit to the nearest visible crossing between `last` and `limit`, if any. */
bool plain_next_hit(const struct crossing_list *list, double last, double limit,
                    struct plain_hit *hit);

/* Returns true if the line is inside the region at this distance. */
bool plain_holds(const struct crossing_list *list, double distance);

/* --- lines ---------------------------------------------------------------------
 *
 * Finds all visible crossings of a line with a scene, only by the rule of
 * docs/solids.md. The visible crossings of a region are examined in order. A crossing
 * is omitted if its distance from the previous visible crossing is at most PLAIN_DELTA.
 * The crossings of all regions are then sorted by distance. */

struct plain_crossing {
    double distance;
    size_t primitive; /* index in the scene */
    size_t region;
    int crossing;     /* 1 enters the region's body, -1 leaves it, 0: no body */
    double normal[3]; /* opposed to the line */
};

/* Returns true if all primitives of a region are visible and closed. */
bool plain_is_closed(const struct scene *scene, const struct region *region);

/* Returns true if a line's point is inside the region. The direction has length 1. */
bool plain_is_inside(const struct scene *scene, const struct region *region,
                     const struct ray *line, double distance);

/* Lists up to `room` crossings of a line that are farther than `least`, and returns the
 * number of all such crossings. The direction must have length 1. */
size_t plain_line(const struct scene *scene, const struct ray *line, double least,
                  struct plain_crossing *list, size_t room);

/* --- mass ----------------------------------------------------------------------
 *
 * Computes the volume and centroid of a scene's solids by sampling points. */

/* The volume and the three first moments about the centre of the box. */
enum { PLAIN_MASS_FIGURES = 4 };

/* Samples the box with a random point in each cell. Sets error to standard errors. */
void plain_mass(const struct scene *scene, const double middle[3],
                const double width[3], uint64_t *state,
                double value[PLAIN_MASS_FIGURES], double error[PLAIN_MASS_FIGURES]);

#endif
