/* goal.h - what the fit is asked to reach, and whether it does: all times and
 * speedups of Table 1 within 5 percent, every constant inside its bounds and
 * within two widths of its prior, rows left out within 25 percent.
 */
#ifndef RT_FIT_GOAL_H
#define RT_FIT_GOAL_H

#include "base/results.h"
#include "rt/study/fit/study.h"

void goal_tell(const struct study *study, const struct results *results);

#endif
