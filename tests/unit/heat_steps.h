/* heat_steps.h - checks that the clocks of all steps of a heat computation sum to its
 * total clocks. Also compares estimates with known values. */
#ifndef TESTS_HEAT_STEPS_H
#define TESTS_HEAT_STEPS_H

#include <math.h>

#include "rt/heat/estimate.h"
#include "rt/heat/step.h"
#include "tests/unit/unit.h"

static inline bool are_steps(const uint64_t clocks[HEAT_STEPS],
                             const struct accounts *accounts)
{
    uint64_t sum = 0;
    for (int i = 0; i < HEAT_STEPS; i++)
        sum += clocks[i];
    return clocks[STEP_EMISSION] > 0 && clocks[STEP_CROSSINGS] > 0
           && clocks[STEP_COUNTS] > 0 && sum == accounts->clocks;
}

/* Fails unless an estimate is near its expected value. The error is estimated from 16
 * repeats; 4.6 such errors are as rare as 4 standard deviations of a normal
 * distribution. */
static inline void assert_estimate(const char *what, struct estimate found,
                                   double expected)
{
    if (!(fabs(found.value - expected) <= 4.6 * found.error + 1e-9 * fabs(expected)))
        fail_msg("%s: %g +- %g is not %g", what, found.value, found.error, expected);
}

#endif
