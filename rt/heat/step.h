/* step.h - the steps of a heat computation, and the clocks of each step. The first
 * steps are repeated for each packet of rays or lines, and the last two follow all
 * packets. */
#ifndef RT_HEAT_STEP_H
#define RT_HEAT_STEP_H

#include "base/accounts.h"

enum heat_step {
    STEP_EMISSION,  /* generates points and directions */
    STEP_FACES,     /* selects the points on visible faces; only for rays */
    STEP_CROSSINGS, /* computes the crossings of rays or lines */
    STEP_COUNTS,    /* counts by receiver, or by pair of surfaces */
    STEP_SMOOTHING, /* if requested */
    STEP_EXCHANGE,  /* if requested */
    HEAT_STEPS
};
const char *heat_step_name(enum heat_step step);

/* Attributes to `step` the clocks by which the accounts have grown since the previous
 * call. All elements of `clocks` must be zero before the first call. */
void heat_charge(uint64_t clocks[HEAT_STEPS], const struct accounts *accounts,
                 enum heat_step step);

#endif
