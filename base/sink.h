/* sink.h - where text goes: a callback, or a buffer that grows.
 *
 * Whatever the assembler's side prints (errors, listings, disassemblies, the
 * output of programs) goes to a sink, so that the caller decides on files,
 * strings or windows.
 */
#ifndef BASE_SINK_H
#define BASE_SINK_H

#include <stdbool.h>
#include <stddef.h>

struct sink {
    void (*put)(void *context, const char *text, size_t length);
    void *context;
};

void sink_put(const struct sink *sink, const char *text);
/* At most 1023 bytes a call; longer text is cut. */
void sink_print(const struct sink *sink, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/* Zero it to begin; text is NUL-terminated or NULL as long as it is empty. */
struct text_buffer {
    char *text;
    size_t length, capacity;
    bool failed; /* no memory: the text is not complete */
};

struct sink text_buffer_sink(struct text_buffer *buffer);
void text_buffer_free(struct text_buffer *buffer);
/* Zero it to begin; what does not fit is cut off.  Never without memory. */
enum { TEXT_LINE_SIZE = 160 };
struct text_line {
    char text[TEXT_LINE_SIZE]; /* ends with a NUL */
    size_t length;
};

struct sink text_line_sink(struct text_line *line);
/* Passes text on to another sink and records whether its last line is open:
 * text that follows, from elsewhere, then starts on a line of its own. */
struct line_tracker {
    struct sink to;
    bool open;
};

struct sink line_tracker_sink(struct line_tracker *tracker);
/* Puts a newline if the last line is open. */
void line_tracker_close(struct line_tracker *tracker);
/* Writes to the stdio stream given as its context. */
struct sink stream_sink(void *stream);

#endif
