/* stages.h - the cost of each step of a computation in its three stages: scalar;
 * vector kernels in scalar programs, as in 1984; vector. */
#ifndef RT_STAGES_H
#define RT_STAGES_H

#include "base/table.h"
#include "rt/trace/trace.h"

enum { MAX_STAGES_STEPS = 8 };

/* The clocks by stage and step. A stage has the number of its mode. */
struct stages {
    size_t step_count;
    const char *steps[MAX_STAGES_STEPS];
    uint64_t clocks[TRACE_MODES][MAX_STAGES_STEPS];
};

/* Runs a computation in another mode and sets its clocks by step. Sets *same to
 * whether it has the same result as `found`. Returns false with the reason in the
 * error. */
typedef bool stages_function(const void *found, enum trace_mode mode,
                             uint64_t clocks[MAX_STAGES_STEPS], bool *same,
                             c205_error *error);

/* Runs all stages except that of the mode `there`, whose clocks are set. Returns false
 * with the reason in the error if one fails or has a different result. */
bool stages_find(struct stages *stages, enum trace_mode there, stages_function *find,
                 const void *found, c205_error *error);

uint64_t stages_clocks(const struct stages *stages, enum trace_mode mode);
/* Returns a table with a row for each step and one for all: the clocks, and the
 * speedups between stages. Returns NULL if out of memory. */
struct table *stages_table(const struct stages *stages);

#endif
