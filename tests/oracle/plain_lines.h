/* plain_lines.h - all that is seen of a scene along a line, in plain C doubles.
 *
 * From the rule of docs/solids.md alone: of each region the crossings that can be
 * seen (plain_regions.h), one behind the other, those no farther than PLAIN_DELTA
 * behind one that is seen left out; then those of all regions by their distance.
 */
#ifndef PLAIN_LINES_H
#define PLAIN_LINES_H

#include "tests/oracle/plain_regions.h"

struct plain_crossing {
    double distance;
    size_t primitive; /* of the scene's, from 0 on */
    size_t region;
    int crossing;     /* 1 into the region's body, -1 out of it, 0: it has none */
    double normal[3]; /* against the line */
};

/* Whether all surfaces of a region are seen, and those of bodies. */
bool plain_is_closed(const struct scene *scene, const struct region *region);

/* Is a line whose direction has length one inside of it at that distance? */
bool plain_is_inside(const struct scene *scene, const struct region *region,
                     const struct ray *line, double distance);

/* Those of a line whose direction has length one, farther than `least`; as many as
 * there is room for.  Returns how many there are. */
size_t plain_line(const struct scene *scene, const struct ray *line, double least,
                  struct plain_crossing *list, size_t room);

#endif
