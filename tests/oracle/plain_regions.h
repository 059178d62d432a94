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

/* --- lines ---------------------------------------------------------------------
 *
 * All visible crossings of a scene along a line, by the rule of docs/solids.md alone.
 * The visible crossings of each region are taken in order; one that is at most
 * PLAIN_DELTA after a visible one is omitted.  The crossings of all regions are then
 * sorted by distance. */

struct plain_crossing {
    double distance;
    size_t primitive; /* index in the scene */
    size_t region;
    int crossing;     /* 1 enters the region's body, -1 leaves it, 0: no body */
    double normal[3]; /* against the line */
};

/* Returns whether all primitives of a region are visible and closed. */
bool plain_is_closed(const struct scene *scene, const struct region *region);

/* Returns whether the point of a line at that distance is inside the region.  The
 * direction has length one. */
bool plain_is_inside(const struct scene *scene, const struct region *region,
                     const struct ray *line, double distance);

/* Lists the crossings of a line farther than `least`, up to room of them, and returns
 * their total number.  The direction has length one. */
size_t plain_line(const struct scene *scene, const struct ray *line, double least,
                  struct plain_crossing *list, size_t room);

/* --- mass ----------------------------------------------------------------------
 *
 * Volume and centroid of a scene's solids by sampling points. */

/* The volume and the three first moments about the centre of the box. */
enum { PLAIN_MASS_FIGURES = 4 };

/* Samples the box with one random point in each cell; error is the standard error. */
void plain_mass(const struct scene *scene, const double middle[3],
                const double width[3], uint64_t *state,
                double value[PLAIN_MASS_FIGURES], double error[PLAIN_MASS_FIGURES]);

#endif
