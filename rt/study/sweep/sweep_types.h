/* sweep_types.h - the kinds of sweep: queue, pipes, hits, length. */
#ifndef RT_SWEEP_SWEEP_TYPES_H
#define RT_SWEEP_SWEEP_TYPES_H

#include "rt/study/sweep/sweep_report.h"

struct sweep_kind {
    const char *name;
    const char *title; /* of a plot: "TITLE: target" */
    double angle;      /* of a primitive's view, unless the user sets it */
    bool primitive_only;
    bool takes_lengths; /* sweep.lengths */
    /* Measures the points. Returns false with the reason in the error. */
    bool (*measure)(struct sweep *sweep, c205_error *error);
    /* Makes the report. Returns false if out of memory, or with the reason in the
     * error. */
    bool (*report)(struct sweep *sweep, struct sweep_report *report, c205_error *error);
};

extern const struct sweep_kind sweep_queue, sweep_pipes, sweep_hits, sweep_length;
/* All kinds, ending with NULL. */
extern const struct sweep_kind *const sweep_kinds[];

/* ---- Queues and lengths -------------------------------------------------- */

/* Lists the user's lengths, or by default 1, 2, 4 .. 32,768, 65,535 and the
 * paper's 2,000, those of them that are at most `most`. */
enum { MAX_SWEEP_LENGTHS = 64 };
size_t sweep_lengths(const struct sweep *sweep, size_t most,
                     size_t lengths[MAX_SWEEP_LENGTHS]);

/* ---- Findings, also for tests -------------------------------------------- */

/* The memory that a queue takes, derived from frames of one queue in the smallest
 * pages. */
struct sweep_memory {
    double a_ray, fixed; /* words */
    size_t crossings;    /* words of a_ray for crossings, which are stored until the
                          * visible surface is known; in scenes of solids */
    double real;         /* words of real memory */
    double fills;        /* rays of the queue that fills it */
};
bool sweep_memory(struct sweep *sweep, struct sweep_memory *memory, c205_error *error);

/* Returns the measure with the lowest cost of a ray in queues. */
const struct sweep_measure *sweep_best(const struct sweep *sweep);
/* Returns the measure with that queue, or NULL. */
const struct sweep_measure *sweep_with_queue(const struct sweep *sweep, size_t queue);

/* The findings of a sweep of lengths; 0: none. */
struct sweep_lengths_found {
    size_t crossover;   /* queues are faster from this length on, as far as measured */
    size_t checked;     /* all lengths from the one before the crossover to this one
                         * were measured; 0: the one before was not, so the crossover
                         * may be earlier */
    size_t half;        /* the first length with half of the best speedup */
    bool half_is_exact; /* the length before it was measured */
    double best;
};
struct sweep_lengths_found sweep_find_lengths(const struct sweep *sweep);

#endif
