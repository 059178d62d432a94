/* semicolon.h - the ';' that ends the numbers of a declaration.
 *
 * An expression may continue after a directive or a macro, so the end of a
 * value is certain only at the ';'.  Where none comes, the value ends before
 * the directive: the ';' is reported directly after the value, and is inserted.
 */
#ifndef RT_SCENE_SEMICOLON_H
#define RT_SCENE_SEMICOLON_H

#include "rt/scene/language/reader.h"

/* Whether the token may be the last one of the value of a declaration. */
bool semicolon_may_follow(const struct reader *reader);
/* After that token: inserts the ';' if what comes is a directive, a macro or
 * the end of a text, and leads to neither ';' nor an operator. */
void semicolon_find(struct reader *reader);
/* The next token is no ';': reports that it is missing. */
void semicolon_missing(struct reader *reader);

#endif
