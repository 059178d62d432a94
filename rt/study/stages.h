/* stages.h - compares the cost of each step of a computation in its three stages:
 * scalar; vector kernels in scalar programs, as in 1984; vector. */
#ifndef RT_STAGES_H
#define RT_STAGES_H

#include "base/table.h"
#include "rt/trace/trace.h"

enum { MAX_STAGES_STEPS = 8 };

/* The clocks of each step in each stage. The number of a stage is its mode. */
struct stages {
    size_t step_count;
    const char *steps[MAX_STAGES_STEPS];
    uint64_t clocks[TRACE_MODES][MAX_STAGES_STEPS];
};

/* Runs a computation in another mode, and sets the clocks of its steps. Sets *same to
 * true if its result equals `found`. On failure sets the error and returns false. */
typedef bool stages_function(const void *found, enum trace_mode mode,
                             uint64_t clocks[MAX_STAGES_STEPS], bool *same,
                             c205_error *error);

/* Runs all stages except `there`, whose clocks and result are known. If a stage fails
 * or has a different result, sets the error and returns false. */
bool stages_find(struct stages *stages, enum trace_mode there, stages_function *find,
                 const void *found, c205_error *error);

uint64_t stages_clocks(const struct stages *stages, enum trace_mode mode);
/* Returns a table of clocks and speedups. It has a row for each step and a row for
 * their sum. Returns NULL if out of memory. */
struct table *stages_table(const struct stages *stages);

#endif
