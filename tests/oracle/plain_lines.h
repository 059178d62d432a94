/* plain_lines.h - all visible crossings of a scene along a line, in plain C doubles.
 *
 * This is the rule of docs/solids.md alone.  The visible crossings of each region
 * (plain_regions.h) are taken in order; one that is at most PLAIN_DELTA after a visible
 * one is omitted.  The crossings of all regions are then sorted by distance.
 */
#ifndef PLAIN_LINES_H
#define PLAIN_LINES_H

#include "tests/oracle/plain_regions.h"

struct plain_crossing {
    double distance;
    size_t primitive; /* index in the scene */
    size_t region;
    int crossing;     /* 1 enters the region's body, -1 leaves it, 0: no body */
    double normal[3]; /* against the line */
};

/* Returns whether all primitives of a region are visible and closed. */
bool plain_is_closed(const struct scene *scene, const struct region *region);

/* Returns whether the point of a line at that distance is inside the region.  The
 * direction has length one. */
bool plain_is_inside(const struct scene *scene, const struct region *region,
                     const struct ray *line, double distance);

/* Lists the crossings of a line farther than `least`, up to room of them, and returns
 * their total number.  The direction has length one. */
size_t plain_line(const struct scene *scene, const struct ray *line, double least,
                  struct plain_crossing *list, size_t room);

#endif
