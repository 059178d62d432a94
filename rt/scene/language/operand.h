/* operand.h - the operands of expressions. */
#ifndef RT_SCENE_OPERAND_H
#define RT_SCENE_OPERAND_H

#include "rt/scene/language/reader.h"

/* primary { "." component }, as expression.c writes it. */
bool operand_read(struct reader *reader, struct numbers *value);
/* The next token is the name of a spline: NAME(t) or NAME(t, kind). */
bool spline_call(struct reader *reader, struct numbers *value);

/* The error, at the token, of a value that is not a float; not finite: from
 * overflow, or from an argument outside of a function's domain. */
bool operand_float(struct reader *reader, const struct scene_token *at,
                   const struct numbers *value);
bool operand_finite(struct reader *reader, const struct scene_token *at,
                    const struct numbers *value);
/* The error that so many components are too many.  Returns false. */
bool operand_found_vector(struct reader *reader, const struct scene_token *at,
                          const char *expected, const struct numbers *value);

#endif
