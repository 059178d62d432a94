/* random_scenes.h - generators of random scenes: scenes with coincident faces, with
 * many regions, and with bodies that touch. */
#ifndef RANDOM_SCENES_H
#define RANDOM_SCENES_H

#include "tests/oracle/many_scenes.h"

/* Scenes with coincident faces.
 *
 * Solids are nested up to four levels, and consist of all kinds of shapes and meshes.
 * Their coordinates are -1, -1/2, 0, 1/2 and 1, sometimes scaled by 1e-4. Their
 * rotations are quarter turns. Some parts are mirrors or glass. The camera is anywhere,
 * looks along an axis, or is inside or on a solid. The same is true of the lamps.
 */

/* A pixel is one unit wide if the camera looks along an axis. The middle ray then
 * passes through points of the grid. */

enum { GRID_WIDTH = 21, GRID_HEIGHT = 15 };

/* Generates a scene from the state, which is never 0. Its other text has the same
 * objects in another order, where the order does not change the solids. The depth of
 * its frame is certain if the camera looks at faces obliquely, so that few rays hit
 * edges. */
struct random_scene grid_scene(uint64_t *state);

/* Scenes with up to a few hundred objects.
 *
 * Groups of objects are in clouds, clusters, rows and lattices of integer coordinates,
 * nested, at the same point, repeated in other colours, unbounded, tiny and huge. The
 * objects are shapes and Boolean trees, sometimes one large tree. Some are transparent
 * or mirrors, and some cast no shadow. Cameras and lamps are outside, among the
 * objects, or inside an object.
 */

enum { MAX_MANY_REGIONS = 400 };

/* Generates a scene from the state. A pixel of more work means a smaller frame. */
struct random_scene many_regions(uint64_t *state);

/* Scenes with bodies whose faces coincide.
 *
 * The bodies are boxes, cylinders, cones, prisms, meshes, merges and bored boxes,
 * turned about the vertical. Their faces coincide with the ground, which is a plane or
 * a box. In some scenes everything is rotated. In stacks the bodies also touch each
 * other, and the ground may be transparent. Stacks of opaque bodies also contain
 * spheres, tori, lathes, open cylinders, discs and triangles.
 */

enum { COINCIDENT_WIDTH = 32, COINCIDENT_HEIGHT = 24 };

enum coincident_kind {
    COINCIDENT_CLEAR,   /* transparent bodies on a ground */
    COINCIDENT_STACKED, /* transparent bodies in stacks; one body may be opaque */
    COINCIDENT_OPAQUE   /* opaque bodies in stacks */
};
enum coincident_kind coincident_scene_kind(uint64_t seed);

/* Returns the text of a scene with the ground raised by `lift`. Faces then do not
 * coincide, and the bodies extend into the ground. The caller frees the text. */
char *coincident_scene_text(uint64_t seed, double lift);

#endif
