/* step.c - names the steps of a heat computation, and sums the clocks of each step. */
#include "rt/heat/step.h"

static const char *const names[HEAT_STEPS] = {
    [STEP_EMISSION] = "emission",   [STEP_FACES] = "faces",
    [STEP_CROSSINGS] = "crossings", [STEP_COUNTS] = "counts",
    [STEP_SMOOTHING] = "smoothing", [STEP_EXCHANGE] = "exchange",
};

const char *heat_step_name(enum heat_step step)
{
    return names[step];
}

void heat_charge(uint64_t clocks[HEAT_STEPS], const struct accounts *accounts,
                 enum heat_step step)
{
    uint64_t charged = 0;
    for (int i = 0; i < HEAT_STEPS; i++)
        charged += clocks[i];
    clocks[step] += accounts->clocks - charged;
}
