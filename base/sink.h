/* sink.h - destinations of text: a callback, or a buffer that grows.
 *
 * All output of the assembler (errors, listings, disassemblies, the output of programs)
 * goes to a sink, so the caller chooses files, strings or windows.
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
/* Formats at most 1023 bytes per call and truncates longer text. */
void sink_print(const struct sink *sink, const char *format, ...)
#if defined(__GNUC__) /* this header is installed without vm/error.h */
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/* A buffer that grows. It must be zeroed before use. text is NUL-terminated, or NULL
 * while it is empty. */
struct text_buffer {
    char *text;
    size_t length, capacity;
    bool failed; /* out of memory: the text is incomplete */
};

struct sink text_buffer_sink(struct text_buffer *buffer);
void text_buffer_free(struct text_buffer *buffer);
/* A buffer of fixed size. It must be zeroed before use. Excess text is cut off. */
enum { TEXT_LINE_SIZE = 160 };
struct text_line {
    char text[TEXT_LINE_SIZE]; /* ends with a NUL */
    size_t length;
};

struct sink text_line_sink(struct text_line *line);
/* A sink that passes text to another sink. It records whether the last line has no
 * newline yet, so that other text can begin on a new line. */
struct line_tracker {
    struct sink to;
    bool open;
};

struct sink line_tracker_sink(struct line_tracker *tracker);
/* Writes a newline if the last line has none. */
void line_tracker_close(struct line_tracker *tracker);
/* Returns a sink that writes to a stdio stream. */
struct sink stream_sink(void *stream);

#endif
