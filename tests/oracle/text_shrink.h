/* text_shrink.h - scene texts with something left out. */
#ifndef TEXT_SHRINK_H
#define TEXT_SHRINK_H

#include <stdbool.h>
#include <stddef.h>

/* Leaves out lines and blocks, or the two lines that open and close a block, as long as
 * what is left fails, in so many trials at most.  The text is freed; the caller frees the
 * smaller one. */
char *text_shrunk(char *text, size_t most,
                  bool (*fails)(const char *text, void *context), void *context);

/* The text with the lines of blocks indented; it is freed. */
char *text_indented(char *text);

#endif
