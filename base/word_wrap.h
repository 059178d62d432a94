/* word_wrap.h - breaks long text into lines, at blanks. */
#ifndef BASE_WORD_WRAP_H
#define BASE_WORD_WRAP_H

#include <stdio.h>

#include "base/sink.h"

/* The maximum width of printed lines that can be wrapped, in characters. */
enum { WORD_WRAP_WIDTH = 100 };

/* Prints a text whose first character is in the given column, and ends the line. Text
 * beyond WORD_WRAP_WIDTH continues on the next line in the same column. The text is not
 * wrapped if its lines would have fewer than 20 characters. */
void word_wrap_print(const char *text, size_t column, FILE *file);
/* Writes a text to a sink, with the line breaks of word_wrap_print. */
void word_wrap_put(const char *text, size_t column, const struct sink *sink);

#endif
