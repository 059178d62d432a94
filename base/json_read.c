/* json_read.c - a recursive descent parser for JSON. */
#include "base/json_read.h"
#include "vm/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/utf8.h"

#define MAX_DIGITS 400

struct json_reading {
    struct arena *arena;
    const char *begin, *at, *end;
    unsigned depth;
    c205_error *error;
};

static bool json_fail(struct json_reading *reading, const char *what)
{
    return error_set(reading->error, "%s at byte %zu", what,
                     (size_t)(reading->at - reading->begin));
}

static bool no_memory(struct json_reading *reading)
{
    return error_set(reading->error, "out of memory");
}

static void skip_space(struct json_reading *reading)
{
    while (reading->at < reading->end && *reading->at
           && strchr(" \t\r\n", *reading->at))
        reading->at++;
}

/* Returns the next character, or 0 at the end. */
static char next_of(const struct json_reading *reading)
{
    return reading->at < reading->end ? *reading->at : '\0';
}

static bool take_char(struct json_reading *reading, char c)
{
    if (reading->at == reading->end || *reading->at != c)
        return false;
    reading->at++;
    return true;
}

/* ---- Texts ---------------------------------------------------------------- */

static bool read_hex(struct json_reading *reading, unsigned long *code)
{
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    *code = 0;
    for (int i = 0; i < 4; i++) {
        char c = next_of(reading);
        const char *digit = c ? strchr(digits, c) : NULL;
        if (!digit)
            return json_fail(reading, "expected four hex digits after \\u");
        *code = *code << 4 | (unsigned long)((digit - digits) % 16);
        reading->at++;
    }
    return true;
}

/* Reads the digits after \u. A character above FFFF consists of two such escapes. */
static bool read_code(struct json_reading *reading, unsigned long *code)
{
    unsigned long low;
    if (!read_hex(reading, code))
        return false;
    if (*code == 0)
        return json_fail(reading, "a string must not contain a NUL");
    if (*code < 0xD800 || *code > 0xDFFF)
        return true;
    if (*code > 0xDBFF || !take_char(reading, '\\') || !take_char(reading, 'u')
        || !read_hex(reading, &low) || low < 0xDC00 || low > 0xDFFF)
        return json_fail(reading, "unpaired surrogate");
    *code = 0x10000 + ((*code - 0xD800) << 10) + (low - 0xDC00);
    return true;
}

/* Reads the part of an escape after its backslash. */
static bool read_escape(struct json_reading *reading, char **to)
{
    static const char names[] = "\"\\/bfnrt", meant[] = "\"\\/\b\f\n\r\t";
    char c = next_of(reading);
    const char *name = c ? strchr(names, c) : NULL;
    unsigned long code;
    if (name) {
        reading->at++;
        *(*to)++ = meant[name - names];
        return true;
    }
    if (!take_char(reading, 'u'))
        return json_fail(reading, "unknown escape");
    if (!read_code(reading, &code))
        return false;
    *to += utf8_put(*to, code);
    return true;
}

static bool read_character(struct json_reading *reading, char **to)
{
    size_t length;
    if (take_char(reading, '\\'))
        return read_escape(reading, to);
    length = utf8_length(reading->at, (size_t)(reading->end - reading->at));
    if (length == 0)
        return json_fail(reading, reading->at < reading->end ? "invalid UTF-8"
                                                             : "unterminated string");
    if ((unsigned char)*reading->at < ' ')
        return json_fail(reading, "a control character in a string");
    memcpy(*to, reading->at, length);
    *to += length;
    reading->at += length;
    return true;
}

/* Decodes a string in place, which is possible because it is never longer than its
 * escaped form. */
static const char *read_string(struct json_reading *reading)
{
    const char *close = reading->at + 1;
    char *text, *to;
    while (close < reading->end && *close != '"')
        close += *close == '\\' && close + 1 < reading->end ? 2 : 1;
    reading->at++;
    text = to = arena_take(reading->arena, (size_t)(close - reading->at) + 1);
    if (!text) {
        no_memory(reading);
        return NULL;
    }
    while (!take_char(reading, '"'))
        if (!read_character(reading, &to))
            return NULL;
    return text;
}

/* ---- Numbers and names ------------------------------------------------------ */

static bool skip_digits(struct json_reading *reading)
{
    const char *from = reading->at;
    while (next_of(reading) >= '0' && next_of(reading) <= '9')
        reading->at++;
    return reading->at > from;
}

static bool skip_number(struct json_reading *reading)
{
    take_char(reading, '-');
    if (!take_char(reading, '0') && !skip_digits(reading))
        return false;
    if (take_char(reading, '.') && !skip_digits(reading))
        return false;
    if (!take_char(reading, 'e') && !take_char(reading, 'E'))
        return true;
    if (!take_char(reading, '-'))
        take_char(reading, '+');
    return skip_digits(reading);
}

static bool read_number(struct json_reading *reading, struct json_value *value)
{
    const char *from = reading->at;
    char digits[MAX_DIGITS];
    size_t length;
    if (!skip_number(reading))
        return json_fail(reading, "expected a value");
    length = (size_t)(reading->at - from);
    if (length >= sizeof digits)
        return json_fail(reading,
                         "a number with " LIMIT_TEXT(MAX_DIGITS) " digits or more");
    memcpy(digits, from, length);
    digits[length] = '\0';
    value->kind = JSON_NUMBER;
    value->number = strtod(digits, NULL);
    return isfinite(value->number) || json_fail(reading, "a number above 1.8e308");
}

static bool take_name(struct json_reading *reading, const char *name)
{
    size_t length = strlen(name);
    if ((size_t)(reading->end - reading->at) < length
        || strncmp(reading->at, name, length) != 0)
        return false;
    reading->at += length;
    return true;
}

static bool read_constant(struct json_reading *reading, struct json_value *value)
{
    value->kind = JSON_TRUTH;
    value->truth = take_name(reading, "true");
    if (value->truth || take_name(reading, "false"))
        return true;
    value->kind = JSON_NULL;
    return take_name(reading, "null") || read_number(reading, value);
}

/* ---- Values ----------------------------------------------------------------- */

static bool read_value(struct json_reading *reading, struct json_value *value);

static bool read_key(struct json_reading *reading, struct json_value *value)
{
    skip_space(reading);
    if (next_of(reading) != '"')
        return json_fail(reading, "expected a key");
    value->key = read_string(reading);
    if (!value->key)
        return false;
    skip_space(reading);
    return take_char(reading, ':') || json_fail(reading, "expected ':'");
}

static struct json_value *read_item(struct json_reading *reading, bool has_key)
{
    struct json_value *item = arena_take(reading->arena, sizeof *item);
    if (!item) {
        no_memory(reading);
        return NULL;
    }
    if ((has_key && !read_key(reading, item)) || !read_value(reading, item))
        return NULL;
    skip_space(reading);
    return item;
}

/* Reads the items after the opening bracket. */
static bool read_items(struct json_reading *reading, struct json_value *value,
                       char closing)
{
    const struct json_value **last = &value->first;
    skip_space(reading);
    if (take_char(reading, closing))
        return true;
    do {
        struct json_value *item = read_item(reading, closing == '}');
        if (!item)
            return false;
        *last = item;
        last = &item->next;
    } while (take_char(reading, ','));
    return take_char(reading, closing)
           || json_fail(reading, "expected ',' or a closing bracket");
}

static bool read_within(struct json_reading *reading, struct json_value *value)
{
    char closing = value->kind == JSON_ARRAY ? ']' : '}';
    bool good;
    if (reading->depth == JSON_DEEPEST)
        return json_fail(reading,
                         "more than " LIMIT_TEXT(JSON_DEEPEST) " nested brackets");
    reading->depth++;
    good = read_items(reading, value, closing);
    reading->depth--;
    return good;
}

static bool read_value(struct json_reading *reading, struct json_value *value)
{
    skip_space(reading);
    if (next_of(reading) == '"') {
        value->kind = JSON_TEXT;
        value->text = read_string(reading);
        return value->text;
    }
    if (take_char(reading, '[')) {
        value->kind = JSON_ARRAY;
        return read_within(reading, value);
    }
    if (take_char(reading, '{')) {
        value->kind = JSON_OBJECT;
        return read_within(reading, value);
    }
    return read_constant(reading, value);
}

const struct json_value *json_read(struct arena *arena, const char *text, size_t length,
                                   c205_error *error)
{
    struct json_reading reading = { arena, text, text, text + length, 0, error };
    struct json_value *value = read_item(&reading, false);
    if (value && reading.at < reading.end) {
        json_fail(&reading, "expected the end of the text");
        return NULL;
    }
    return value;
}

/* ---- Members ---------------------------------------------------------------- */

const struct json_value *json_member(const struct json_value *object, const char *key)
{
    const struct json_value *member = object && object->kind == JSON_OBJECT
                                          ? object->first
                                          : NULL;
    while (member && strcmp(member->key, key) != 0)
        member = member->next;
    return member && member->kind != JSON_NULL ? member : NULL;
}

const char *json_member_text(const struct json_value *object, const char *key)
{
    const struct json_value *member = json_member(object, key);
    return member ? member->text : NULL;
}

const struct json_value *json_member_first(const struct json_value *object,
                                           const char *key)
{
    const struct json_value *member = json_member(object, key);
    return member ? member->first : NULL;
}

size_t json_length(const struct json_value *value)
{
    size_t count = 0;
    for (const struct json_value *item = value ? value->first : NULL; item;
         item = item->next)
        count++;
    return count;
}

bool json_member_truth(const struct json_value *object, const char *key, bool otherwise)
{
    const struct json_value *member = json_member(object, key);
    return member && member->kind == JSON_TRUTH ? member->truth : otherwise;
}

bool json_member_whole(const struct json_value *object, const char *key, int64_t *value)
{
    const struct json_value *member = json_member(object, key);
    if (!member)
        return true;
    if (member->kind != JSON_NUMBER || floor(member->number) != member->number
        || fabs(member->number) >= 0x1p53)
        return false;
    *value = (int64_t)member->number;
    return true;
}
