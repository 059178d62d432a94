/* text_file.h - reads all texts that users write: programs, scenes, models, scripts,
 * tables. c205_plain_text defines the format of a text.
 */
#ifndef BASE_TEXT_FILE_H
#define BASE_TEXT_FILE_H

#include <stdio.h>

#include "base/file.h"
#include "base/sink.h"
#include "vm/text.h"

/* Reads a file like file_read and converts its line ends to "\n". */
char *text_file_read(const char *path, size_t largest, size_t *length,
                     c205_error *error);
/* Converts a text in memory in place and adds a NUL. Returns false with the reason in
 * the error if it is not a text. */
bool text_clean(char *text, size_t *length, c205_error *error);

/* Returns a built-in text by its name, or NULL if the table does not contain it. */
const struct text *text_find(const struct text *table, const char *name);
/* Writes the lines of a built-in text to a sink. */
void text_put(const struct text *text, const struct sink *sink);

/* The state of reading a text line by line, also from a pipe or a terminal. It must be
 * zeroed before use, and the caller frees line. */
struct text_stream {
    FILE *file;
    char *line; /* the last line, without its newline */
    size_t capacity;
    bool begun, after_return;
    const char *fault; /* why it is not a text or cannot be read */
};
/* Reads the next line. Returns false at the end of the text or after a fault. */
bool text_stream_next(struct text_stream *stream);

#endif
