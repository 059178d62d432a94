/* semicolon.h - the ';' that ends the numbers of a declaration.
 *
 * An expression may continue after a directive or a macro, so only the ';' ends a value
 * for certain. If it is missing, the value ends before the directive: the missing ';'
 * is reported directly after the value, and is inserted.
 */
#ifndef RT_SCENE_SEMICOLON_H
#define RT_SCENE_SEMICOLON_H

#include "rt/scene/language/reader.h"

/* Returns true if the current token may be the last one of the value of a
 * declaration. */
bool semicolon_may_follow(const struct reader *reader);
/* Called after that token. Inserts the ';' if a directive, a macro or the end of a text
 * follows, and neither ';' nor an operator comes after it. */
void semicolon_find(struct reader *reader);
/* Reports that the ';' is missing before the current token. */
void semicolon_missing(struct reader *reader);

#endif
