/* sweep_types.h - the sweep types: queue, pipes, hits, length. */
#ifndef RT_SWEEP_SWEEP_TYPES_H
#define RT_SWEEP_SWEEP_TYPES_H

#include "rt/study/sweep/sweep_report.h"

struct sweep_kind {
    const char *name;
    const char *title; /* title of the plot: "TITLE: target" */
    double angle;      /* default angle of view for a primitive */
    bool primitive_only;
    bool takes_lengths; /* uses sweep.lengths */
    /* Measures the points. On failure sets the error and returns false. */
    bool (*measure)(struct sweep *sweep, c205_error *error);
    /* Makes the report. On failure sets the error and returns false. */
    bool (*report)(struct sweep *sweep, struct sweep_report *report, c205_error *error);
};

extern const struct sweep_kind sweep_queue, sweep_pipes, sweep_hits, sweep_length;
/* All sweep types. The list ends with NULL. */
extern const struct sweep_kind *const sweep_kinds[];

/* ---- Queues and lengths -------------------------------------------------- */

/* sweep_lengths lists the user's lengths that are at most `most`, and returns their
 * number. The defaults are 1, 2, 4 .. 32,768, 65,535 and 2,000, the paper's length. */
enum { MAX_SWEEP_LENGTHS = 64 };
size_t sweep_lengths(const struct sweep *sweep, size_t most,
                     size_t lengths[MAX_SWEEP_LENGTHS]);

/* ---- Findings, also for tests -------------------------------------------- */

/* The memory that a program accesses: `fixed` words, and a_ray words for each ray of
 * its queue. They are computed from two frames that fit in one queue. */
struct sweep_memory {
    double a_ray, fixed; /* in words */
    size_t crossings;    /* number of words of a_ray for crossings, which scenes of
                          * solids store until the visible surface is known */
    double real;         /* real memory, in words */
    double fills;        /* number of rays in the queue that fills real memory */
};
bool sweep_memory(struct sweep *sweep, struct sweep_memory *memory, c205_error *error);

/* Returns the measure with the lowest cost per ray in queues. */
const struct sweep_measure *sweep_best(const struct sweep *sweep);
/* Returns the measure with this queue length, or NULL. */
const struct sweep_measure *sweep_with_queue(const struct sweep *sweep, size_t queue);

/* The findings of a sweep of lengths. 0: none. */
struct sweep_lengths_found {
    size_t crossover;   /* queues are faster from this length on, as far as measured */
    size_t checked;     /* All lengths from the length before the crossover up to this
                         * length were measured. 0: the length before was not measured,
                         * so the crossover may be earlier. */
    size_t half;        /* first length with half of the best speedup */
    bool half_is_exact; /* the length before `half` was measured */
    double best;
};
struct sweep_lengths_found sweep_find_lengths(const struct sweep *sweep);

#endif
