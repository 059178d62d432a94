/* factors.h - computes shape factors from the rays that primitives emit. Also computes
 * the areas of the visible parts of the primitives.
 *
 * A packet is one repeat of an emitter, or a piece of a repeat. It consists of the
 * emitter's points, the visible points among them, and the receivers of the rays from
 * the visible points. Machines compute the packets, including the counts of rays and
 * the sums of weights for each receiver. A packet is a unit of a job set. The results
 * do not depend on the form, the queue length, the number of jobs or the number of
 * ranks. The host computes means and errors from the sums. Source: docs/heat.md.
 */
#ifndef RT_FACTORS_H
#define RT_FACTORS_H

#include "base/accounts.h"
#include "rt/heat/emission.h"
#include "rt/heat/estimate.h"
#include "rt/heat/sampling.h"
#include "rt/heat/step.h"
#include "rt/trace/ray_query.h"

/* The largest number of points of a repeat. A repeat with more points than a vector can
 * have is divided into pieces. */
enum { MAX_FACTORS_POINTS = 1 << 20 };

/* The factors from one emitter. */
struct factor_row {
    struct estimate area;        /* area of the visible part, in world space */
    uint64_t tried, sent;        /* number of points, and of rays from visible points */
    size_t receivers;            /* number of receivers, including the environment */
    uint64_t *count;             /* number of rays for each receiver; their sum is
                                  * `sent` */
    struct estimate *factor;     /* factor for each receiver; their sum is 1 */
    struct accounts accounts;    /* accounts of all machines */
    uint64_t clocks[HEAT_STEPS]; /* clocks of all machines for each step */
};
void factor_row_free(struct factor_row *row);

struct factors;

/* Prepares the computation of factors. Returns NULL with the error for invalid options,
 * or if out of memory. The scene must outlive the factors. */
struct factors *factors_new(const struct scene *scene,
                            const struct sampling_options *options, c205_error *error);
void factors_free(struct factors *factors);

/* Computes a row for each emitter, which is an index of a primitive. Rays leave on the
 * outward side. The caller frees the rows. If this process does not collect results
 * (job_set_collects), the rows stay empty. If a primitive has no emission, after a
 * trap, if out of memory, or if a file belongs to another run, returns false, and the
 * rows are empty. */
bool factors_find(const struct factors *factors, const size_t *emitters, size_t count,
                  struct factor_row *rows, c205_error *error);
/* Returns the number of packets of count emitters. */
size_t factors_units(const struct factors *factors, size_t count);

#endif
