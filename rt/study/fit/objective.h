/* objective.h - reports whether the written models meet the goals of the fit: all
 * times and speedups of Table 1 within 10 percent, if possible within 5; the
 * Livermore kernels within 10; every constant inside its bounds and within two
 * widths of its prior; and every row within 25 percent of the prediction of a fit
 * without it. */
#ifndef RT_FIT_OBJECTIVE_H
#define RT_FIT_OBJECTIVE_H

#include "base/command_output.h"
#include "rt/study/fit/study.h"

/* Prints the goals. `written` has the predictions of the models as written. */
void objective_print(const struct study *study, const double *written,
                     const struct command_output *results);

#endif
