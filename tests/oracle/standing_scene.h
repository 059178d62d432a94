/* standing_scene.h - random scenes of bodies whose faces coincide.
 *
 * The bodies are boxes, cylinders, cones, prisms, meshes, merges and bored boxes,
 * turned about the vertical; their faces coincide with the ground.  The ground is a
 * plane or a box, and in some scenes everything is rotated.  In stacks the bodies also
 * touch each other, and the ground may be transparent.  Opaque bodies are also in
 * stacks; they include spheres, tori, lathes, open cylinders, discs and triangles.
 */
#ifndef STANDING_SCENE_H
#define STANDING_SCENE_H

#include <stdint.h>

enum { STANDING_WIDTH = 32, STANDING_HEIGHT = 24 };

enum standing_kind {
    STANDING_CLEAR,   /* transparent bodies on a ground */
    STANDING_STACKED, /* the same in stacks, one perhaps opaque */
    STANDING_OPAQUE   /* opaque bodies in stacks */
};
enum standing_kind standing_scene_kind(uint64_t seed);

/* Returns the scene in the scene language, with the ground raised by lift: faces then
 * do not coincide, and the bodies extend into the ground.  The caller frees it. */
char *standing_scene_text(uint64_t seed, double lift);

#endif
