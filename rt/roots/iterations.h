/* iterations.h - counts the steps of the root solver's refinement.
 *
 * The counter listens to the events of the machine, and reads registers at the labels
 * of falsi_scalar.s and falsi_vector.s. This costs the machine no clocks.
 */
#ifndef RT_ITERATIONS_H
#define RT_ITERATIONS_H

#include "rt/trace/observer.h"

enum stage { STAGE_SLOPE, STAGE_VALUE, STAGES };
const char *stage_name(enum stage stage);

enum { MAX_ITERATIONS = 128 };

/* The counts of one stage of the root solver. The first stage finds the roots of the
 * derivative f', and the second stage the roots of f. */
struct stage_count {
    uint64_t brackets; /* number of refined brackets */
    uint64_t passes;   /* number of passes of the loop over all lanes */
    uint64_t steps;    /* number of steps of unfinished brackets */
    uint64_t lanes;    /* number of lanes in the loop, summed over the passes */
    uint64_t halvings; /* number of times that exponents of wide brackets are halved,
                        * before the refinement */
    /* Counts for each pass of the refinement: the active brackets, and the lanes in the
     * loop. */
    uint64_t active[MAX_ITERATIONS], in_loop[MAX_ITERATIONS];
};

struct iterations {
    bool vector; /* the program has the vector form */
    struct stage_count stage[STAGES];
    /* The following members are private to iterations.c. */
    struct stage_labels {
        uint64_t begin, wide, step, midpoint, left;
    } labels[STAGES];
    size_t pass;     /* current pass of the refinement */
    uint64_t active; /* number of active brackets in the pass */
};

/* A c205_listener whose context is a struct iterations. */
void iterations_listen(void *iterations, const c205 *machine, const c205_event *event);
/* Sets all counts to 0. Looks up the labels of a program in the vector or scalar form.
 * Returns false if a label is missing. */
bool iterations_begin(struct iterations *iterations, const struct object *program,
                      bool vector);
/* Returns an observer that adds the counts of all bands of a frame to `sum`. Before the
 * run the caller sets sum->vector, and all other members to zero. */
struct observer iterations_observer(struct iterations *sum);

#endif
