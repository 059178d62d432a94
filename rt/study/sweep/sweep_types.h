/* sweep_types.h - what can be swept: queue, pipes, hits, length. */
#ifndef RT_SWEEP_SWEEP_TYPES_H
#define RT_SWEEP_SWEEP_TYPES_H

#include "rt/study/sweep/report.h"

struct sweep_kind {
    const char *name;
    const char *title; /* of a plot: "TITLE: target" */
    double angle;      /* of a primitive's view, unless the user's */
    bool primitive_only;
    bool takes_lengths; /* sweep.lengths */
    /* Run the points.  False: the error says why. */
    bool (*measure)(struct sweep *sweep, c205_error *error);
    /* What they show.  False: no memory, or the error says why. */
    bool (*report)(struct sweep *sweep, struct sweep_report *report, c205_error *error);
};

extern const struct sweep_kind sweep_queue, sweep_pipes, sweep_hits, sweep_length;
/* All of them; NULL at the end. */
extern const struct sweep_kind *const sweep_kinds[];

/* ---- Queues and lengths -------------------------------------------------- */

/* The user's, or else 1, 2, 4 .. 32,768, 65,535 and the paper's 2,000, as far
 * as they are at most most. */
enum { MAX_SWEEP_LENGTHS = 64 };
size_t sweep_lengths(const struct sweep *sweep, size_t most,
                     size_t lengths[MAX_SWEEP_LENGTHS]);

/* ---- Findings, for their tests ------------------------------------------- */

/* Words of memory that a queue takes, from what frames that are one queue
 * touch, in the smallest pages. */
struct sweep_memory {
    double a_ray, fixed; /* words */
    size_t crossings;    /* of a ray, kept for the visible surface: words
                                 of a_ray, in scenes of solids */
    double real;         /* words of real memory */
    double fills;        /* rays of the queue that fills it */
};
bool sweep_memory(struct sweep *sweep, struct sweep_memory *memory, c205_error *error);

/* The measure whose rays cost least in queues. */
const struct sweep_measure *sweep_best(const struct sweep *sweep);
/* The measure with that queue, or NULL. */
const struct sweep_measure *sweep_with_queue(const struct sweep *sweep, size_t queue);

/* Of a sweep of lengths.  0: there is none. */
struct sweep_lengths_found {
    size_t crossover;   /* from this length on queues are cheaper, as far as
                           they were measured */
    size_t checked;     /* no length from the one before the crossover to here
                           was left out; 0: that one was, so that the crossover
                           may lie before */
    size_t half;        /* the first that has half of the best speedup */
    bool half_is_exact; /* the length before it has been measured */
    double best;
};
struct sweep_lengths_found sweep_find_lengths(const struct sweep *sweep);

#endif
