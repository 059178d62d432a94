/* grid_scene.h - scenes by chance in which faces coincide, and smaller ones.
 *
 * Solids of solids, up to four deep, of all kinds of shapes, and meshes: their
 * coordinates are -1, -1/2, 0, 1/2 and 1, now and then ten thousand times as
 * small, their turns quarter turns.  Some parts are mirrors or glass.
 * The eye stands anywhere, or looks along an axis, or stands in or on a solid;
 * so do lamps.
 */
#ifndef GRID_SCENE_H
#define GRID_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One unit for each pixel where the eye looks along an axis: the middle ray
 * runs through points of the grid. */
enum { GRID_WIDTH = 21, GRID_HEIGHT = 15 };

struct grid_scene;

/* All from the state, which is never 0.  The caller frees it. */
struct grid_scene *grid_scene_random(uint64_t *state);
void grid_scene_free(struct grid_scene *scene);

/* In the scene language; the caller frees it. */
char *grid_scene_text(const struct grid_scene *scene);

/* Does the eye look at faces aslant, so that few rays meet edges? */
bool grid_scene_is_aslant(const struct grid_scene *scene);

/* The same things in another order, as far as that makes no other solids. */
struct grid_scene *grid_scene_shuffled(const struct grid_scene *scene, uint64_t *state);

/* The scene with something left out, in one way after another from 0 on.
 * NULL: there is no such way. */
struct grid_scene *grid_scene_without(const struct grid_scene *scene, size_t way);

#endif
