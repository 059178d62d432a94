/* scene_operand.h - the operands of expressions. */
#ifndef RT_SCENE_OPERAND_H
#define RT_SCENE_OPERAND_H

#include "rt/scene/language/reader.h"

/* Reads primary { "." component }, in the grammar of expression.c. */
bool operand_read(struct reader *reader, struct numbers *value);
/* Reads a call of the spline that the current token names: NAME(t) or NAME(t, kind). */
bool spline_call(struct reader *reader, struct numbers *value);

/* Report an error at the token if the value is not a float, or is not finite: after an
 * overflow, or for an argument outside of a function's domain. */
bool operand_float(struct reader *reader, const struct scene_token *at,
                   const struct numbers *value);
bool operand_finite(struct reader *reader, const struct scene_token *at,
                    const struct numbers *value);
/* Reports that a value has too many components. Returns false. */
bool operand_found_vector(struct reader *reader, const struct scene_token *at,
                          const char *expected, const struct numbers *value);

#endif
