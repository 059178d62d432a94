/* utf8.c - measures and writes UTF-8 characters. */
#include "base/utf8.h"

#include <stdbool.h>

static bool continues(unsigned char c)
{
    return (c & 0xC0) == 0x80;
}

/* Returns true if the second byte of a UTF-8 character is valid after the first.
 * Surrogates, codes with a shorter encoding, and codes above 10FFFF are invalid. */
static bool is_second(unsigned char first, unsigned char second)
{
    switch (first) {
    case 0xE0: return second >= 0xA0;
    case 0xED: return second < 0xA0;
    case 0xF0: return second >= 0x90;
    case 0xF4: return second < 0x90;
    default: return true;
    }
}

size_t utf8_length(const char *text, size_t most)
{
    unsigned char first = most > 0 ? (unsigned char)*text : 0xFF;
    size_t length = first < 0x80                    ? 1
                    : first >= 0xC2 && first < 0xE0 ? 2
                    : first >= 0xE0 && first < 0xF0 ? 3
                    : first >= 0xF0 && first < 0xF5 ? 4
                                                    : 0;
    if (length > most)
        return 0;
    for (size_t i = 1; i < length; i++)
        if (!continues((unsigned char)text[i])
            || (i == 1 && !is_second(first, (unsigned char)text[1])))
            return 0;
    return length;
}

size_t utf8_put(char text[MAX_UTF8], unsigned long code)
{
    static const unsigned char lead[] = { 0, 0, 0xC0, 0xE0, 0xF0 };
    size_t length = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    for (size_t i = length; i-- > 1; code >>= 6)
        text[i] = (char)(0x80 | (code & 0x3F));
    text[0] = (char)(lead[length] | code);
    return length;
}
