/* iterations.h - counts the steps of the root solver's refinement.
 *
 * It is a listener of the machine's events. It finds the labels of falsi_scalar.s and
 * falsi_vector.s, and reads the registers there. It costs the machine no clocks.
 */
#ifndef RT_ITERATIONS_H
#define RT_ITERATIONS_H

#include "rt/trace/observer.h"

enum stage { STAGE_SLOPE, STAGE_VALUE, STAGES };
const char *stage_name(enum stage stage);

enum { MAX_ITERATIONS = 128 };

/* The counts of one stage: roots of f' (knots), or of f. */
struct stage_count {
    uint64_t brackets; /* refined brackets */
    uint64_t passes;   /* of the loop over all its lanes */
    uint64_t steps;    /* of unfinished brackets */
    uint64_t lanes;    /* in the loop, summed over the passes */
    uint64_t halvings; /* of exponents of wide brackets, before the refinement */
    /* By pass of a refinement, from 0: active brackets, and lanes in the loop. */
    uint64_t active[MAX_ITERATIONS], in_loop[MAX_ITERATIONS];
};

struct iterations {
    bool vector; /* the form of the program */
    struct stage_count stage[STAGES];
    /* Private to iterations.c. */
    struct stage_labels {
        uint64_t begin, wide, step, midpoint, left;
    } labels[STAGES];
    size_t pass;     /* of the current refinement */
    uint64_t active; /* active brackets in it */
};

/* A c205_listener whose context is a struct iterations. */
void iterations_listen(void *iterations, const c205 *machine, const c205_event *event);
/* Sets all counts to 0 and looks up the labels of a program in the vector or
 * scalar form. Returns false if the program lacks a label. */
bool iterations_begin(struct iterations *iterations, const struct object *program,
                      bool vector);
/* Returns an observer that adds up all bands of a frame. The caller sets the sum
 * to zero, except for its form. */
struct observer iterations_observer(struct iterations *sum);

#endif
