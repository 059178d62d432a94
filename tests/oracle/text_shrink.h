/* text_shrink.h - shrinks a scene text that fails a test. */
#ifndef TEXT_SHRINK_H
#define TEXT_SHRINK_H

#include <stdbool.h>
#include <stddef.h>

/* Removes lines and blocks, or the first and last line of a block, as long as the rest
 * fails, in at most `most` trials.  Frees the text; the caller frees the smaller
 * one. */
char *text_shrunk(char *text, size_t most,
                  bool (*fails)(const char *text, void *context), void *context);

/* Returns the text with indented blocks, and frees the original. */
char *text_indented(char *text);

#endif
