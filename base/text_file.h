/* text_file.h - the reader of every text that a user writes: programs, scenes,
 * models, scripts, tables.  c205_plain_text defines what a text is.
 */
#ifndef BASE_TEXT_FILE_H
#define BASE_TEXT_FILE_H

#include <stdio.h>

#include "base/file.h"

/* As file_read, but of a text: its lines end with "\n" alone. */
char *text_file_read(const char *path, size_t largest, size_t *length,
                     c205_error *error);
/* A text that is in memory already, rewritten in place, with a NUL after it.
 * False: it is not a text, and the error has the reason. */
bool text_clean(char *text, size_t *length, c205_error *error);

/* A text that is read line by line, from a pipe or a terminal as well.  Zero
 * it to begin; line is freed by the caller. */
struct text_stream {
    FILE *file;
    char *line; /* the last one, without its end */
    size_t capacity;
    bool begun, after_return;
    const char *fault; /* why it is not a text, or cannot be read */
};
/* False: there is no further line, or a fault. */
bool text_stream_next(struct text_stream *stream);

#endif
