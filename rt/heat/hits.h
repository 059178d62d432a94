/* hits.h - which share of what a surface radiates strikes some cylinders, by rays of which
 * nothing is asked but whether they strike: the case of the paper of 1984.
 *
 * All that emits radiates from all of its points, and nothing but the cylinders is in the
 * way: solid ones, each an object of its own, or one of a union that stands by itself.
 */
#ifndef RT_HITS_H
#define RT_HITS_H

#include "rt/heat/factors.h"
#include "rt/scene/scene_internal.h"

struct hits_options {
    enum trace_mode mode; /* scalar or vector */
    size_t queue;         /* rays against a cylinder; vector mode only */
    size_t points, repeats;
    bool lattice;
    uint64_t seed;
    const char *from; /* the part or material that emits */
    const c205_model *model;
    const c205_model *projection; /* of another machine, for the scalar
                                     form; NULL: none */
};

struct hits {
    struct estimate factor;
    uint64_t rays, struck;
    size_t cylinders;
    struct accounts accounts; /* of what tells whether they strike, alone */
    uint64_t projected;       /* its clocks on the other machine */
};

/* False: nobody of that name; what cannot emit, or be struck; a trap, no memory: the error
 * says which. */
bool hits_find(const struct scene *scene, const struct named_parts *parts,
               const struct hits_options *options, struct hits *hits,
               c205_error *error);
void hits_free(struct hits *hits);

#endif
