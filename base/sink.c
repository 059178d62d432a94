/* sink.c - implements sinks for buffers, lines and streams. */
#include "base/sink.h"
#include "vm/error.h"

#include <stdlib.h>
#include <string.h>

void sink_put(const struct sink *sink, const char *text)
{
    sink->put(sink->context, text, strlen(text));
}

void sink_print(const struct sink *sink, const char *format, ...)
{
    char text[1024];
    PRINTF_TEXT(text, format);
    sink_put(sink, text);
}

static bool grow_buffer(struct text_buffer *buffer, size_t length)
{
    size_t need = buffer->length + length + 1, capacity = 256;
    char *text;
    if (need <= buffer->capacity)
        return true;
    while (capacity < need)
        capacity *= 2;
    text = realloc(buffer->text, capacity);
    if (!text) {
        buffer->failed = true;
        return false;
    }
    buffer->text = text;
    buffer->capacity = capacity;
    return true;
}

static void put_into_buffer(void *context, const char *text, size_t length)
{
    struct text_buffer *buffer = context;
    if (buffer->failed || !grow_buffer(buffer, length))
        return;
    memcpy(buffer->text + buffer->length, text, length);
    buffer->length += length;
    buffer->text[buffer->length] = '\0';
}

struct sink text_buffer_sink(struct text_buffer *buffer)
{
    struct sink sink = { put_into_buffer, NULL };
    sink.context = buffer;
    return sink;
}

void text_buffer_free(struct text_buffer *buffer)
{
    static const struct text_buffer empty;
    free(buffer->text);
    *buffer = empty;
}

static void put_into_line(void *context, const char *text, size_t length)
{
    struct text_line *line = context;
    size_t room = sizeof line->text - 1 - line->length;
    if (length > room)
        length = room;
    memcpy(line->text + line->length, text, length);
    line->length += length;
    line->text[line->length] = '\0';
}

struct sink text_line_sink(struct text_line *line)
{
    struct sink sink = { put_into_line, NULL };
    sink.context = line;
    return sink;
}

static void put_tracked(void *context, const char *text, size_t length)
{
    struct line_tracker *tracker = context;
    if (length > 0)
        tracker->open = text[length - 1] != '\n';
    tracker->to.put(tracker->to.context, text, length);
}

struct sink line_tracker_sink(struct line_tracker *tracker)
{
    struct sink sink = { put_tracked, NULL };
    sink.context = tracker;
    return sink;
}

void line_tracker_close(struct line_tracker *tracker)
{
    if (tracker->open)
        sink_put(&tracker->to, "\n");
    tracker->open = false;
}

static void put_into_stream(void *context, const char *text, size_t length)
{
    fwrite(text, 1, length, context);
}

struct sink stream_sink(void *stream)
{
    struct sink sink = { put_into_stream, NULL };
    sink.context = stream;
    return sink;
}
