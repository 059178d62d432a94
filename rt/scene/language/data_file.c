/* data_file.c - executes #fopen, #read, #write and #fclose, which read values from
 * files.
 *
 * A file is found as by #include, and read value by value: floats, vectors and strings,
 * with or without commas in between. After the last value has been read, the name of
 * the file is undeclared, as in POV-Ray, so that `defined` detects the end of the file.
 * #write is ignored, because reading a scene must not write files.
 */
#include "rt/scene/language/directive.h"

#include "rt/scene/language/declare.h"
#include "rt/scene/language/scene_expression.h"
#include "rt/scene/language/string_value.h"

#include <stdlib.h>
#include <string.h>

/* ---- #fopen, #fclose ----------------------------------------------------- */

static bool read_name(struct reader *reader, char **name)
{
    size_t hold = reader_nest(reader);
    bool done = file_name_read(reader, name);
    reader->hold = hold;
    return done;
}

/* Reads the mode after the file's name, and opens the file. */
static bool read_mode(struct reader *reader, const struct scene_token *at,
                      const char *name, struct data_file *file)
{
    const struct scene_token *mode = &reader->token;
    file->reads = is_token(mode, "read");
    if (!file->reads && !is_token(mode, "write") && !is_token(mode, "append"))
        return reader_expected(reader, "read, write or append");
    reader_step(reader);
    if (file->reads) {
        file->source = reader_find(reader, at, name, true);
        file->place.line = 1;
        return file->source;
    }
    reader_warn(reader, at, "files are not written: '#write' is ignored");
    return true;
}

static bool open_file(struct reader *reader, struct target *target)
{
    struct scene_value value = { .kind = VALUE_FILE };
    struct scene_token at;
    char *name;
    bool done;
    reader_resolve(reader);
    at = reader->token;
    if (!read_name(reader, &name))
        return false;
    done = read_mode(reader, &at, name, &value.is.file);
    free(name);
    return done
           && reader_check(reader, &target->name,
                           target_assign(reader, target, &value));
}

bool data_file_open(struct reader *reader, const struct item *item)
{
    struct target target = { .local = false };
    struct declared_name *symbol;
    bool done;
    (void)item;
    if (!target_read(reader, &target))
        return false;
    if (target.is_element)
        return reader_fault(reader, &target.name,
                            "an array element cannot be used as a file");
    symbol = target.name.reference.symbol;
    symbol_hold(symbol);
    done = open_file(reader, &target);
    symbol_release(symbol);
    return done;
}

/* Returns the open file that the current token names, or NULL after an error. */
static const struct data_file *expect_file(struct reader *reader)
{
    struct scene_token *token = &reader->token;
    if (reader_look_up(reader, token) && token->value->kind == VALUE_FILE)
        return &token->value->is.file;
    reader_expected(reader, "the name of an open file");
    return NULL;
}

/* Undeclares the name of a file. If the name is a parameter of a macro, the variable
 * that it refers to becomes a closed file instead, and the name is undeclared when the
 * macro ends. */
static void forget(struct reader *reader, const struct scene_token *name)
{
    const struct declared_name *own = symbols_find(&reader->symbols, name->text,
                                                   name->length);
    struct scene_value closed = { .kind = VALUE_FILE };
    if (own == name->reference.symbol)
        symbols_remove(&reader->symbols, name->text, name->length);
    else
        reference_assign(&name->reference, &closed);
}

bool data_file_close(struct reader *reader, const struct item *item)
{
    struct scene_token name;
    (void)item;
    if (!expect_file(reader))
        return false;
    name = reader->token;
    reader_step(reader);
    forget(reader, &name);
    return true;
}

/* ---- #read --------------------------------------------------------------- */

/* The state while a value is read from a file: `token` is the next token of the
 * file. */
struct datum {
    struct reader *reader;
    struct scene_token token;
};

static void next(struct datum *datum)
{
    datum->token = lexer_next(&datum->reader->lexer);
}

/* Reads one float, with an optional sign. */
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

static bool take_value(struct datum *datum, struct scene_value *value)
{
    memset(value, 0, sizeof *value);
    if (datum->token.kind == TOKEN_STRING) {
        value->kind = VALUE_STRING;
        if (!quoted_read(datum->reader, &datum->token, &value->is.string))
            return false;
        next(datum);
        return true;
    }
    value->kind = VALUE_NUMBERS;
    if (token_is_sign(&datum->token, '<'))
        return take_vector(datum, &value->is.numbers);
    value->is.numbers = numbers_of(0);
    return take_float(datum, value->is.numbers.n);
}

/* Reads a value and the optional comma after it. */
static bool take_datum(struct datum *datum, const struct data_file *file,
                       const struct scene_token *at, struct scene_value *value)
{
    if (!take_value(datum, value))
        return reader_fault(datum->reader, at,
                            "line %zu of '%s' has no value to read: expected "
                            "a number, a vector or a string",
                            datum->token.place.line, file->source->name);
    if (token_is_sign(&datum->token, ','))
        next(datum);
    return true;
}

/* Reads the next value of the file, and moves the file's cursor to the token after it.
 * The text of the file is read in a temporary frame. At the end of the file,
 * file->source becomes NULL. If the file has no more values, the value is
 * VALUE_FAULTY. */
static bool read_datum(struct reader *reader, struct data_file *file,
                       const struct scene_token *at, struct scene_value *value)
{
    struct datum datum = { .reader = reader };
    size_t begin = file->place.at, end;
    bool done = true;
    *value = (struct scene_value){ .kind = VALUE_FAULTY };
    if (!file->source)
        return true;
    if (!lexer_call(&reader->lexer, file->source, file->place, file->source->length,
                    at))
        return reader_fault(reader, at, "more than %d nested files and macros",
                            MAX_FRAMES);
    next(&datum);
    if (datum.token.kind != TOKEN_END)
        done = take_datum(&datum, file, at, value);
    end = lexer_top(&reader->lexer)->place.at;
    lexer_close(&reader->lexer);
    file->place = datum.token.place;
    if (datum.token.kind == TOKEN_END)
        file->source = NULL;
    if (reader_spend(reader, end - begin + TOKEN_COST) && done)
        return true;
    value_free(value);
    return false;
}

/* Reads a value of the file into the next variable of a #read. After the end of the
 * file, the variable is not changed. */
static bool read_next(struct reader *reader, struct data_file *file)
{
    struct target target = { .local = false };
    struct scene_value value;
    if (!target_read(reader, &target)
        || !read_datum(reader, file, &target.name, &value))
        return false;
    return value.kind == VALUE_FAULTY
           || reader_check(reader, &target.name,
                           target_assign(reader, &target, &value));
}

/* Reads "(" and the name of a file that is open for reading, or for writing. */
static const struct data_file *read_handle(struct reader *reader, bool reads)
{
    const struct data_file *file;
    if (!reader_require_sign(reader, '('))
        return NULL;
    reader_step(reader);
    file = expect_file(reader);
    if (!file || (file->reads == reads && (file->source || !reads)))
        return file;
    reader_fault(reader, &reader->token, "the file is not open for %s",
                 reads ? "reading" : "writing");
    return NULL;
}

static bool read_all(struct reader *reader, const struct scene_token *name,
                     struct data_file *file)
{
    struct scene_value value = { .kind = VALUE_FILE };
    while (!reader_at_sign(reader, ')')) {
        if (reader_at_sign(reader, ','))
            reader_step(reader);
        if (!read_next(reader, file))
            return false;
    }
    reader_step(reader);
    value.is.file = *file;
    if (file->source)
        return reader_check(reader, name, reference_assign(&name->reference, &value));
    forget(reader, name);
    return true;
}

bool data_file_read(struct reader *reader, const struct item *item)
{
    const struct data_file *open = read_handle(reader, true);
    struct scene_token name = reader->token;
    struct data_file file;
    bool done;
    (void)item;
    if (!open)
        return false;
    file = *open;
    reader_step(reader);
    symbol_hold(name.reference.symbol);
    done = read_all(reader, &name, &file);
    symbol_release(name.reference.symbol);
    return done;
}

/* ---- #write -------------------------------------------------------------- */

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

bool data_file_write(struct reader *reader, const struct item *item)
{
    (void)item;
    if (!read_handle(reader, false))
        return false;
    reader_next(reader);
    reader_comma(reader);
    while (!reader_at_sign(reader, ')')) {
        if (!read_written(reader))
            return false;
        reader_comma(reader);
    }
    reader_step(reader);
    return true;
}
