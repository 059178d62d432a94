/* grid_scene.h - random scenes in which faces coincide.
 *
 * Solids of solids, up to four deep, of all kinds of shapes, and meshes: their
 * coordinates are -1, -1/2, 0, 1/2 and 1, now and then ten thousand times as
 * small, their turns quarter turns.  Some parts are mirrors or glass.
 * The eye stands anywhere, or looks along an axis, or is in or on a solid;
 * so do lamps.
 */
#ifndef GRID_SCENE_H
#define GRID_SCENE_H

#include "tests/oracle/many_scenes.h"

/* One unit for each pixel where the eye looks along an axis: the middle ray
 * runs through points of the grid. */
enum { GRID_WIDTH = 21, GRID_HEIGHT = 15 };

/* All from the state, which is never 0.  Its other scene has the same things in another
 * order, as far as that makes no other solids; of its frame the depth is certain where the
 * eye looks at faces aslant, so that few rays meet edges. */
struct random_scene grid_scene(uint64_t *state);

#endif
