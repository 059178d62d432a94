/* ray_query_rules.h - rules for the hits of the all-hits ray query, for tests. */
#ifndef RAY_QUERY_RULES_H
#define RAY_QUERY_RULES_H

#include "rt/trace/ray_query.h"

#include <stdint.h>

enum { LINE_REASON = 400 };

/* Generates lines like the rays of the scene's camera, through random points of its
 * picture. The lengths of their directions vary. */
void draw_camera_lines(uint64_t *state, const struct scene *scene,
                       struct scene_ray *list, size_t count);
/* Generates lines along the axes and diagonals, through points whose coordinates are
 * multiples of 1/2 from -1 to 1. They run in faces and edges, if there are any. */
void draw_grid_lines(uint64_t *state, struct scene_ray *list, size_t count);

/* Finds the hits of the lines. If this fails, ends the program. */
struct ray_hits find_lines(const struct scene *scene,
                           const struct ray_query_options *options,
                           const struct scene_ray *list, size_t count);

/* The following functions return false and a reason of at most LINE_REASON characters
 * if a rule is broken. */

/* Compares all values of the hits bit for bit. */
bool same_crossings(const struct ray_hits *expected, const struct ray_hits *found,
                    char *reason);
/* Compares only distances, because coincident surfaces may be found in any order. */
bool same_distances(const struct ray_hits *expected, const struct ray_hits *found,
                    char *reason);

/* Checks these rules:
 *
 * - The hits are in order.
 * - The hits of a region are more than PLAIN_DELTA apart.
 * - They alternately enter and leave the region's body. The first hit leaves it if the
 *   line starts inside, at the distance `behind` before its origin. The last hit leaves
 *   it if the region is bounded.
 * - The depths count the bodies.
 * - Normals have length 1, and are opposed to the line.
 * - Hits with meshes are on their triangles. */
bool keep_line_rules(const struct scene *scene, const struct scene_ray *list,
                     const struct ray_hits *found, double behind, char *reason);

/* Compares with the plain tracer, which starts at the distance `behind` before the
 * origins. If `certain` is false, compares only the distances. One line and a fraction
 * of all lines may differ, because rounding decides. */
bool same_as_plain_lines(const struct scene *scene, const struct scene_ray *list,
                         const struct ray_hits *found, double behind, bool certain,
                         char *reason);

#endif
