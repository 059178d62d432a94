/* line_editor.h - lines from a person or a file.
 *
 * On a terminal the package libedit reads them, if it is installed: with a history,
 * and Tab completes.  It is opened only there.
 */
#ifndef ASM_LINE_EDITOR_H
#define ASM_LINE_EDITOR_H

#include <stdbool.h>
#include <stdio.h>

#include "base/text_file.h"

struct typed_lines {
    struct text_stream stream; /* without libedit */
    bool terminal;
    char *text; /* the last line of libedit */
    /* libedit's, or NULL */
    char *(*read)(const char *prompt);
    int (*keep)(const char *line);
};

/* The names are those that Tab completes; each call gives one, NULL behind the last. */
struct typed_lines typed_lines_of(FILE *file, const char *(*name)(size_t i));
/* NULL: there are no more, or no memory. */
const char *typed_lines_next(struct typed_lines *lines, const char *prompt);
void typed_lines_free(struct typed_lines *lines);

#endif
