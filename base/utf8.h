/* utf8.h - measures and writes characters in UTF-8 (RFC 3629). */
#ifndef BASE_UTF8_H
#define BASE_UTF8_H

#include <stddef.h>

/* Returns the length of the first character of a text, which has `most` bytes. 0: the
 * first character is not valid. */
size_t utf8_length(const char *text, size_t most);

enum { MAX_UTF8 = 4 };
/* Writes the bytes of a code point below 110000 hex. Returns their number. */
size_t utf8_put(char text[MAX_UTF8], unsigned long code);

#endif
