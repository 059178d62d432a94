/* word_wrap.h - text that is too long for a line, broken at blanks. */
#ifndef BASE_WORD_WRAP_H
#define BASE_WORD_WRAP_H

#include <stdio.h>

#include "base/sink.h"

/* Characters: how long printed lines become at most where they can be
 * folded. */
enum { WORD_WRAP_WIDTH = 100 };

/* Prints a text that begins in that column, and ends the line.  What would go
 * beyond WORD_WRAP_WIDTH continues below, from the same column on; a column too far
 * to the right for that is not folded. */
void word_wrap_print(const char *text, size_t column, FILE *file);
/* The same to a sink. */
void word_wrap_put(const char *text, size_t column, const struct sink *sink);

#endif
