/* diagnostic.h - messages about a user's text, with their positions.
 *
 * The readers of programs, scenes, polynomials, models and observations continue after
 * an error. They collect their messages here. All messages are printed in the same
 * form:
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
    SEVERITY_SAID    /* output of the text, printed without a prefix */
};

struct diagnostic {
    enum severity severity;
    char *file;
    size_t line, column; /* count from 1, in bytes; line 0: the whole file */
    char *message;
    char *source; /* the text of that line */
};

/* Messages with positions. The struct must be zeroed before use. */
struct diagnostics {
    size_t count;
    size_t errors; /* number of errors, including errors that could not be stored */
    struct diagnostic *items;
};

/* The position of a diagnostic; line 0: the whole file. */
struct position {
    const char *file;
    size_t line, column;
    const char *source;   /* text of the line, or NULL */
    size_t source_length; /* without the newline */
};

/* Adds a diagnostic. The arguments are copied. */
void diagnostics_add(struct diagnostics *diagnostics, enum severity severity,
                     const struct position *position, const char *message);
/* Removes all diagnostics after the first `count`. */
void diagnostics_keep(struct diagnostics *diagnostics, size_t count);
/* Appends text that is printed without a prefix. Returns false if these texts exceed
 * MAX_SAID bytes in total, or if the host is out of memory. */
enum { MAX_SAID = 1 << 16 };
bool diagnostics_append(struct diagnostics *diagnostics, const char *text);

/* Prints a diagnostic. An error at a word with an invisible character names the
 * character. Invisible characters are escaped in names and messages, and replaced by
 * question marks in source lines (base/visible_text.h). */
void diagnostic_put(const struct diagnostic *diagnostic, const struct sink *sink);
void diagnostics_put(const struct diagnostics *diagnostics, const struct sink *sink);
void diagnostics_print(const struct diagnostics *diagnostics, FILE *out);
void diagnostics_free(struct diagnostics *diagnostics);

#endif
