/* provenance.h - which model a result comes from, and how far to trust it. */
#ifndef ASM_PROVENANCE_H
#define ASM_PROVENANCE_H

#include "asm/json.h"

/* Whether a fit has moved any of its constants (source F). */
bool provenance_is_fitted(const c205_model *model);

/* A sentence on that. */
const char *provenance_note(const c205_model *model);

/* "model cyber205-2pipe: 80 constants, unfitted priors: 3 P, 2 S .." on
 * stdout. */
void provenance_print(const c205_model *model);
/* The same as the member "model". */
void provenance_json(const c205_model *model, struct json *json);

#endif
