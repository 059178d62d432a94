/* hits.h - computes the fraction of a surface's radiation that strikes a set of
 * cylinders. A ray only reports whether it strikes one. This is the case of the paper
 * of 1984.
 *
 * The emitter radiates from all of its points. The cylinders are the only obstacles.
 * They are solid, and each cylinder is an object or an element of a top-level union.
 */
#ifndef RT_HITS_H
#define RT_HITS_H

#include "rt/heat/factors.h"
#include "rt/scene/named_parts.h"

struct hits_options {
    enum trace_mode mode; /* scalar or vector */
    size_t queue;         /* number of rays in a queue; vector mode only */
    size_t points, repeats;
    bool lattice;
    uint64_t seed;
    const char *from; /* name of the part or material that emits */
    const c205_model *model;
    const c205_model *projection; /* another machine, for which the scalar form is
                                   * projected; NULL: none */
};

struct hits {
    struct estimate factor;
    uint64_t rays, struck;
    size_t cylinders;
    struct accounts accounts; /* accounts of only the program that decides which rays
                               * strike */
    uint64_t projected;       /* clocks of this program on the other machine */
};

/* Computes the fraction of the radiation that strikes the cylinders, and its error.
 * Returns false with the error if nothing has the name options->from, if a shape cannot
 * emit or is not a cylinder, after a trap, or if out of memory. */
bool hits_find(const struct scene *scene, const struct named_parts *parts,
               const struct hits_options *options, struct hits *hits,
               c205_error *error);
void hits_free(struct hits *hits);

#endif
