/* provenance.h - reports the model of a result and its reliability. */
#ifndef BASE_PROVENANCE_H
#define BASE_PROVENANCE_H

#include <stdio.h>

#include "base/json.h"

/* Returns true if a constant of the model was fitted to published times (source F). */
bool provenance_is_fitted(const c205_model *model);

/* provenance_line writes one line with the largest error of a model: relative to the
 * published figures that it was fitted to, or else to those that it was only compared
 * with. If there are none, the line is a note. */
enum { PROVENANCE_LINE = 256 };
void provenance_line(const c205_model *model, char line[PROVENANCE_LINE]);

/* Returns the effects of the real machine that a model omits, as a text such as "a, b
 * and c". */
const char *provenance_left_out(const c205_model *model);

/* Prints one line below a table: the kind of the figures, the model, and the option
 * that prints more. If whole is set, it prints several lines: the comparison with
 * published figures, the omitted effects, and the sources of the constants. Each line
 * begins with the text `before`, for example "# ". */
void provenance_print(const c205_model *model, bool whole, const char *before,
                      FILE *file);
/* Writes the full provenance as the member "model". */
void provenance_json(const c205_model *model, struct json *json);

#endif
