/* random_scenes.h - generators of random scenes: of faces that coincide, of many
 * regions, and of bodies that touch. */
#ifndef RANDOM_SCENES_H
#define RANDOM_SCENES_H

#include "tests/oracle/many_scenes.h"

/* Scenes in which faces coincide.
 *
 * Solids are nested up to four levels, of all kinds of shapes and meshes.  Their
 * coordinates are -1, -1/2, 0, 1/2 and 1, sometimes scaled by 1e-4, and their rotations
 * are quarter turns.  Some parts are mirrors or glass.  The camera is anywhere, or
 * looks along an axis, or is inside or on a solid; so are the lamps.
 */

/* One unit per pixel if the camera looks along an axis: the middle ray passes through
 * points of the grid. */

enum { GRID_WIDTH = 21, GRID_HEIGHT = 15 };

/* Generates a scene from the state, which is never 0.  Its other text has the same
 * objects in another order, where this does not change the solids.  The depth of its
 * frame is certain if the camera looks at faces obliquely, so that few rays hit
 * edges. */
struct random_scene grid_scene(uint64_t *state);

/* Scenes of zero to a few hundred objects.
 *
 * Groups of objects are in clouds, clusters, rows and lattices of integer coordinates,
 * nested, at one point, repeated in other colours, unbounded, tiny and huge.  The
 * objects are shapes and Boolean trees, sometimes one large tree.  Some are transparent
 * or mirrors, some cast no shadow.  Cameras and lamps are outside, among the objects,
 * or inside one.
 */

enum { MAX_MANY_REGIONS = 400 };

/* Generates a scene from the state, which is never 0.  The more work a pixel takes, the
 * smaller the frame. */
struct random_scene many_regions(uint64_t *state);

/* Scenes of bodies whose faces coincide.
 *
 * The bodies are boxes, cylinders, cones, prisms, meshes, merges and bored boxes,
 * turned about the vertical; their faces coincide with the ground.  The ground is a
 * plane or a box, and in some scenes everything is rotated.  In stacks the bodies also
 * touch each other, and the ground may be transparent.  Opaque bodies are also in
 * stacks; they include spheres, tori, lathes, open cylinders, discs and triangles.
 */

enum { COINCIDENT_WIDTH = 32, COINCIDENT_HEIGHT = 24 };

enum coincident_kind {
    COINCIDENT_CLEAR,   /* transparent bodies on a ground */
    COINCIDENT_STACKED, /* the same in stacks, one perhaps opaque */
    COINCIDENT_OPAQUE   /* opaque bodies in stacks */
};
enum coincident_kind coincident_scene_kind(uint64_t seed);

/* Returns the scene in the scene language, with the ground raised by lift: faces then
 * do not coincide, and the bodies extend into the ground.  The caller frees it. */
char *coincident_scene_text(uint64_t seed, double lift);

#endif
