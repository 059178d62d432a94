/* objective.h - reports whether the written models meet the goals of the fit. The goals
 * are:
 *
 * - all times and speedups of Table 1 are within 10 percent, if possible within 5;
 * - the Livermore kernels are within 10 percent;
 * - every constant is inside its bounds, and within two widths of its prior;
 * - every row is within 25 percent of the prediction of a fit without the row. */
#ifndef RT_FIT_OBJECTIVE_H
#define RT_FIT_OBJECTIVE_H

#include "base/command_output.h"
#include "rt/study/fit/study.h"

/* Prints the goals. `written` has the predictions of the models as they are written. */
void objective_print(const struct study *study, const double *written,
                     const struct command_output *results);

#endif
