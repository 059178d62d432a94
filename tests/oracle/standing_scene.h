/* standing_scene.h - random scenes of bodies whose faces coincide.
 *
 * The faces of the bodies coincide with the ground: boxes, cylinders, cones, prisms,
 * meshes, merges and bored boxes, turned about the vertical; the ground is a plane or
 * a box, and now and then all of it is turned.  In stacks the bodies also touch each
 * other, and the ground may be clear.  Opaque bodies are in stacks, too; spheres, tori,
 * lathes, open cylinders, discs and triangles are among them.
 */
#ifndef STANDING_SCENE_H
#define STANDING_SCENE_H

#include <stdint.h>

enum { STANDING_WIDTH = 32, STANDING_HEIGHT = 24 };

enum standing_kind {
    STANDING_CLEAR,   /* clear bodies on a ground */
    STANDING_STACKED, /* .. in stacks, one of them perhaps opaque */
    STANDING_OPAQUE   /* opaque bodies in stacks */
};
enum standing_kind standing_scene_kind(uint64_t seed);

/* In the scene language, with the ground higher by lift: then no faces coincide, and
 * the bodies reach into the ground.  The caller frees it. */
char *standing_scene_text(uint64_t seed, double lift);

#endif
