/* overlaps.h - lists the parts of a scene that may occupy the same space, and
 * writes the tables from which the machine computes their overlaps
 * (rt/kernels/mass/overlaps.s).
 *
 * A pair is two parts, or a part with itself. The overlap of a part with itself is
 * the volume that several of its objects occupy. Parts whose objects have disjoint
 * boxes form no pair.
 */
#ifndef RT_MASS_OVERLAPS_H
#define RT_MASS_OVERLAPS_H

#include "rt/layout/single_run.h"
#include "rt/scene/scene.h"

/* A pair. The lower part comes first. */
struct overlap_pair {
    size_t parts[2];
};

struct overlaps {
    size_t count;
    struct overlap_pair *pairs; /* sorted by the first part, then by the second */
    size_t part_count;
    size_t *objects; /* of each part: the number of objects with bodies */
};

/* Lists the pairs of a scene whose bodies are all bounded. part_of has the part of
 * each object. Returns false if out of memory. */
bool overlaps_find(const struct scene *scene, const size_t *part_of, size_t part_count,
                   struct overlaps *overlaps);
void overlaps_free(struct overlaps *overlaps);

/* Writes the input of the program of overlaps, except the crossings. An error
 * makes the run fail. */
void overlaps_give(const struct overlaps *overlaps, struct single_run *run);

#endif
