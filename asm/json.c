/* json.c - see json.h. */
#include "asm/json.h"

#include <assert.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "asm/whole.h"

enum { DEEPEST = 16, INDENT = 2, NUMBER_SIZE = 32 };

struct json {
    struct whole *whole;
    FILE *file;
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
    putc(opening, json->file);
}

static void new_line(struct json *json)
{
    fprintf(json->file, "\n%*s", (int)json->depth * INDENT, "");
}

/* Bytes from 80 hex on are taken for UTF-8 and pass. */
static void put_string(FILE *file, const char *text)
{
    putc('"', file);
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\') {
            fprintf(file, "\\%c", c);
        } else if (c < ' ') {
            fprintf(file, "\\u%04x", c);
        } else {
            putc(c, file);
        }
    }
    putc('"', file);
}

/* What comes before each value: comma, new line, key. */
static void introduce(struct json *json, const char *key)
{
    if (json->level[json->depth - 1].filled) {
        putc(',', json->file);
    }
    json->level[json->depth - 1].filled = true;
    new_line(json);
    if (key) {
        put_string(json->file, key);
        fputs(": ", json->file);
    }
}

struct json *json_open(const char *path, c205_error *error)
{
    struct whole *whole = whole_open(path, error);
    if (!whole) {
        return NULL;
    }
    struct json *json = calloc(1, sizeof *json);
    if (!json) {
        whole_discard(whole);
        snprintf(error->message, sizeof error->message, "no memory");
        return NULL;
    }
    json->whole = whole;
    json->file = whole->file;
    open_level(json, '{', '}');
    return json;
}

bool json_close(struct json *json, c205_error *error)
{
    assert(json->depth == 1);
    json_end(json);
    putc('\n', json->file);
    struct whole *whole = json->whole;
    free(json);
    return whole_commit(whole, error);
}

void json_discard(struct json *json)
{
    whole_discard(json->whole);
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
    if (json->level[json->depth].filled) {
        new_line(json);
    }
    putc(json->level[json->depth].closing, json->file);
}

void json_text(struct json *json, const char *key, const char *text)
{
    introduce(json, key);
    put_string(json->file, text);
}

void json_number(struct json *json, const char *key, double value)
{
    if (!isfinite(value)) {
        json_null(json, key);
        return;
    }
    char text[NUMBER_SIZE];
    snprintf(text, sizeof text, "%.15g", value);
    if (strtod(text, NULL) != value) {
        snprintf(text, sizeof text, "%.17g", value);
    }
    introduce(json, key);
    fputs(text, json->file);
}

void json_count(struct json *json, const char *key, uint64_t value)
{
    introduce(json, key);
    fprintf(json->file, "%" PRIu64, value);
}

void json_truth(struct json *json, const char *key, bool value)
{
    introduce(json, key);
    fputs(value ? "true" : "false", json->file);
}

void json_null(struct json *json, const char *key)
{
    introduce(json, key);
    fputs("null", json->file);
}
