/* message.c - parses and writes the header of messages. */
#include "asm/dap/message.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "vm/error.h"

static enum message_state broken(c205_error *error, const char *what)
{
    error_set(error, "malformed message header: %s", what);
    return MESSAGE_BROKEN;
}

/* Reads decimal digits. Returns false if there are none, or if the number exceeds
 * MAX_MESSAGE. */
static bool read_length(const char *at, const char *end, size_t *length)
{
    *length = 0;
    while (at < end && *at == ' ')
        at++;
    if (at == end)
        return false;
    for (; at < end; at++) {
        if (!isdigit((unsigned char)*at))
            return false;
        *length = *length * 10 + (size_t)(*at - '0');
        if (*length > MAX_MESSAGE)
            return false;
    }
    return true;
}

/* Reads a field "Name: value". Fields with other names are ignored. */
static bool read_field(const char *line, const char *end, bool *found, size_t *length)
{
    static const char name[] = "Content-Length";
    const char *colon = memchr(line, ':', (size_t)(end - line));
    if (!colon)
        return false;
    if ((size_t)(colon - line) != sizeof name - 1
        || strncasecmp(line, name, sizeof name - 1) != 0)
        return true;
    *found = true;
    return read_length(colon + 1, end, length);
}

enum message_state message_find(const struct text_buffer *bytes,
                                struct message_content *content, c205_error *error)
{
    const char *line = bytes->text, *end;
    bool found = false;
    if (bytes->length == 0)
        return MESSAGE_PART;
    end = line + bytes->length;
    for (;;) {
        const char *newline = memchr(line, '\n', (size_t)(end - line));
        if ((size_t)((newline ? newline : end) - bytes->text) > MAX_MESSAGE_HEADER)
            return broken(error, "it has no end");
        if (!newline)
            return MESSAGE_PART;
        if (newline == line || newline[-1] != '\r')
            return broken(error, "a line does not end with CR LF");
        if (newline - 1 == line)
            break;
        if (!read_field(line, newline - 1, &found, &content->length))
            return broken(error,
                          found
                              ? "Content-Length must be an integer between 0 and 4 MiB"
                              : "a line has no colon");
        line = newline + 1;
    }
    if (!found)
        return broken(error, "it has no Content-Length");
    content->begin = (size_t)(line + 2 - bytes->text);
    return bytes->length - content->begin >= content->length ? MESSAGE_WHOLE
                                                             : MESSAGE_PART;
}

void message_drop(struct text_buffer *bytes, size_t count)
{
    bytes->length -= count;
    memmove(bytes->text, bytes->text + count, bytes->length);
}

void message_put(const struct text_buffer *content, const struct sink *out)
{
    struct text_buffer whole = { 0 };
    struct sink sink = text_buffer_sink(&whole);
    sink_print(&sink, "Content-Length: %zu\r\n\r\n", content->length);
    sink.put(sink.context, content->text, content->length);
    if (!whole.failed)
        out->put(out->context, whole.text, whole.length);
    text_buffer_free(&whole);
}
