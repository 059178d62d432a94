/* provenance.h - reports the model of a result and its reliability. */
#ifndef BASE_PROVENANCE_H
#define BASE_PROVENANCE_H

#include <stdio.h>

#include "base/json.h"

/* Returns true if a fit changed a constant of the model (source F). */
bool provenance_is_fitted(const c205_model *model);

/* Writes one line on the error of a model: the largest error relative to the figures of
 * the fit, or else relative to other figures, or a note that there was no
 * comparison. */
enum { PROVENANCE_LINE = 256 };
void provenance_line(const c205_model *model, char line[PROVENANCE_LINE]);

/* Returns the effects of the real machine that a model omits, as in "this, that and
 * that". */
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
