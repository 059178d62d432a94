/* fit_report.h - prints the results of a study as tables and as JSON. */
#ifndef RT_FIT_REPORT_H
#define RT_FIT_REPORT_H

#include "base/command_output.h"
#include "rt/study/fit/study.h"

/* Prints the report. `written` has the predictions of the model as written to its file.
 * Returns false if out of memory. */
bool report_print(const struct study *study, const double *written,
                  const struct command_output *results);

#endif
