/* overlaps.h - which parts of a scene may claim the same space, and what the machine is
 * told of them to find how much (rt/kernels/mass/overlaps.s).
 *
 * A pair are two parts, or one part with itself: of that the volume counts which more than
 * one of its objects claim.  Pairs whose objects' boxes are apart are none.
 */
#ifndef RT_MASS_OVERLAPS_H
#define RT_MASS_OVERLAPS_H

#include "rt/layout/single_run.h"
#include "rt/scene/scene.h"

/* The lower part comes first. */
struct overlap_pair {
    size_t parts[2];
};

struct overlaps {
    size_t count;
    struct overlap_pair *pairs; /* by their first part, then by the second */
    size_t part_count;
    size_t *objects; /* of each part, how many have bodies */
};

/* Of a scene whose bodies all have an end; part_of: of each of its objects, its part.  False: no
 * memory. */
bool overlaps_find(const struct scene *scene, const size_t *part_of, size_t part_count,
                   struct overlaps *overlaps);
void overlaps_free(struct overlaps *overlaps);

/* What the program of overlaps is given besides the crossings; what fails fails the run. */
void overlaps_give(const struct overlaps *overlaps, struct single_run *run);

#endif
