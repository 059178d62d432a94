/* many_regions.h - scenes by chance of no object at all up to some hundred.
 *
 * Groups of things in clouds, clusters, rows and lattices on whole numbers, one
 * within the other, all in one point, the same thing again and again in other
 * colours, without an end, tiny and huge: shapes, trees of them, now and then
 * one great tree.  Some are clear or mirrors, some cast no shadow.  Eyes and
 * lamps stand outside, among the things, or within one.
 */
#ifndef MANY_REGIONS_H
#define MANY_REGIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MANY_REGIONS_MOST = 400 };

struct many_regions;

/* All from the state, which is never 0.  The caller frees it. */
struct many_regions *many_regions_random(uint64_t *state);
void many_regions_free(struct many_regions *scene);

/* In the scene language; the caller frees it. */
char *many_regions_text(const struct many_regions *scene);

/* Of its frame, in pixels: the more there is to see, the smaller. */
size_t many_regions_width(const struct many_regions *scene);
size_t many_regions_height(const struct many_regions *scene);
/* Rays that meet primitives in that frame, roughly. */
double many_regions_work(const struct many_regions *scene);
/* What must be the same to any tracer: where faces of several things may coincide
 * a rounding decides which is seen, and where the eye may be in one, if it is. */
enum certainty { NOTHING_CERTAIN, DEPTH_CERTAIN, ALL_CERTAIN };
enum certainty many_regions_certainty(const struct many_regions *scene);

/* The scene with something left out, in one way after another from 0 on: many
 * things, single ones, what they are made of.  NULL: there is no such way. */
struct many_regions *many_regions_without(const struct many_regions *scene, size_t way);

#endif
