/* incfile.c - .incfile: words from the numbers of a file.
 *
 * Fields stand between commas, or blanks; a # begins a comment.  A first line of which a
 * field is no number is a heading, the names of the columns, which may stand in quotes.
 */
#include "asm/source.h"
#include "asm/statement.h"

#include <math.h>
#include <string.h>

struct number_file {
    struct cursor *cursor; /* at the directive */
    struct line line;      /* the one that is being read */
    const char *wanted;    /* a column's name, or NULL */
    size_t column;         /* its number, from 1; 0: all of them */
    bool integers, begun;  /* begun: a line has been read */
    c205_word *words;
    size_t count, capacity;
};

/* Empty between two commas. */
struct csv_field {
    const char *begin, *end;
};

static const char *skip_blanks(const char *at, const char *end)
{
    while (at < end && (*at == ' ' || *at == '\t' || *at == '\r'))
        at++;
    return at;
}

static const char *field_end(const char *at, const char *end)
{
    const char *quote = *at == '"' && at + 1 < end
                            ? memchr(at + 1, '"', (size_t)(end - at - 1))
                            : NULL;

    if (quote)
        return quote + 1;
    while (at < end && !strchr(" \t\r,#", *at))
        at++;
    return at;
}

/* The next field, *at moved behind it and its comma; false: there is none. */
static bool next_field(const char **at, const char *end,
                       struct csv_field *field)
{
    const char *p = skip_blanks(*at, end);

    if (p == end || *p == '#')
        return false;
    field->begin = p;
    field->end = field_end(p, end);
    p = skip_blanks(field->end, end);
    *at = p < end && *p == ',' ? p + 1 : p;
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
    size_t quotes = *field->begin == '"' && field->end[-1] == '"'
                    && field->end - field->begin > 1;
    size_t length = (size_t)(field->end - field->begin) - 2 * quotes;

    return strlen(name) == length
           && memcmp(field->begin + quotes, name, length) == 0;
}

static bool fault(const struct number_file *file, const char *at,
                  const char *what)
{
    const struct line *by = file->cursor->line;

    return report(file->cursor->assembler, &file->line, at,
                  "%s (.incfile of %s:%zu)", what, by->file, by->number);
}

/* ---- Lines ---------------------------------------------------------------- */

static bool is_heading(const struct number_file *file)
{
    const char *at = file->line.begin;
    struct csv_field field;
    c205_word word;

    while (next_field(&at, file->line.end, &field))
        if (!is_number(&field, &word) && field.end > field.begin)
            return true;
    return false;
}

static bool find_column(struct number_file *file)
{
    const char *at = file->line.begin;
    struct csv_field field;

    if (!file->wanted)
        return true;
    for (size_t i = 1; next_field(&at, file->line.end, &field); i++)
        if (is_named(&field, file->wanted)) {
            file->column = i;
            return true;
        }
    return fault(file, file->line.begin,
                 "this heading has no column of that name");
}

static bool add_number(struct number_file *file,
                       const struct csv_field *field)
{
    c205_word word, *grown;
    double value;

    if (field->begin == field->end)
        return fault(file, field->begin, "expected a number before this");
    if (!is_number(field, &word))
        return fault(file, field->begin, "this is not a number");
    value = c205_to_double(word);
    if (file->integers && (fabs(value) >= 0x1p47 || value != floor(value)))
        return fault(file, field->begin,
                     "expected an integer of less than 2^47");
    if (word == C205_INDEFINITE)
        return fault(file, field->begin, "the machine has no such number");
    if (file->integers)
        word = c205_from_integer((int64_t)value);
    grown = arena_grow(file->cursor->assembler->arena, file->words,
                       file->count, &file->capacity, sizeof *grown);
    if (!grown)
        return false;
    file->words = grown;
    grown[file->count++] = word;
    return true;
}

static bool read_numbers(struct number_file *file)
{
    const char *at = file->line.begin;
    struct csv_field field;
    size_t i = 0;

    while (next_field(&at, file->line.end, &field))
        if ((++i == file->column || file->column == 0)
            && !add_number(file, &field))
            return false;
    return i == 0 || i >= file->column
           || fault(file, file->line.begin,
                    "this line has not so many columns");
}

static bool read_line(struct number_file *file)
{
    const char *at = file->line.begin;
    struct csv_field field;

    if (!next_field(&at, file->line.end, &field))
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

static bool read_lines(struct number_file *file,
                       const struct asm_source *source)
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
    return true;
}

/* ---- The directive -------------------------------------------------------- */

/* The file that includes are relative to: not one whose macro is called. */
static const char *file_of(const struct line *line)
{
    while (line->caller)
        line = line->caller;
    return line->file;
}

/* [, column] [, integers] */
static bool read_wishes(struct number_file *file)
{
    struct cursor *cursor = file->cursor;
    int64_t column;

    while (cursor_take(cursor, ',')) {
        size_t length;

        if (cursor->token.kind == TOKEN_NAME
            && token_is(&cursor->token, "integers")) {
            cursor_next(cursor);
            file->integers = true;
        } else if (cursor->token.kind == TOKEN_STRING) {
            file->wanted = expect_string(cursor, &length);
            if (!file->wanted)
                return false;
        } else if (parse_integer(cursor, 1, MAX_LINE, "a column", &column)) {
            file->column = (size_t)column;
        } else {
            return false;
        }
    }
    return true;
}

bool parse_incfile(struct cursor *cursor)
{
    struct number_file file = { .cursor = cursor };
    struct asm_source source;
    const char *at = cursor->token.begin;
    size_t length;
    const char *name = expect_string(cursor, &length);

    layout_align(cursor->assembler, 64);
    if (!name || !read_wishes(&file))
        return false;
    if (!source_find(cursor->assembler, name, file_of(cursor->line), &source))
        return report(cursor->assembler, cursor->line, at,
                      "'%.200s' cannot be read, or is nowhere to be found",
                      name);
    return read_lines(&file, &source)
           && layout_known(cursor, file.words, file.count);
}
