/* visible_text.h - finds and escapes characters that are invisible or that a terminal
 * interprets: controls, unusual blanks, characters without a width, marks of the
 * writing direction.
 */
#ifndef BASE_VISIBLE_TEXT_H
#define BASE_VISIBLE_TEXT_H

#include "base/sink.h"

/* Returns the length of the first character of a text if it is invisible, and sets its
 * code. Returns 0 if it is visible, a plain blank, or not UTF-8. */
size_t invisible_length(const char *text, size_t most, unsigned long *code);
/* Returns the first invisible character of a text other than a tab, or NULL. */
const char *invisible_find(const char *text, unsigned long *code);
/* Writes a character, as in "U+00A0, a no-break space". */
void invisible_name(const struct sink *sink, unsigned long code);

/* Writes a name or a message. Invisible characters other than tabs, and bytes that are
 * not UTF-8, are escaped: \x1b, \u{200b}. */
void visible_put(const struct sink *sink, const char *text, size_t length);
/* Writes several lines like visible_put, but keeps their newlines. */
void visible_put_lines(const struct sink *sink, const char *text, size_t length);
/* Returns a sink that writes to a stdio stream like visible_put. */
struct sink visible_stream(void *stream);

#endif
