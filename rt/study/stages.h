/* stages.h - what each step of a computation takes in its three stages: scalar; as in 1984,
 * vector kernels in scalar programs; vector. */
#ifndef RT_STAGES_H
#define RT_STAGES_H

#include "base/table.h"
#include "rt/trace/trace.h"

enum { MAX_STAGES_STEPS = 8 };

/* Clocks of each stage, which its mode is the number of, by steps. */
struct stages {
    size_t step_count;
    const char *steps[MAX_STAGES_STEPS];
    uint64_t clocks[TRACE_MODES][MAX_STAGES_STEPS];
};

/* What a computation takes in another mode, step by step; *same: it finds the same as the one
 * whose clocks are there.  False: it fails; the error says why. */
typedef bool stages_function(const void *found, enum trace_mode mode,
                             uint64_t clocks[MAX_STAGES_STEPS], bool *same,
                             c205_error *error);

/* All stages but that of one mode, whose clocks are there.  False: one fails, or finds
 * something else; the error says which. */
bool stages_find(struct stages *stages, enum trace_mode there, stages_function *find,
                 const void *found, c205_error *error);

uint64_t stages_clocks(const struct stages *stages, enum trace_mode mode);
/* Step by step, then all of them: clocks, and how many times those of the scalar stage are
 * these.  NULL: no memory. */
struct table *stages_table(const struct stages *stages);

#endif
