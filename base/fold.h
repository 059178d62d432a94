/* fold.h - text that is too long for a line, broken at blanks. */
#ifndef BASE_FOLD_H
#define BASE_FOLD_H

#include <stdio.h>

#include "base/sink.h"

/* Characters: how long printed lines become at most where they can be
 * folded. */
enum { FOLD_WIDTH = 100 };

/* Prints a text that begins in that column, and ends the line.  What would go
 * beyond FOLD_WIDTH goes on below, from the same column on; a column too far
 * to the right for that is not folded. */
void fold_print(const char *text, size_t column, FILE *file);
/* The same to a sink. */
void fold_put(const char *text, size_t column, const struct sink *sink);

#endif
