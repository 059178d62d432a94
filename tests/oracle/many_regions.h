/* many_regions.h - generates random scenes of zero to a few hundred objects.
 *
 * Groups of objects are in clouds, clusters, rows and lattices of integer coordinates,
 * nested, at one point, repeated in other colours, unbounded, tiny and huge.  The
 * objects are shapes and Boolean trees, sometimes one large tree.  Some are transparent
 * or mirrors, some cast no shadow.  Cameras and lamps are outside, among the objects,
 * or inside one.
 */
#ifndef MANY_REGIONS_H
#define MANY_REGIONS_H

#include "tests/oracle/many_scenes.h"

enum { MAX_MANY_REGIONS = 400 };

/* Generates a scene from the state, which is never 0.  The more work a pixel takes, the
 * smaller the frame. */
struct random_scene many_regions(uint64_t *state);

#endif
