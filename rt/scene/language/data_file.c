/* data_file.c - the directives of files. */
#include "rt/scene/language/data_file.h"

#include "rt/scene/language/declare.h"
#include "rt/scene/language/expression.h"
#include "rt/scene/language/string_value.h"

#include <stdlib.h>
#include <string.h>

/* ---- #fopen, #fclose ---------------------------------------------------- */

static bool find_file(struct reader *reader, const struct scene_token *at,
                      const char *name, struct scene_value *value)
{
    value->is.file.source = reader_find(reader, at, name);
    value->is.file.place.line = 1;
    return value->is.file.source;
}

/* Behind the file's name. */
static bool read_mode(struct reader *reader, const struct scene_token *at,
                      const char *name, struct scene_value *value)
{
    const struct scene_token *mode = &reader->token;
    bool reads = is_token(mode, "read");

    if (!reads && !is_token(mode, "write") && !is_token(mode, "append"))
        return reader_expected(reader, "read, write or append");
    reader_step(reader);
    if (reads)
        return find_file(reader, at, name, value);
    reader_report(reader, at,
                  "no file is written: what is given to '#write' "
                  "is left out");
    return true;
}

bool data_file_open(struct reader *reader, void *subject,
                    const struct item *item)
{
    struct scene_value value = { .kind = VALUE_FILE };
    struct target target = { .local = false };
    struct scene_token at;
    char *name;
    bool done;

    (void)subject;
    (void)item;
    if (!target_read(reader, &target))
        return false;
    reader_settle(reader);
    at = reader->token;
    if (!string_read_within(reader, &name))
        return false;
    done = read_mode(reader, &at, name, &value);
    free(name);
    return done
           && reader_check(reader, &target.name,
                           target_assign(reader, &target, &value));
}

/* The name of a file that is open; NULL after an error. */
static const struct scene_value *expect_file(struct reader *reader)
{
    struct scene_token *token = &reader->token;

    if (reader_look_up(reader, token) && token->value->kind == VALUE_FILE)
        return token->value;
    reader_expected(reader, "the name of an open file");
    return NULL;
}

bool data_file_close(struct reader *reader, void *subject,
                     const struct item *item)
{
    struct scene_token name = reader->token;

    (void)subject;
    (void)item;
    if (!expect_file(reader))
        return false;
    symbols_remove(&reader->symbols, name.text, name.length);
    reader_step(reader);
    return true;
}

/* ---- #read -------------------------------------------------------------- */

/* The next token of the file, and where it is. */
struct datum {
    struct lexer *lexer;
    struct scene_token token;
};

static void next(struct datum *datum)
{
    datum->token = lexer_next(datum->lexer);
}

/* One float, perhaps with a sign before it. */
static bool take_float(struct datum *datum, double *value)
{
    bool minus = token_is_sign(&datum->token, '-');

    if (minus || token_is_sign(&datum->token, '+'))
        next(datum);
    if (datum->token.kind != TOKEN_NUMBER || datum->token.fault)
        return false;
    *value = minus ? -datum->token.number : datum->token.number;
    next(datum);
    return true;
}

static bool take_vector(struct datum *datum, struct numbers *numbers)
{
    *numbers = numbers_of(0);
    numbers->count = 0;
    next(datum);
    do {
        if (numbers->count == COLOR_TERMS
            || !take_float(datum, &numbers->n[numbers->count++]))
            return false;
        if (token_is_sign(&datum->token, ','))
            next(datum);
    } while (!token_is_sign(&datum->token, '>'));
    next(datum);
    return numbers->count > 1;
}

static bool take_string(struct datum *datum, struct scene_value *value)
{
    size_t length = datum->token.length;

    value->kind = VALUE_STRING;
    value->is.string = malloc(length + 1);
    if (!value->is.string)
        return false;
    memcpy(value->is.string, datum->token.text, length);
    value->is.string[length] = '\0';
    next(datum);
    return true;
}

static bool take_value(struct datum *datum, struct scene_value *value)
{
    memset(value, 0, sizeof *value);
    if (datum->token.kind == TOKEN_STRING && !datum->token.fault
        && datum->token.length <= STRING_LONGEST
        && !memchr(datum->token.text, '\0', datum->token.length))
        return take_string(datum, value);
    value->kind = VALUE_NUMBERS;
    if (token_is_sign(&datum->token, '<'))
        return take_vector(datum, &value->is.numbers);
    value->is.numbers = numbers_of(0);
    return take_float(datum, value->is.numbers.n);
}

/* The next value of the file, which goes on behind it, or has no source any
 * more at its end.  The file's frame lies on the others meanwhile. */
static bool read_datum(struct reader *reader, struct data_file *file,
                       const struct scene_token *at,
                       struct scene_value *value)
{
    struct datum datum = { .lexer = &reader->lexer };
    bool done;

    if (!lexer_call(datum.lexer, file->source, file->place,
                    file->source->length, at))
        return reader_fault(reader, at,
                            "more than %d files and macros lie "
                            "within each other",
                            FRAMES_MOST);
    next(&datum);
    done = take_value(&datum, value);
    if (done && token_is_sign(&datum.token, ','))
        next(&datum);
    lexer_close(datum.lexer);
    if (!done)
        return reader_fault(reader, at,
                            "line %zu of '%s' has no value to read: expected "
                            "a number, a vector or a string",
                            datum.token.place.line, file->source->name);
    if (!reader_spend(reader,
                      datum.token.place.at - file->place.at + TOKEN_COST)) {
        value_free(value);
        return false;
    }
    file->place = datum.token.place;
    if (datum.token.kind == TOKEN_END)
        file->source = NULL;
    return true;
}

static bool read_next(struct reader *reader, struct data_file *file)
{
    struct target target = { .local = false };
    struct scene_value value;

    if (!target_read(reader, &target))
        return false;
    if (!file->source)
        return reader_fault(reader, &target.name,
                            "there is no value left in the file");
    return read_datum(reader, file, &target.name, &value)
           && reader_check(reader, &target.name,
                           target_assign(reader, &target, &value));
}

/* "(" and the name of a file. */
static const struct scene_value *read_handle(struct reader *reader)
{
    if (!reader_at_sign(reader, '(')) {
        reader_expected(reader, "'('");
        return NULL;
    }
    reader_step(reader);
    return expect_file(reader);
}

static bool go_on(struct reader *reader, const struct scene_token *name,
                  const struct data_file *file)
{
    struct scene_value value = { .kind = VALUE_FILE, .is.file = *file };

    if (file->source)
        return reader_check(reader, name,
                            reference_assign(&name->reference, &value));
    symbols_remove(&reader->symbols, name->text, name->length);
    return true;
}

bool data_file_read(struct reader *reader, void *subject,
                    const struct item *item)
{
    const struct scene_value *value = read_handle(reader);
    struct scene_token name = reader->token;
    struct data_file file;

    (void)subject;
    (void)item;
    if (!value)
        return false;
    file = value->is.file;
    if (!file.source)
        return reader_fault(reader, &name, "the file is not open to be read");
    reader_step(reader);
    while (reader_at_sign(reader, ',')) {
        reader_step(reader);
        if (!read_next(reader, &file))
            return false;
    }
    if (!reader_at_sign(reader, ')'))
        return reader_expected(reader, "')'");
    reader_step(reader);
    return go_on(reader, &name, &file);
}

/* ---- #write ------------------------------------------------------------- */

static bool read_written(struct reader *reader)
{
    struct numbers numbers;
    char *string;

    if (!starts_string(reader))
        return read_full(reader, &numbers);
    if (!string_read_within(reader, &string))
        return false;
    free(string);
    return true;
}

bool data_file_write(struct reader *reader, void *subject,
                     const struct item *item)
{
    (void)subject;
    (void)item;
    if (!read_handle(reader))
        return false;
    reader_next(reader);
    while (reader_accept_sign(reader, ','))
        if (!read_written(reader))
            return false;
    if (!reader_at_sign(reader, ')'))
        return reader_expected(reader, "')'");
    reader_step(reader);
    return true;
}
