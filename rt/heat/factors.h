/* factors.h - computes shape factors by tracing the rays that primitives emit, and
 * the areas of their visible parts.
 *
 * A packet is one repeat of an emitter, or a piece of a repeat: its points, the
 * visible ones among them, and the receivers of the rays from these. Machines
 * compute all of this, including the counts and sums of weights by receiver,
 * packet by packet, as the units of a job set. The results do not depend on the form,
 * the queue, the jobs or the ranks. The host computes means and errors from the
 * sums. Source: docs/heat.md.
 */
#ifndef RT_FACTORS_H
#define RT_FACTORS_H

#include "base/accounts.h"
#include "rt/heat/emission.h"
#include "rt/heat/estimate.h"
#include "rt/heat/sampling.h"
#include "rt/heat/step.h"
#include "rt/trace/ray_query.h"

/* Points of a repeat. A repeat with more points than a vector holds is divided
 * into pieces. */
enum { MAX_FACTORS_POINTS = 1 << 20 };

/* The factors from one emitter. */
struct factor_row {
    struct estimate area;        /* of the visible part, in the world */
    uint64_t tried, sent;        /* points, and the rays of the visible points */
    size_t receivers;            /* number of receivers, including the environment */
    uint64_t *count;             /* rays by receiver; their sum is sent */
    struct estimate *factor;     /* by receiver; their sum is 1 */
    struct accounts accounts;    /* of all machines */
    uint64_t clocks[HEAT_STEPS]; /* the clocks of these machines, by step */
};
void factor_row_free(struct factor_row *row);

struct factors;

/* Returns NULL for invalid options, or if out of memory; the error gives the
 * reason. The scene must outlive the factors. */
struct factors *factors_new(const struct scene *scene,
                            const struct sampling_options *options, c205_error *error);
void factors_free(struct factors *factors);

/* Computes a row for each emitter, which is an index of the scene's primitives;
 * rays leave on the outward side. The caller frees the rows. If the job set does not
 * collect packets (job_set_collects), the rows stay empty. Returns false, with empty
 * rows, if a primitive has no emission, after a trap, if out of memory, or if a
 * file belongs to another run. */
bool factors_find(const struct factors *factors, const size_t *emitters, size_t count,
                  struct factor_row *rows, c205_error *error);
/* Returns the number of packets for count emitters. */
size_t factors_units(const struct factors *factors, size_t count);

#endif
