/* semicolon.h - finds, inserts or reports the ';' that ends the numbers of a
 * declaration.
 *
 * An expression may continue after a directive or a macro, so only a ';' definitely
 * ends a value. If it is missing, the value ends before the directive or macro. The
 * missing ';' is reported directly after the value, and inserted.
 */
#ifndef RT_SCENE_SEMICOLON_H
#define RT_SCENE_SEMICOLON_H

#include "rt/scene/language/reader.h"

/* Returns true if the current token may be the last one of the value of a
 * declaration. */
bool semicolon_may_follow(const struct reader *reader);
/* Inserts a ';' after the current token, if a directive, a macro or the end of a text
 * follows, and no ';' or operator comes after it. Call it after semicolon_may_follow
 * has returned true. */
void semicolon_find(struct reader *reader);
/* Reports that the ';' is missing before the current token. */
void semicolon_missing(struct reader *reader);

#endif
