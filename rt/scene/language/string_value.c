/* string_value.c - parses strings: quoted, named, and results of functions. */
#include "rt/scene/language/string_value.h"

#include "rt/scene/language/scene_expression.h"
#include "base/plural.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_FORMAT = 1000, MAX_PRINTED = 2 * MAX_FORMAT + 400 };

/* ---- Text under construction --------------------------------------------- */

struct made_string {
    char *text;
    size_t length;
    bool full; /* too long, or out of memory */
};

static void add(struct made_string *buffer, const char *text, size_t length)
{
    char *grown;
    if (buffer->full || length > STRING_LONGEST - buffer->length) {
        buffer->full = true;
        return;
    }
    grown = realloc(buffer->text, buffer->length + length + 1);
    if (!grown) {
        buffer->full = true;
        return;
    }
    memcpy(grown + buffer->length, text, length);
    buffer->text = grown;
    buffer->length += length;
    grown[buffer->length] = '\0';
}

/* Moves the text of the buffer to *string, or frees it after an error. */
static bool give(struct reader *reader, const struct scene_token *at,
                 struct made_string *buffer, bool good, char **string)
{
    add(buffer, "", 0);
    if (good && buffer->full)
        good = reader_fault(reader, at,
                            "the string is longer than %d, or there is not "
                            "enough memory",
                            STRING_LONGEST);
    if (good && !reader_spend(reader, buffer->length))
        good = false;
    if (good)
        *string = buffer->text;
    else
        free(buffer->text);
    return good;
}

/* ---- Quoted strings ------------------------------------------------------ */

static void add_utf8(struct made_string *buffer, unsigned code)
{
    char bytes[3];
    size_t length = code < 0x80 ? 1 : code < 0x800 ? 2 : 3;
    for (size_t i = length; --i > 0; code >>= 6)
        bytes[i] = (char)(0x80 | (code & 0x3f));
    bytes[0] = (char)(length == 1 ? code : length == 2 ? 0xc0 | code : 0xe0 | code);
    add(buffer, bytes, length);
}

static int hex_digit(char c)
{
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    const char *found = c ? strchr(digits, c) : NULL;
    return found ? (int)((found - digits) % 16) : -1;
}

/* Decodes the XXXX of \uXXXX. Returns 0 if it is not valid. */
static unsigned read_code(const char *text, size_t length)
{
    unsigned code = 0;
    if (length < 4)
        return 0;
    for (size_t i = 0; i < 4; i++) {
        int digit = hex_digit(text[i]);
        if (digit < 0)
            return 0;
        code = code * 16 + (unsigned)digit;
    }
    return code;
}

/* Decodes the escape sequence after a backslash. Returns its length in bytes, or 0 if
 * it is not valid. */
static size_t add_escape(struct made_string *buffer, const char *text, size_t length)
{
    static const char names[] = "abfnrtv\\'\"";
    static const char bytes[] = "\a\b\f\n\r\t\v\\'\"";
    const char *found = *text ? strchr(names, *text) : NULL;
    unsigned code = *text == 'u' ? read_code(text + 1, length - 1) : 0;
    if (code) {
        add_utf8(buffer, code);
        return 5;
    }
    if (!found)
        return 0;
    add(buffer, bytes + (found - names), 1);
    return 1;
}

static bool add_quoted(struct reader *reader, const struct scene_token *token,
                       struct made_string *buffer)
{
    const char *text = token->text, *end = text + token->length;
    while (text < end) {
        size_t escaped = 1;
        if (*text == '\0')
            return reader_fault(reader, token, "the string contains a NUL byte");
        if (*text != '\\')
            add(buffer, text, 1);
        else
            escaped = add_escape(buffer, text + 1, (size_t)(end - text) - 1);
        if (!escaped)
            return reader_fault(reader, token,
                                "the string contains an unknown escape sequence");
        text += *text == '\\' ? escaped + 1 : 1;
    }
    return true;
}

/* ---- Functions ----------------------------------------------------------- */

typedef bool function_reader(struct reader *reader, struct made_string *buffer);

static bool read_concat(struct reader *reader, struct made_string *buffer)
{
    do {
        char *part;
        if (!string_read(reader, &part))
            return false;
        add(buffer, part, strlen(part));
        free(part);
    } while (reader_accept_sign(reader, ','));
    return true;
}

/* Reads ", L, P" of str(A, L, P). L is the width; a negative width selects zero
 * padding. P is the number of decimals; a negative number selects 6. */
static bool read_format(struct reader *reader, int *width, int *digits)
{
    struct scene_token at = reader->token;
    double given[2];
    for (int i = 0; i < 2; i++)
        if (!reader_expect_sign(reader, ',') || !read_full_number(reader, &given[i]))
            return false;
    for (int i = 0; i < 2; i++)
        if (given[i] < -MAX_FORMAT || given[i] > MAX_FORMAT)
            return reader_fault(reader, &at, "width and digits must be at most %d",
                                MAX_FORMAT);
    *width = (int)given[0];
    *digits = (int)given[1];
    return true;
}

static void add_number(struct made_string *buffer, double value, int width, int digits)
{
    char text[MAX_PRINTED];
    if (width < 0)
        snprintf(text, sizeof text, "%0*.*f", -width, digits, value);
    else
        snprintf(text, sizeof text, "%*.*f", width, digits, value);
    add(buffer, text, strlen(text));
}

static bool read_str(struct reader *reader, struct made_string *buffer)
{
    double value;
    int width, digits;
    if (!read_full_number(reader, &value) || !read_format(reader, &width, &digits))
        return false;
    add_number(buffer, value, width, digits);
    return true;
}

static bool read_vstr(struct reader *reader, struct made_string *buffer)
{
    struct scene_token at = reader->token;
    double count;
    struct numbers vector;
    char *between = NULL;
    int width, digits;
    bool done;
    if (!read_full_number(reader, &count) || !reader_expect_sign(reader, ',')
        || !read_full(reader, &vector) || !reader_expect_sign(reader, ',')
        || !string_read(reader, &between))
        return false;
    done = read_format(reader, &width, &digits);
    if (done && !(count >= 2 && count <= COLOR_TERMS))
        done = reader_fault(reader, &at,
                            "a vector must have between 2 and %d components",
                            COLOR_TERMS);
    for (int i = 0; done && i < (int)count; i++) {
        if (i)
            add(buffer, between, strlen(between));
        add_number(buffer, vector.n[i], width, digits);
    }
    free(between);
    return done;
}

static bool read_chr(struct reader *reader, struct made_string *buffer)
{
    struct scene_token at = reader->token;
    double code;
    if (!read_full_number(reader, &code))
        return false;
    if (!(code >= 1 && code < 0x10000))
        return reader_fault(reader, &at, "%g is not a character code", code);
    add_utf8(buffer, (unsigned)code);
    return true;
}

static bool read_range(struct reader *reader, size_t length, size_t *from,
                       size_t *count)
{
    struct scene_token at = reader->token;
    double first, wanted;
    *from = *count = 0;
    if (!reader_expect_sign(reader, ',') || !read_full_number(reader, &first)
        || !reader_expect_sign(reader, ',') || !read_full_number(reader, &wanted))
        return false;
    if (!(first >= 1 && wanted >= 0 && first - 1 + wanted <= (double)length))
        return reader_fault(reader, &at, "the string has only %zu character%s", length,
                            plural(length));
    *from = (size_t)first - 1;
    *count = (size_t)wanted;
    return true;
}

static bool read_substr(struct reader *reader, struct made_string *buffer)
{
    char *whole;
    size_t from, count;
    bool done;
    if (!string_read(reader, &whole))
        return false;
    done = read_range(reader, strlen(whole), &from, &count);
    if (done)
        add(buffer, whole + from, count);
    free(whole);
    return done;
}

/* Reads a string, and changes the case of its letters that are among the 26 letters
 * from `first` on. */
static bool read_cased(struct reader *reader, struct made_string *buffer, char first,
                       int change)
{
    char *text;
    if (!string_read(reader, &text))
        return false;
    for (char *c = text; *c; c++)
        if (*c >= first && *c < first + 26)
            *c = (char)(*c + change);
    add(buffer, text, strlen(text));
    free(text);
    return true;
}

static bool read_strlwr(struct reader *reader, struct made_string *buffer)
{
    return read_cased(reader, buffer, 'A', 'a' - 'A');
}

static bool read_strupr(struct reader *reader, struct made_string *buffer)
{
    return read_cased(reader, buffer, 'a', 'A' - 'a');
}

static const struct string_function {
    const char *name;
    function_reader *read; /* reads the arguments */
} functions[] = {
    { "chr", read_chr },       { "concat", read_concat }, { "str", read_str },
    { "strlwr", read_strlwr }, { "strupr", read_strupr }, { "substr", read_substr },
    { "vstr", read_vstr },
};

/* ---- Strings ------------------------------------------------------------- */

bool is_string_word(const struct scene_token *token)
{
    return TOKEN_ROW(token, functions);
}

bool starts_string(const struct reader *reader)
{
    return reader->token.kind == TOKEN_STRING || TOKEN_ROW(&reader->token, functions)
           || reader_value_of(reader, VALUE_STRING);
}

/* Reads a call of a string function. Its closing parenthesis stays the current
 * token. */
static bool read_call(struct reader *reader, const struct string_function *function,
                      struct made_string *buffer)
{
    size_t hold = reader_nest(reader);
    bool done = false;
    if (reader_enter(reader)) {
        reader_next(reader);
        done = reader_expect_sign(reader, '(') && function->read(reader, buffer)
               && reader_require_sign(reader, ')');
        reader_leave(reader);
    }
    reader->hold = hold;
    return done;
}

bool string_read(struct reader *reader, char **string)
{
    struct scene_token at = reader->token;
    const struct string_function *function = TOKEN_ROW(&at, functions);
    const struct scene_value *named = reader_value_of(reader, VALUE_STRING);
    struct made_string buffer = { NULL, 0, false };
    bool done = true;
    if (named)
        add(&buffer, named->is.string, strlen(named->is.string));
    else if (at.kind == TOKEN_STRING)
        done = add_quoted(reader, &at, &buffer);
    else if (function)
        done = read_call(reader, function, &buffer);
    else
        done = reader_expected(reader, "a string");
    if (done || at.kind == TOKEN_STRING)
        reader_pass(reader);
    return give(reader, &at, &buffer, done, string);
}

bool quoted_read(struct reader *reader, const struct scene_token *token, char **string)
{
    struct made_string buffer = { NULL, 0, false };
    bool done = add_quoted(reader, token, &buffer);
    return give(reader, token, &buffer, done, string);
}

bool file_name_read(struct reader *reader, char **name)
{
    struct scene_token at = reader->token;
    struct made_string buffer = { NULL, 0, false };
    if (at.kind != TOKEN_STRING || memchr(at.text, '\0', at.length))
        return string_read(reader, name);
    add(&buffer, at.text, at.length);
    reader_pass(reader);
    return give(reader, &at, &buffer, true, name);
}

bool string_read_within(struct reader *reader, char **string)
{
    size_t hold = reader_nest(reader);
    bool done = string_read(reader, string);
    reader->hold = hold;
    return done;
}
