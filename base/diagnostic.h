/* diagnostic.h - messages about a user's text, with their positions.
 *
 * Programs, scenes, polynomials, models and observations are read to their end. The
 * messages are collected here and printed in one form:
 *
 *     file:line:column: error: message
 *         the source line
 *             ^
 */
#ifndef BASE_DIAGNOSTIC_H
#define BASE_DIAGNOSTIC_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/sink.h"

enum severity {
    SEVERITY_ERROR,
    SEVERITY_WARNING,
    SEVERITY_REPORT, /* something was replaced or ignored */
    SEVERITY_SAID    /* output of the text itself, printed without a prefix */
};

struct diagnostic {
    enum severity severity;
    char *file;
    size_t line, column; /* from 1, in bytes; line 0: the whole file */
    char *message;
    char *source; /* the text of that line */
};

/* Must be zeroed before use. */
struct diagnostics {
    size_t count;
    size_t errors; /* number of errors, including those for which memory was out */
    struct diagnostic *items;
};

/* The position of a diagnostic; line 0: the whole file. */
struct position {
    const char *file;
    size_t line, column;
    const char *source;   /* the line's text, or NULL */
    size_t source_length; /* up to its newline */
};

/* Adds a diagnostic. The arguments are copied. */
void diagnostics_add(struct diagnostics *diagnostics, enum severity severity,
                     const struct position *position, const char *message);
/* Appends text that is printed without a prefix. Returns false if such texts exceed
 * MAX_SAID bytes in all, or if memory is exhausted. */
enum { MAX_SAID = 1 << 16 };
bool diagnostics_append(struct diagnostics *diagnostics, const char *text);

/* An error at a word with an invisible character names the character. Names and
 * messages are printed with such characters escaped, source lines with a question mark
 * for each (base/visible_text.h). */
void diagnostic_put(const struct diagnostic *diagnostic, const struct sink *sink);
void diagnostics_put(const struct diagnostics *diagnostics, const struct sink *sink);
void diagnostics_print(const struct diagnostics *diagnostics, FILE *out);
void diagnostics_free(struct diagnostics *diagnostics);

#endif
