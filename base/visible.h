/* visible.h - characters that a reader cannot see or that a terminal obeys:
 * controls, blanks other than the plain one, characters without a width, marks
 * of the writing direction.
 */
#ifndef BASE_VISIBLE_H
#define BASE_VISIBLE_H

#include "base/sink.h"

/* The bytes of the invisible character at the start of a text, and its code;
 * 0: what is there can be seen, a plain blank included, or is not UTF-8. */
size_t invisible_length(const char *text, size_t most, unsigned long *code);
/* The first one other than a tab in a text; NULL: there is none. */
const char *invisible_find(const char *text, unsigned long *code);
/* "U+00A0, a no-break space" */
void invisible_name(const struct sink *sink, unsigned long code);

/* A name or a message.  Invisible characters other than tabs, and bytes that are
 * not UTF-8, are escaped: \x1b, \u{200b}. */
void visible_put(const struct sink *sink, const char *text, size_t length);
/* The same of several lines, whose ends are kept. */
void visible_put_lines(const struct sink *sink, const char *text, size_t length);
/* A sink that does so, to the stdio stream. */
struct sink visible_stream(void *stream);

#endif
