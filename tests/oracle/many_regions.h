/* many_regions.h - random scenes of no object at all up to some hundred.
 *
 * Groups of things in clouds, clusters, rows and lattices on whole numbers, one
 * within the other, all in one point, the same thing again and again in other
 * colours, without an end, tiny and huge: shapes, trees of them, now and then
 * one great tree.  Some are clear or mirrors, some cast no shadow.  Eyes and
 * lamps stand outside, among the things, or within one.
 */
#ifndef MANY_REGIONS_H
#define MANY_REGIONS_H

#include "tests/oracle/many_scenes.h"

enum { MAX_MANY_REGIONS = 400 };

/* All from the state, which is never 0; the more there is to see, the smaller the frame. */
struct random_scene many_regions(uint64_t *state);

#endif
