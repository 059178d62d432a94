/* incfile.c - .incfile: reads the numbers of a file as words.
 *
 * The fields of a line are separated by commas if it has one, otherwise by blanks. They
 * may be in quotes. A # starts a comment. The first line is a heading with the names of
 * the columns if no field of it is a number.
 */
#include "asm/text/shown_line.h"
#include "asm/text/statement.h"

#include <math.h>
#include <string.h>

struct number_file {
    struct cursor *cursor; /* cursor at the directive */
    struct line line;      /* the current line */
    const char *wanted;    /* name of the requested column, or NULL */
    size_t column;         /* its number from 1 on; 0: all columns */
    bool integers;
    bool begun;  /* a line was read */
    bool commas; /* the current line has commas */
    c205_word *words;
    size_t count, capacity;
};

/* A field of a line. It may be empty between two commas. */
struct csv_field {
    const char *begin, *end;
};

static const char *skip_blanks(const char *at, const char *end)
{
    while (at < end && (*at == ' ' || *at == '\t'))
        at++;
    return at;
}

/* Returns the end of a field: the position after its closing quote, or the position of
 * the separator. */
static const char *field_end(const struct number_file *file, const char *at)
{
    const char *end = file->line.end;
    const char *quote = *at == '"' && at + 1 < end
                            ? memchr(at + 1, '"', (size_t)(end - at - 1))
                            : NULL;
    if (quote)
        return quote + 1;
    while (at < end && !strchr(file->commas ? ",#" : " \t#", *at))
        at++;
    return at;
}

/* Removes trailing blanks and quotes of a field. */
static void trim(struct csv_field *field)
{
    while (field->end > field->begin && strchr(" \t", field->end[-1]))
        field->end--;
    if (field->end - field->begin > 1 && *field->begin == '"'
        && field->end[-1] == '"') {
        field->begin++;
        field->end--;
    }
}

/* Reads the next field and moves *at after it and its comma. Returns false if there is
 * none. */
static bool next_field(const struct number_file *file, const char **at,
                       struct csv_field *field)
{
    const char *end = file->line.end, *p = skip_blanks(*at, end);
    if (p == end || *p == '#')
        return false;
    field->begin = p;
    field->end = field_end(file, p);
    p = skip_blanks(field->end, end);
    *at = p < end && *p == ',' ? p + 1 : p;
    trim(field);
    return true;
}

static bool is_number(const struct csv_field *field, c205_word *word)
{
    const char *end;
    *word = c205_from_text(field->begin, &end);
    return end == field->end && end != field->begin;
}

static bool is_named(const struct csv_field *field, const char *name)
{
    size_t length = (size_t)(field->end - field->begin);
    return strlen(name) == length && memcmp(field->begin, name, length) == 0;
}

static bool fault(const struct number_file *file, const char *at, const char *what)
{
    const struct line *by = file->cursor->line;
    return report(file->cursor->assembler, &file->line, at, "%s (.incfile of %s:%zu)",
                  what, by->file, by->number);
}

/* ---- Lines ---------------------------------------------------------------- */

static bool is_heading(const struct number_file *file)
{
    const char *at = file->line.begin;
    struct csv_field field;
    c205_word word;
    while (next_field(file, &at, &field))
        if (is_number(&field, &word))
            return false;
    return true;
}

static bool find_column(struct number_file *file)
{
    const char *at = file->line.begin;
    struct csv_field field;
    if (!file->wanted)
        return true;
    for (size_t i = 1; next_field(file, &at, &field); i++)
        if (is_named(&field, file->wanted)) {
            file->column = i;
            return true;
        }
    return fault(file, file->line.begin, "the heading has no column of this name");
}

static bool add_number(struct number_file *file, const struct csv_field *field)
{
    c205_word word;
    double value;
    if (field->begin == field->end)
        return fault(file, field->begin, "expected a number before this");
    if (!is_number(field, &word))
        return fault(file, field->begin, "this is not a number");
    value = c205_to_double(word);
    if (file->integers && (fabs(value) >= 0x1p47 || value != floor(value)))
        return fault(file, field->begin, "expected an integer below 2^47");
    if (word == C205_INDEFINITE)
        return fault(file, field->begin,
                     "the number is outside the range of the machine");
    if (file->integers)
        word = c205_from_integer((int64_t)value);
    return arena_add(file->cursor->assembler->arena, &file->words, &file->count,
                     &file->capacity, &word, sizeof word);
}

static bool read_numbers(struct number_file *file)
{
    const char *at = file->line.begin;
    struct csv_field field;
    size_t i = 0;
    while (next_field(file, &at, &field))
        if ((++i == file->column || file->column == 0) && !add_number(file, &field))
            return false;
    return i == 0 || i >= file->column
           || fault(file, file->line.begin, "this line has too few columns");
}

static bool read_line(struct number_file *file)
{
    const char *at = file->line.begin;
    struct csv_field field;
    const char *comment = memchr(at, '#', (size_t)(file->line.end - at));
    file->commas = memchr(at, ',', (size_t)((comment ? comment : file->line.end) - at));
    if (!next_field(file, &at, &field))
        return true;
    if (!file->begun) {
        file->begun = true;
        if (is_heading(file))
            return find_column(file);
        if (file->wanted)
            return fault(file, file->line.begin,
                         "expected a heading with names of columns");
    }
    return read_numbers(file);
}

static bool read_lines(struct number_file *file, const struct asm_source *source)
{
    const char *at = source->text;
    file->line.file = source->name;
    while (at < source->end) {
        const char *end = memchr(at, '\n', (size_t)(source->end - at));
        end = end ? end : source->end;
        file->line.number++;
        file->line.begin = file->line.text = at;
        file->line.end = file->line.text_end = end;
        if (!read_line(file))
            return false;
        at = end + (end < source->end);
    }
    return file->begun || !file->wanted
           || report(file->cursor->assembler, file->cursor->line,
                     file->cursor->line->begin,
                     "'%.200s' has no heading with names of columns", source->name);
}

/* ---- The directive -------------------------------------------------------- */

static bool read_column(struct number_file *file)
{
    struct cursor *cursor = file->cursor;
    size_t length;
    int64_t column;
    if (file->wanted || file->column > 0)
        return report_at(cursor, cursor->token.begin, "at most one column is allowed");
    if (cursor->token.kind == TOKEN_STRING) {
        file->wanted = expect_string(cursor, &length);
        return file->wanted != NULL;
    }
    if (!parse_integer(cursor, 1, MAX_LINE, "a column", &column))
        return false;
    file->column = (size_t)column;
    return true;
}

/* Parses [, column] [, integers]. */
static bool read_expectations(struct number_file *file)
{
    struct cursor *cursor = file->cursor;
    while (cursor_take(cursor, ',')) {
        if (cursor->token.kind == TOKEN_NAME && token_is(&cursor->token, "integers")) {
            cursor_next(cursor);
            file->integers = true;
        } else if (!read_column(file)) {
            return false;
        }
    }
    return true;
}

bool parse_incfile(struct cursor *cursor)
{
    struct number_file file = { .cursor = cursor };
    struct asm_source source;
    c205_error error;
    const char *at = cursor->token.begin;
    /* Paths are relative to the file of the outermost line, not to that of a macro. */
    const char *from = outermost_line(cursor->line)->file;
    size_t length;
    const char *name = expect_string(cursor, &length);
    layout_align(cursor->assembler, 64);
    if (!name || !read_expectations(&file))
        return false;
    if (!source_find(cursor->assembler, name, from, &source, &error))
        return report_at(cursor, at, "cannot read '%.200s': %.200s", name,
                         error.message);
    return read_lines(&file, &source) && layout_known(cursor, file.words, file.count);
}
