/* plain_text.c - checks that a file is a text, and normalises its line ends. */
#include "vm/c205.h"

#include <string.h>

static bool starts_with(const char *text, size_t length, const char *mark)
{
    return length >= strlen(mark) && !memcmp(text, mark, strlen(mark));
}

/* Detects UTF-16. Most characters are ASCII or Latin-1, so one byte of each pair is
 * NUL. The test requires a NUL in the same byte in at least a quarter of the pairs, and
 * almost none in the other byte. */
static bool has_pairs_with_nul(const char *text, size_t length)
{
    enum { EXAMINED = 4096 };
    size_t nuls[2] = { 0, 0 }, pairs;
    if (length > EXAMINED)
        length = EXAMINED;
    pairs = length / 2;
    for (size_t i = 0; i < 2 * pairs; i++)
        nuls[i % 2] += text[i] == '\0';
    for (size_t i = 0; i < 2; i++)
        if (4 * nuls[i] >= pairs && nuls[i] > 4 * nuls[1 - i])
            return true;
    return false;
}

static bool is_utf16(const char *text, size_t length)
{
    return starts_with(text, length, "\xFF\xFE")
           || starts_with(text, length, "\xFE\xFF") || has_pairs_with_nul(text, length);
}

const char *c205_plain_text(char *text, size_t *length)
{
    static const char mark[] = "\xEF\xBB\xBF";
    enum { END_OF_DOS_FILE = 0x1A };
    const char *from = text, *end = text + *length;
    char *to = text;
    if (is_utf16(text, *length))
        return "this text is UTF-16: save it as UTF-8";
    if (starts_with(text, *length, mark))
        from += strlen(mark);
    while (from < end && *from != END_OF_DOS_FILE) {
        bool returns = *from == '\r';
        *to++ = returns ? '\n' : *from;
        from += returns && from + 1 < end && from[1] == '\n' ? 2 : 1;
    }
    *to = '\0';
    *length = (size_t)(to - text);
    return NULL;
}
