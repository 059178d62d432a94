/* provenance.h - which model a result comes from, and how far to trust it. */
#ifndef BASE_PROVENANCE_H
#define BASE_PROVENANCE_H

#include <stdio.h>

#include "base/json.h"

/* Whether a fit has moved any of its constants (source F). */
bool provenance_is_fitted(const c205_model *model);

/* In one line, where there is no room for more: how near a model came to what
 * it was fitted to; or else compared with; or that nothing is known of that. */
enum { PROVENANCE_LINE = 256 };
void provenance_line(const c205_model *model, char line[PROVENANCE_LINE]);

/* What a model leaves out of the time: "this, that and that". */
const char *provenance_left_out(const c205_model *model);

/* With every table, in one line: what its figures are, on which model, and
 * where to read on.  Or whole, in several: how near the model came to published
 * figures, what it leaves out, and from where its constants are.  Each line
 * is behind a text of the caller's ("# ", say). */
void provenance_print(const c205_model *model, bool whole, const char *before,
                      FILE *file);
/* All of that as the member "model". */
void provenance_json(const c205_model *model, struct json *json);

#endif
