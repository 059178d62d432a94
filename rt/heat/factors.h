/* factors.h - where the rays go that a primitive of a scene emits: shape factors,
 * and the areas of what is seen of it.
 *
 * A packet is one repeat of an emitter, or a piece of it: its points, which of these are seen, and what
 * receives the rays that go out from them.  All of that, and the counts and sums of weights
 * by receiver, are the machine's: packet by packet, in machines of its own, by a
 * job set.  They do not depend on the form,
 * the queue, the jobs or the ranks; of the few sums the host finds means and errors.
 * Source: docs/heat.md.
 */
#ifndef RT_FACTORS_H
#define RT_FACTORS_H

#include "base/accounts.h"
#include "rt/jobs/job_set.h"
#include "rt/heat/emission.h"
#include "rt/heat/estimate.h"
#include "rt/heat/step.h"
#include "rt/trace/ray_query.h"

/* Of a repeat; more than a vector holds are found in pieces. */
enum { MAX_FACTORS_POINTS = 1 << 20 };

struct factors_options {
    enum trace_mode mode;
    size_t queue;   /* in vector mode: of points and of rays */
    size_t points;  /* of each repeat: 1 .. MAX_FACTORS_POINTS; of the
                             lattice a power of two is best */
    size_t repeats; /* 2 or more: their spread gives the errors */
    bool lattice;   /* .. under independent shifts; else random */
    uint64_t seed;
    size_t jobs;             /* packets at a time; 0: one */
    struct job_set *job_set; /* as in job_set_work */
    /* Asked now and then, with packets; false: stop.  NULL: nobody wants to know. */
    bool (*progress)(void *context, size_t done, size_t all);
    void *context;
    /* What receives as one: of each of the scene's primitives a number, below so many;
     * NULL: each for itself. */
    const size_t *receiver_of;
    size_t receivers;
    const c205_model *model; /* must outlive the factors */
};

/* Of one emitter. */
struct factor_row {
    struct estimate area;        /* seen of it, in the world */
    uint64_t tried, sent;        /* points, and the rays of those that stayed */
    size_t receivers;            /* all that receive, and the environment */
    uint64_t *count;             /* of rays, by receiver; their sum is sent */
    struct estimate *factor;     /* .. as a share of the area; their sum is 1 */
    struct accounts accounts;    /* of all machines */
    uint64_t clocks[HEAT_STEPS]; /* .. of them */
};
void factor_row_free(struct factor_row *row);

struct factors;

/* NULL: options that cannot be, no memory; the error says why.  The scene must outlive
 * the factors. */
struct factors *factors_new(const struct scene *scene,
                            const struct factors_options *options, c205_error *error);
void factors_free(struct factors *factors);

/* Those from so many primitives, numbers of the scene's from 0 on, on their outward sides:
 * rows, which the caller frees.  Where the job set does not collect packets
 * (job_set_collects), the rows stay empty.  False: one has no emission, a trap, no memory, a
 * file of another run; the rows are empty then. */
bool factors_find(const struct factors *factors, const size_t *emitters, size_t count,
                  struct factor_row *rows, c205_error *error);
/* Packets of so many emitters. */
size_t factors_units(const struct factors *factors, size_t count);

#endif
