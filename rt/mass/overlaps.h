/* overlaps.h - lists the parts of a scene that may occupy the same space. Also writes
 * the tables with which the machine computes their overlaps
 * (rt/kernels/mass/overlaps.s).
 *
 * A pair consists of two parts, or of a part and itself. The overlap of a part with
 * itself is the volume that several of its objects occupy. If the boxes of two parts'
 * objects are disjoint, the parts form no pair.
 */
#ifndef RT_MASS_OVERLAPS_H
#define RT_MASS_OVERLAPS_H

#include "rt/layout/single_run.h"
#include "rt/scene/scene.h"

/* Two parts that may overlap. parts[0] is the lower number. */
struct overlap_pair {
    size_t parts[2];
};

struct overlaps {
    size_t count;
    struct overlap_pair *pairs; /* sorted by the first part, then by the second part */
    size_t part_count;
    size_t *objects; /* for each part: number of objects with bodies */
};

/* Lists the pairs of parts that may overlap. All bodies of the scene must be bounded.
 * part_of contains the part of each object. Returns false if out of memory. */
bool overlaps_find(const struct scene *scene, const size_t *part_of, size_t part_count,
                   struct overlaps *overlaps);
void overlaps_free(struct overlaps *overlaps);

/* Writes the input of overlaps.s, except the crossings. If this fails, single_run_end
 * reports the error. */
void overlaps_give(const struct overlaps *overlaps, struct single_run *run);

#endif
