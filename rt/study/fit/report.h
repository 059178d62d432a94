/* report.h - what a study has found, as tables in print and as JSON.
 */
#ifndef RT_FIT_REPORT_H
#define RT_FIT_REPORT_H

#include <stdio.h>

#include "base/json.h"
#include "rt/study/fit/study.h"

/* False: no memory, or a write error.  json may be NULL; written is what the
 * model file predicts, or NULL. */
bool report_print(const struct study *study, const double *written,
                  FILE *file, struct json *json);

#endif
