/* grid_scene.h - generates random scenes in which faces coincide.
 *
 * Solids are nested up to four levels, of all kinds of shapes and meshes.  Their
 * coordinates are -1, -1/2, 0, 1/2 and 1, sometimes scaled by 1e-4, and their rotations
 * are quarter turns.  Some parts are mirrors or glass.  The camera is anywhere, or
 * looks along an axis, or is inside or on a solid; so are the lamps.
 */
#ifndef GRID_SCENE_H
#define GRID_SCENE_H

#include "tests/oracle/many_scenes.h"

/* One unit per pixel if the camera looks along an axis: the middle ray passes through
 * points of the grid. */
enum { GRID_WIDTH = 21, GRID_HEIGHT = 15 };

/* Generates a scene from the state, which is never 0.  Its other text has the same
 * objects in another order, where this does not change the solids.  The depth of its
 * frame is certain if the camera looks at faces obliquely, so that few rays hit
 * edges. */
struct random_scene grid_scene(uint64_t *state);

#endif
