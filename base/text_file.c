/* text_file.c - reads whole texts, or texts line by line. */
#include "base/text_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "vm/error.h"

bool text_clean(char *text, size_t *length, c205_error *error)
{
    const char *fault = c205_plain_text(text, length);
    return !fault || error_set(error, "%s", fault);
}

char *text_file_read(const char *path, size_t largest, size_t *length,
                     c205_error *error)
{
    char *text = file_read(path, largest, length, error);
    if (!text || text_clean(text, length, error))
        return text;
    free(text);
    errno = EILSEQ;
    return NULL;
}

/* ---- Line by line ---- */

static bool read_fail(struct text_stream *stream, const char *fault)
{
    stream->fault = fault;
    return false;
}

/* Returns the next byte, "\n" at the end of a line, or EOF at the end of the text. The
 * LF of a CR LF is skipped at the next call, because a terminal may send it late. */
static int next_byte(struct text_stream *stream)
{
    enum { END_OF_DOS_FILE = 0x1A };
    int byte = getc(stream->file);
    if (byte == '\n' && stream->after_return)
        byte = getc(stream->file);
    stream->after_return = byte == '\r';
    if (byte == END_OF_DOS_FILE)
        ungetc(byte, stream->file);
    return byte == '\r' ? '\n' : byte == END_OF_DOS_FILE ? EOF : byte;
}

static bool add_byte(struct text_stream *stream, size_t length, int byte)
{
    if (length + 1 >= stream->capacity) {
        size_t capacity = 2 * stream->capacity + 128;
        char *line = realloc(stream->line, capacity);
        if (!line)
            return read_fail(stream, "out of memory");
        stream->line = line;
        stream->capacity = capacity;
    }
    stream->line[length] = (char)byte;
    stream->line[length + 1] = '\0';
    return true;
}

/* Checks a line. A NUL is rejected, because it would hide the rest of the line. Only
 * the first line can have a byte order mark. */
static bool check_line(struct text_stream *stream, size_t length)
{
    bool nul = memchr(stream->line, '\0', length);
    const char *fault = stream->begun && !nul ? NULL
                                              : c205_plain_text(stream->line, &length);
    stream->begun = true;
    if (fault || nul)
        return read_fail(stream, fault ? fault : "not a text file");
    return true;
}

bool text_stream_next(struct text_stream *stream)
{
    size_t length = 0;
    int byte;
    while ((byte = next_byte(stream)) != EOF && byte != '\n')
        if (!add_byte(stream, length++, byte))
            return false;
    if (byte == EOF && ferror(stream->file))
        return read_fail(stream, strerror(errno));
    if (byte == EOF && length == 0)
        return false;
    return (length > 0 || add_byte(stream, 0, '\0')) && check_line(stream, length);
}

const struct text *text_find(const struct text *table, const char *name)
{
    for (; table->name; table++)
        if (strcmp(table->name, name) == 0)
            return table;
    return NULL;
}

void text_put(const struct text *text, const struct sink *sink)
{
    for (const char *const *line = text->lines; *line; line++)
        sink_put(sink, *line);
}
