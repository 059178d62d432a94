/* diagnostic.h - what a reader of a user's text has to say of it, and where.
 *
 * Programs, scenes, polynomials, models and observations are read to their
 * end; what is found on the way is kept here and printed in one form:
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
    SEVERITY_REPORT, /* something is replaced or left out */
    SEVERITY_SAID    /* what the text itself says: the message as it is */
};

struct diagnostic {
    enum severity severity;
    char *file;
    size_t line, column; /* from 1, in bytes; line 0: the file as a whole */
    char *message;
    char *source; /* the text of that line */
};

/* Zero it to begin. */
struct diagnostics {
    size_t count;
    size_t errors; /* so many of them, those counted that no memory was left
                      to keep */
    struct diagnostic *items;
};

/* Where a diagnostic points to; line 0: to the file as a whole. */
struct position {
    const char *file;
    size_t line, column;
    const char *source;   /* the line's text, or NULL .. */
    size_t source_length; /* .. up to its newline */
};

/* Copies what it is given. */
void diagnostics_add(struct diagnostics *diagnostics, enum severity severity,
                     const struct position *position, const char *message);
/* Text that is to be printed as it is, after what was said so far.  False: it
 * is more than MAX_SAID bytes in all, or there is no memory. */
enum { MAX_SAID = 1 << 16 };
bool diagnostics_append(struct diagnostics *diagnostics, const char *text);

/* An error that points to a word with an invisible character names it.  Names and
 * messages are printed with such characters escaped, source lines with a question
 * mark for each (base/visible.h). */
void diagnostic_put(const struct diagnostic *diagnostic, const struct sink *sink);
void diagnostics_put(const struct diagnostics *diagnostics, const struct sink *sink);
void diagnostics_print(const struct diagnostics *diagnostics, FILE *out);
void diagnostics_free(struct diagnostics *diagnostics);

#endif
