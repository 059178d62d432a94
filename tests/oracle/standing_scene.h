/* standing_scene.h - random scenes of clear bodies that stand on a ground.
 *
 * The faces of the bodies coincide with the ground: boxes, cylinders, cones, prisms,
 * meshes, merges and bored boxes, turned about the vertical; the ground is a plane or
 * a box, and now and then all of it is turned.  In stacks the bodies also touch each
 * other, and the ground may be clear.
 */
#ifndef STANDING_SCENE_H
#define STANDING_SCENE_H

#include <stdbool.h>
#include <stdint.h>

enum { STANDING_WIDTH = 32, STANDING_HEIGHT = 24 };

/* Are the bodies in stacks? */
bool standing_scene_is_stacked(uint64_t seed);

/* In the scene language, with the ground higher by lift: then no faces coincide, and
 * the bodies reach into the ground.  The caller frees it. */
char *standing_scene_text(uint64_t seed, double lift);

#endif
