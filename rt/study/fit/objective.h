/* objective.h - what the fit is asked to reach, and whether the models as they are
 * written do: all times and speedups of Table 1 within 10 percent, if it can be
 * within 5, the Livermore kernels within 10, every constant inside its bounds
 * and within two widths of its prior, every row within 25 percent of what a fit
 * without it tells.
 */
#ifndef RT_FIT_OBJECTIVE_H
#define RT_FIT_OBJECTIVE_H

#include "base/command_output.h"
#include "rt/study/fit/study.h"

/* written: what the models predict as they are written. */
void objective_print(const struct study *study, const double *written,
                     const struct command_output *results);

#endif
