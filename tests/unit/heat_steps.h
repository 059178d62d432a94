/* heat_steps.h - checks that the steps of a heat computation sum to all its clocks. */
#ifndef TESTS_HEAT_STEPS_H
#define TESTS_HEAT_STEPS_H

#include "rt/heat/step.h"

static inline bool are_steps(const uint64_t clocks[HEAT_STEPS],
                             const struct accounts *accounts)
{
    uint64_t sum = 0;

    for (int i = 0; i < HEAT_STEPS; i++)
        sum += clocks[i];
    return clocks[STEP_EMISSION] > 0 && clocks[STEP_CROSSINGS] > 0
           && clocks[STEP_COUNTS] > 0 && sum == accounts->clocks;
}

#endif
