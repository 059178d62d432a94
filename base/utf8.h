/* utf8.h - characters as UTF-8 has them (RFC 3629). */
#ifndef BASE_UTF8_H
#define BASE_UTF8_H

#include <stddef.h>

/* How many of so many bytes are one character; 0: they begin with none. */
size_t utf8_length(const char *text, size_t most);

enum { MAX_UTF8 = 4 };
/* The bytes of a code below 110000 hex, and how many. */
size_t utf8_put(char text[MAX_UTF8], unsigned long code);

#endif
