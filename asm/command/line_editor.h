/* line_editor.h - reads lines from a terminal or a file.
 *
 * Lines from a terminal are read by the library libedit if it is installed. It provides
 * a history and completion by Tab. It is loaded only for a terminal.
 */
#ifndef ASM_LINE_EDITOR_H
#define ASM_LINE_EDITOR_H

#include <stdbool.h>
#include <stdio.h>

#include "base/text_file.h"

struct typed_lines {
    struct text_stream stream; /* used without libedit */
    bool terminal;
    char *text; /* the last line from libedit */
    /* functions of libedit, or NULL */
    char *(*read)(const char *prompt);
    int (*keep)(const char *line);
};

/* Prepares reading lines from a file. For completion, `name` returns name i, or NULL
 * after the last. */
struct typed_lines typed_lines_of(FILE *file, const char *(*name)(size_t i));
/* Returns the next line. Returns NULL at the end of the input or if memory is
 * exhausted. */
const char *typed_lines_next(struct typed_lines *lines, const char *prompt);
void typed_lines_free(struct typed_lines *lines);

#endif
