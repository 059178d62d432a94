/* model_writer.h - writes a fitted model to a file, with the observations that it
 * was fitted to and their errors. */
#ifndef RT_FIT_MODEL_WRITER_H
#define RT_FIT_MODEL_WRITER_H

#include "rt/study/fit/study.h"

/* Returns true if written_model could write to the path. It is called before the
 * study starts. Returns false with the reason in the error. */
bool written_check(const struct study *study, const char *path, c205_error *error);

/* Predicts the observations with the constants as written. Times in clk are
 * rounded to whole clocks, as the machine's clock needs them. */
bool written_predict(const struct study *study, double predicted[MAX_FIT_OBSERVATIONS],
                     c205_error *error);

/* Writes the model to the path, with the errors of these predictions. Returns
 * false with the reason in the error. */
bool written_model(const struct study *study,
                   const double predicted[MAX_FIT_OBSERVATIONS], const char *path,
                   c205_error *error);

#endif
