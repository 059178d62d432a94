/* ray_query_rules.h - rules for the hits of the all-hits ray query, for tests. */
#ifndef RAY_QUERY_RULES_H
#define RAY_QUERY_RULES_H

#include "rt/trace/ray_query.h"

#include <stdint.h>

enum { LINE_REASON = 400 };

/* Generates lines like rays of the scene's camera, through random points of its
 * picture, with directions of any length. */
void draw_camera_lines(uint64_t *state, const struct scene *scene,
                       struct scene_ray *list, size_t count);
/* Generates lines along the axes and diagonals, through points whose coordinates are
 * halves from -1 to 1: in faces and edges, if there are any. */
void draw_grid_lines(uint64_t *state, struct scene_ray *list, size_t count);

/* Finds the hits of the lines.  Ends the program if that fails. */
struct ray_hits find_lines(const struct scene *scene,
                           const struct ray_query_options *options,
                           const struct scene_ray *list, size_t count);

/* These functions write the reason, of at most LINE_REASON characters, if they return
 * false. */

/* Compares bit for bit. */
bool same_crossings(const struct ray_hits *expected, const struct ray_hits *found,
                    char *reason);
/* Compares only the distances: of several surfaces in one place another may be
 * found. */
bool same_distances(const struct ray_hits *expected, const struct ray_hits *found,
                    char *reason);

/* Checks that the hits are in order; that those of a region are more than PLAIN_DELTA
 * apart and enter and leave its body alternately, first leaving it if the line starts
 * inside (at the distance `behind` before its origin), and ending outside if the region
 * is bounded; that bodies are counted; that normals have length one and point against
 * the line; that hits with meshes are on their triangles. */
bool keep_line_rules(const struct scene *scene, const struct scene_ray *list,
                     const struct ray_hits *found, double behind, char *reason);

/* Compares with the plain tracer, which starts at the distance `behind` before the
 * origins.  Unless certain, only the distances are compared.  One line and a share of
 * them may differ, because rounding decides. */
bool same_as_plain_lines(const struct scene *scene, const struct scene_ray *list,
                         const struct ray_hits *found, double behind, bool certain,
                         char *reason);

#endif
