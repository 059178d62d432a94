/* written.h - a fitted model as a file, which says from what it was fitted and
 * how well.
 */
#ifndef RT_FIT_WRITTEN_H
#define RT_FIT_WRITTEN_H

#include "rt/fit/study.h"

/* Write the model to the path, whose file name begins with that of the model
 * from which the priors come.  Times in clk are whole clocks, as the clock of
 * the machine wants them.  False: the error says why. */
bool written_model(const struct study *study, const char *path,
                   c205_error *error);

/* What a model that was written shows of the observations of its machine; NaN
 * for the others. */
bool written_predict(const struct study *study, const char *path,
                     double predicted[FIT_OBSERVATIONS_MOST],
                     c205_error *error);

#endif
