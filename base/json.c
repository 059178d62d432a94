/* json.c - builds a JSON document in memory. json_close writes it. */
#include "base/json.h"

#include <assert.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "vm/error.h"
#include "base/sink.h"
#include "base/utf8.h"
#include "base/visible_text.h"
#include "base/atomic_file.h"

enum { DEEPEST = 16, INDENT = 2 };

struct json {
    struct atomic_file *whole; /* destination: a file, or NULL */
    FILE *stream;              /* destination: a stream, or NULL */
    struct text_buffer *line;  /* destination: a buffer, or NULL; the text is then one
                                  line */
    struct text_buffer text;
    struct sink sink; /* appends to text */
    unsigned depth;
    struct {
        char closing;
        bool filled;
    } level[DEEPEST];
};

static void open_level(struct json *json, char opening, char closing)
{
    assert(json->depth < DEEPEST);
    json->level[json->depth].closing = closing;
    json->level[json->depth].filled = false;
    json->depth++;
    sink_print(&json->sink, "%c", opening);
}

static void new_line(struct json *json)
{
    if (json->line)
        return;
    sink_print(&json->sink, "\n%*s", (int)json->depth * INDENT, "");
}

/* Returns true for characters that a terminal would interpret. They are escaped,
 * because JSON may be printed on a terminal. */
static bool is_hidden(const char *text, size_t length)
{
    unsigned long code;
    return invisible_length(text, length, &code) > 0 && code <= 0xFFFF;
}

/* Returns the number of bytes at the start that need no escape. A NUL byte is never
 * part of a longer character. */
static size_t plain_length(const char *text)
{
    size_t length = 0, step;
    while ((unsigned char)text[length] >= ' ' && text[length] != '"'
           && text[length] != '\\' && (step = utf8_length(text + length, MAX_UTF8)) > 0
           && !is_hidden(text + length, step))
        length += step;
    return length;
}

void json_string(const struct sink *sink, const char *text)
{
    sink_put(sink, "\"");
    for (;;) {
        size_t length = plain_length(text);
        sink->put(sink->context, text, length);
        text += length;
        unsigned long code;
        size_t hidden = invisible_length(text, MAX_UTF8, &code);
        unsigned char c = (unsigned char)*text++;
        if (!c)
            break;
        if (c == '"' || c == '\\') {
            sink_print(sink, "\\%c", c);
        } else if (hidden) {
            sink_print(sink, "\\u%04lx", code);
            text += hidden - 1;
        } else {
            sink_put(sink, "\\ufffd");
        }
    }
    sink_put(sink, "\"");
}

/* Writes the comma, newline and key before a value. */
static void introduce(struct json *json, const char *key)
{
    if (json->level[json->depth - 1].filled)
        sink_put(&json->sink, json->line ? ", " : ",");
    json->level[json->depth - 1].filled = true;
    new_line(json);
    if (key) {
        json_string(&json->sink, key);
        sink_put(&json->sink, ": ");
    }
}

static bool no_memory(c205_error *error)
{
    return error_set(error, "out of memory");
}

static struct json *json_new(FILE *stream, c205_error *error)
{
    struct json *json = calloc(1, sizeof *json);
    if (!json) {
        no_memory(error);
        return NULL;
    }
    json->stream = stream;
    json->sink = text_buffer_sink(&json->text);
    open_level(json, '{', '}');
    return json;
}

struct json *json_open_stream(FILE *stream, const char *path, c205_error *error)
{
    struct json *json = json_new(stream, error);
    if (json && path && !(json->whole = atomic_file_open(path, error))) {
        json_discard(json);
        return NULL;
    }
    return json;
}

struct json *json_open_line(struct text_buffer *line, c205_error *error)
{
    struct json *json = json_new(NULL, error);
    if (json)
        json->line = line;
    return json;
}

struct json *json_open(const char *path, c205_error *error)
{
    return json_open_stream(NULL, path, error);
}

bool json_close(struct json *json, c205_error *error)
{
    assert(json->depth == 1);
    json_end(json);
    if (!json->line)
        sink_put(&json->sink, "\n");
    if (json->text.failed) {
        json_discard(json);
        return no_memory(error);
    }
    bool good = true;
    if (json->line) {
        struct sink line = text_buffer_sink(json->line);
        line.put(line.context, json->text.text, json->text.length);
        good = !json->line->failed || no_memory(error);
    }
    if (json->whole) {
        fwrite(json->text.text, 1, json->text.length, json->whole->file);
        good = atomic_file_commit(json->whole, error);
        json->whole = NULL;
    }
    if (good && json->stream)
        fwrite(json->text.text, 1, json->text.length, json->stream);
    json_discard(json);
    return good;
}

void json_discard(struct json *json)
{
    if (json->whole)
        atomic_file_discard(json->whole);
    text_buffer_free(&json->text);
    free(json);
}

void json_object(struct json *json, const char *key)
{
    introduce(json, key);
    open_level(json, '{', '}');
}

void json_array(struct json *json, const char *key)
{
    introduce(json, key);
    open_level(json, '[', ']');
}

void json_end(struct json *json)
{
    json->depth--;
    if (json->level[json->depth].filled)
        new_line(json);
    sink_print(&json->sink, "%c", json->level[json->depth].closing);
}

void json_text(struct json *json, const char *key, const char *text)
{
    introduce(json, key);
    json_string(&json->sink, text);
}

void json_digits(char text[JSON_NUMBER_SIZE], double value)
{
    snprintf(text, JSON_NUMBER_SIZE, "%.15g", value);
    if (strtod(text, NULL) != value)
        snprintf(text, JSON_NUMBER_SIZE, "%.17g", value);
}

void json_number(struct json *json, const char *key, double value)
{
    if (!isfinite(value)) {
        json_null(json, key);
        return;
    }
    char text[JSON_NUMBER_SIZE];
    json_digits(text, value);
    introduce(json, key);
    sink_put(&json->sink, text);
}

void json_count(struct json *json, const char *key, uint64_t value)
{
    introduce(json, key);
    sink_print(&json->sink, "%" PRIu64, value);
}

void json_bool(struct json *json, const char *key, bool value)
{
    introduce(json, key);
    sink_put(&json->sink, value ? "true" : "false");
}

void json_null(struct json *json, const char *key)
{
    introduce(json, key);
    sink_put(&json->sink, "null");
}

void json_raw(struct json *json, const char *key, const char *text)
{
    introduce(json, key);
    sink_put(&json->sink, text);
}
