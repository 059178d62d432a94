/* model_writer.h - writes a fitted model to a file, with its observations and their
 * errors. */
#ifndef RT_FIT_MODEL_WRITER_H
#define RT_FIT_MODEL_WRITER_H

#include "rt/study/fit/study.h"

/* Checks, before the study starts, that written_model can write to the path. On failure
 * sets the error and returns false. */
bool written_check(const struct study *study, const char *path, c205_error *error);

/* Predicts the observations with the constants of the written model. Constants in clk
 * are rounded to whole clocks, because the machine needs whole clocks. */
bool written_predict(const struct study *study, double predicted[MAX_FIT_OBSERVATIONS],
                     c205_error *error);

/* Writes the fitted model to the path, with the error of each prediction in
 * `predicted`. On failure sets the error and returns false. */
bool written_model(const struct study *study,
                   const double predicted[MAX_FIT_OBSERVATIONS], const char *path,
                   c205_error *error);

#endif
