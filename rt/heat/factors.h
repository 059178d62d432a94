/* factors.h - where the rays go that a primitive of a scene emits: shape factors,
 * and the areas of what is seen of it.
 *
 * A point that emission makes stays if the surface is seen there, that is if
 * its region has another value before it than behind it, and no other
 * body covers it; of the points that stay one ray goes out each, and what it meets first
 * receives it.  Points, rays and
 * all that is seen along them are the machine's, and so are which points stay, and the
 * counts and sums of weights by receiver: packet by packet, one of each repeat, in machines
 * of its own.  They do not depend on the form, the queue or the jobs; of the few sums the
 * host finds means and errors.
 * Source: docs/heat.md.
 */
#ifndef RT_FACTORS_H
#define RT_FACTORS_H

#include "base/accounts.h"
#include "rt/heat/emission.h"
#include "rt/heat/estimate.h"
#include "rt/trace/lines.h"

struct factors_options {
    enum trace_mode mode; /* TRACE_SCALAR or TRACE_VECTOR */
    size_t queue;         /* in vector mode: of points and of rays */
    size_t points;        /* of each repeat: 1 .. EMISSION_MOST; of the
                             lattice a power of two is best */
    size_t repeats;       /* 2 or more: their spread gives the errors */
    bool lattice;         /* .. under independent shifts; else random */
    uint64_t seed;
    size_t jobs; /* repeats at a time; 0: one */
    /* What receives as one: of each of the scene's primitives a number, below so many;
     * NULL: each for itself. */
    const size_t *receiver_of;
    size_t receivers;
    const c205_model *model; /* must outlive the factors */
};

/* Of one emitter. */
struct factor_row {
    struct estimate area;     /* seen of it, in the world */
    uint64_t tried, sent;     /* points, and the rays of those that stayed */
    size_t receivers;         /* all that receive, and the environment */
    uint64_t *count;          /* of rays, by receiver; their sum is sent */
    struct estimate *factor;  /* .. as a share of the area; their sum is 1 */
    struct accounts accounts; /* of all machines */
};
void factor_row_free(struct factor_row *row);

struct factors;

/* NULL: options that cannot be, no memory; the error says why.  The scene must outlive
 * the factors. */
struct factors *factors_new(const struct scene *scene,
                            const struct factors_options *options,
                            c205_error *error);
void factors_free(struct factors *factors);

/* Those from a primitive, 0 .., on its outward side.  False: it has no emission, a
 * trap, no memory; the row is empty then. */
bool factors_find(const struct factors *factors, size_t primitive,
                  struct factor_row *row, c205_error *error);

#endif
