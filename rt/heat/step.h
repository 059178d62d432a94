/* step.h - the steps of a packet of rays or lines, and of what follows all packets. */
#ifndef RT_HEAT_STEP_H
#define RT_HEAT_STEP_H

#include "base/accounts.h"

enum heat_step {
    STEP_EMISSION,  /* points and directions are made */
    STEP_FACES,     /* which points are on faces that are seen; not of lines */
    STEP_CROSSINGS, /* what is seen along the rays, or lines */
    STEP_COUNTS,    /* .. is counted by receivers, or by pairs of surfaces */
    STEP_SMOOTHING, /* if asked */
    STEP_EXCHANGE,  /* if asked */
    HEAT_STEPS
};
const char *heat_step_name(enum heat_step step);

/* To a step, what the machines of the accounts took since the step before; clocks are
 * zeros at first. */
void heat_charge(uint64_t clocks[HEAT_STEPS], const struct accounts *accounts,
                 enum heat_step step);

#endif
