/* line_rules.h - what is true of all that is seen along lines, for tests. */
#ifndef LINE_RULES_H
#define LINE_RULES_H

#include "rt/trace/ray_query.h"

#include <stdint.h>

enum { LINE_REASON = 400 };

/* As rays of the scene's camera, through any place of its picture, with directions
 * of any length. */
void draw_camera_lines(uint64_t *state, const struct scene *scene,
                       struct scene_ray *list, size_t count);
/* Along the axes and between them, through points whose coordinates are halves from
 * -1 to 1: in faces and edges, if these are there. */
void draw_grid_lines(uint64_t *state, struct scene_ray *list, size_t count);

/* Gives up where that cannot be. */
struct ray_hits find_lines(const struct scene *scene,
                           const struct ray_query_options *options,
                           const struct scene_ray *list, size_t count);

/* These tell the reason where they are false, in LINE_REASON characters. */

/* Bit for bit. */
bool same_crossings(const struct ray_hits *expected, const struct ray_hits *found,
                    char *reason);
/* .. but of several surfaces in one place another may be seen. */
bool same_distances(const struct ray_hits *expected, const struct ray_hits *found,
                    char *reason);

/* They are in order; of each region more than PLAIN_DELTA apart, into its body and
 * out of it in turn if it has one, out of it first where the line begins inside, so far
 * behind its origin, and to the outside at last if it is bounded; bodies
 * are counted; normals have length one and are against the line; points of meshes
 * lie on their triangles. */
bool keep_line_rules(const struct scene *scene, const struct scene_ray *list,
                     const struct ray_hits *found, double behind, char *reason);

/* What the plain tracer sees, which begins so far behind the origins; only where, and
 * not of what, unless certain; but for one line and a share of them where a rounding
 * decides. */
bool same_as_plain_lines(const struct scene *scene, const struct scene_ray *list,
                         const struct ray_hits *found, double behind, bool certain,
                         char *reason);

#endif
