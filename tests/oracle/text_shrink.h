/* text_shrink.h - scene texts with something left out. */
#ifndef TEXT_SHRINK_H
#define TEXT_SHRINK_H

#include <stdbool.h>
#include <stddef.h>

/* The text without its line of that number, from 0 on, and if that opens a block,
 * without all up to the line that closes it; or, kept, without these two lines
 * alone.  NULL: there is no such line, or it opens none where one is asked for.
 * The caller frees it. */
char *text_without(const char *text, size_t line, bool kept);
size_t text_lines(const char *text);

/* The text with the lines of blocks indented; it is freed. */
char *text_indented(char *text);

#endif
