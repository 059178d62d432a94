/* word_wrap.c - breaks text at blanks. */
#include "base/word_wrap.h"

#include <stdint.h>
#include <string.h>

enum { NARROWEST = 20 };

/* Returns the length of the text that fits a line of the given width. It contains at
 * least one word. */
static size_t wrapped_length(const char *text, size_t width)
{
    size_t length = 0;
    if (strlen(text) <= width)
        return strlen(text);
    for (size_t i = 0; text[i] && (i <= width || length == 0); i++)
        length = text[i] == ' ' ? i : length;
    return length > 0 ? length : strlen(text);
}

void word_wrap_put(const char *text, size_t column, const struct sink *sink)
{
    size_t width = column + NARROWEST <= WORD_WRAP_WIDTH ? WORD_WRAP_WIDTH - column
                                                         : SIZE_MAX;
    for (;;) {
        size_t length = wrapped_length(text, width);
        sink->put(sink->context, text, length);
        sink_put(sink, "\n");
        text += length + strspn(text + length, " ");
        if (!*text)
            return;
        sink_print(sink, "%*s", (int)column, "");
    }
}

void word_wrap_print(const char *text, size_t column, FILE *file)
{
    struct sink sink = stream_sink(file);
    word_wrap_put(text, column, &sink);
}
