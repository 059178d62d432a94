/* visible_text.c - finds and escapes invisible characters. */
#include "base/visible_text.h"

#include <string.h>

#include "base/utf8.h"

/* The invisible code points of Unicode 15, in ascending order. */
static const struct invisible {
    unsigned long first, last;
    const char *name;
} table[] = {
    { 0x00, 0x1F, "a control character" },
    { 0x7F, 0x9F, "a control character" },
    { 0xA0, 0xA0, "a no-break space" },
    { 0xAD, 0xAD, "a soft hyphen" },
    { 0x34F, 0x34F, "an invisible joiner" },
    { 0x61C, 0x61C, "a mark of the writing direction" },
    { 0x115F, 0x1160, "an invisible filler" },
    { 0x1680, 0x1680, "a space" },
    { 0x17B4, 0x17B5, "an invisible vowel" },
    { 0x180B, 0x180F, "an invisible selector" },
    { 0x2000, 0x200A, "a space" },
    { 0x200B, 0x200B, "a zero-width space" },
    { 0x200C, 0x200D, "an invisible joiner" },
    { 0x200E, 0x200F, "a mark of the writing direction" },
    { 0x2028, 0x2029, "a separator of lines" },
    { 0x202A, 0x202E, "a mark of the writing direction" },
    { 0x202F, 0x202F, "a no-break space" },
    { 0x205F, 0x205F, "a space" },
    { 0x2060, 0x2060, "an invisible joiner" },
    { 0x2061, 0x2064, "an invisible operator" },
    { 0x2065, 0x206F, "a mark of the writing direction" },
    { 0x2800, 0x2800, "an empty pattern of Braille" },
    { 0x3000, 0x3000, "a space" },
    { 0x3164, 0x3164, "an invisible filler" },
    { 0xFE00, 0xFE0F, "an invisible selector" },
    { 0xFEFF, 0xFEFF, "a byte order mark" },
    { 0xFFA0, 0xFFA0, "an invisible filler" },
    { 0xFFF0, 0xFFFB, "an invisible mark" },
    { 0x1BCA0, 0x1BCA3, "an invisible mark" },
    { 0x1D173, 0x1D17A, "an invisible mark" },
    { 0xE0000, 0xE0FFF, "an invisible mark" },
};

static const struct invisible *find_range(unsigned long code)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (code >= table[i].first && code <= table[i].last)
            return &table[i];
    return NULL;
}

static unsigned long code_of(const char *text, size_t length)
{
    static const unsigned char lead[] = { 0, 0x7F, 0x1F, 0x0F, 0x07 };
    unsigned long code = (unsigned char)text[0] & lead[length];
    for (size_t i = 1; i < length; i++)
        code = code << 6 | ((unsigned char)text[i] & 0x3F);
    return code;
}

size_t invisible_length(const char *text, size_t most, unsigned long *code)
{
    size_t length = utf8_length(text, most);
    if (length == 0)
        return 0;
    *code = code_of(text, length);
    return find_range(*code) ? length : 0;
}

const char *invisible_find(const char *text, unsigned long *code)
{
    size_t all = strlen(text);
    for (size_t i = 0; i < all; i++)
        if (text[i] != '\t' && invisible_length(text + i, all - i, code))
            return text + i;
    return NULL;
}

void invisible_name(const struct sink *sink, unsigned long code)
{
    sink_print(sink, "U+%04lX, %s", code, find_range(code)->name);
}

void visible_put(const struct sink *sink, const char *text, size_t length)
{
    const char *end = text + length;
    unsigned long code;
    while (text < end) {
        size_t most = (size_t)(end - text), bytes = utf8_length(text, most);
        if (*text == '\t')
            sink->put(sink->context, text, 1);
        else if (bytes == 0 || (unsigned char)*text < ' ' || *text == 0x7F)
            sink_print(sink, "\\x%02x", (unsigned)(unsigned char)*text);
        else if (invisible_length(text, most, &code))
            sink_print(sink, "\\u{%lx}", code);
        else
            sink->put(sink->context, text, bytes);
        text += bytes ? bytes : 1;
    }
}

void visible_put_lines(const struct sink *sink, const char *text, size_t length)
{
    const char *end = text + length;
    while (text < end) {
        const char *newline = memchr(text, '\n', (size_t)(end - text));
        visible_put(sink, text, (size_t)((newline ? newline : end) - text));
        if (newline)
            sink_put(sink, "\n");
        text = newline ? newline + 1 : end;
    }
}

static void put_into_stream(void *context, const char *text, size_t length)
{
    struct sink stream = stream_sink(context);
    visible_put_lines(&stream, text, length);
}

struct sink visible_stream(void *stream)
{
    struct sink sink = { put_into_stream, NULL };
    sink.context = stream;
    return sink;
}
