/* report.h - what a study has found, as tables in print and as JSON.
 */
#ifndef RT_FIT_REPORT_H
#define RT_FIT_REPORT_H

#include "base/command_output.h"
#include "rt/study/fit/study.h"

/* written is what the model file predicts.  False: no memory. */
bool report_print(const struct study *study, const double *written,
                  const struct command_output *results);

#endif
