/* model_writer.h - a fitted model as a file, which says from what it was fitted and
 * how well.
 */
#ifndef RT_FIT_MODEL_WRITER_H
#define RT_FIT_MODEL_WRITER_H

#include "rt/study/fit/study.h"

/* Whether written_model could write there: asked before the study is made.
 * False: the error says why not. */
bool written_check(const struct study *study, const char *path, c205_error *error);

/* What the machine shows of the observations with the constants as they are
 * written: times in clk are whole clocks, as its clock wants them. */
bool written_predict(const struct study *study, double predicted[MAX_FIT_OBSERVATIONS],
                     c205_error *error);

/* Write the model to the path, and how near it comes by what it predicts.
 * False: the error says why. */
bool written_model(const struct study *study,
                   const double predicted[MAX_FIT_OBSERVATIONS], const char *path,
                   c205_error *error);

#endif
