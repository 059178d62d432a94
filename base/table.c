/* table.c - stores the cells of a table and writes them as text, Markdown, CSV or JSON.
 */
#include "base/table.h"

#include "base/array.h"
#include "base/word_wrap.h"
#include "base/sink.h"
#include "base/visible_text.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A number may have as many digits as the largest double. */
enum { NUMBER_SIZE = DBL_MAX_10_EXP + 32, FIRST_ROOM = 64 };
static const char between[] = "  ";

struct cell {
    char *text; /* printed text, with escapes (base/visible_text.h) */
    char *raw;  /* original text; JSON has other escapes */
    bool empty;
    union {
        uint64_t count;
        double number;
    } value;
};

struct table {
    struct table_column *columns;
    size_t column_count;
    size_t cell_count;
    struct cell *cells;
    bool failed;
};

struct table *table_new(const struct table_column *columns, size_t count)
{
    struct table *table = calloc(1, sizeof *table);
    if (!table)
        return NULL;
    table->columns = malloc(count * sizeof *columns);
    if (!table->columns) {
        free(table);
        return NULL;
    }
    memcpy(table->columns, columns, count * sizeof *columns);
    table->column_count = count;
    return table;
}

void table_free(struct table *table)
{
    if (!table)
        return;
    for (size_t i = 0; i < table->cell_count; i++) {
        free(table->cells[i].text);
        free(table->cells[i].raw);
    }
    free(table->cells);
    free(table->columns);
    free(table);
}

static char *copy(const char *text)
{
    char *own = malloc(strlen(text) + 1);
    return own ? strcpy(own, text) : NULL;
}

/* Stores the original and the printed text of a cell. Returns false if the host is out
 * of memory. */
static bool set_text(struct cell *cell, const char *text)
{
    struct text_buffer shown = { 0 };
    struct sink sink = text_buffer_sink(&shown);
    visible_put_lines(&sink, text, strlen(text));
    cell->raw = copy(text);
    cell->text = copy(shown.text ? shown.text : "");
    bool good = !shown.failed && cell->raw && cell->text;
    text_buffer_free(&shown);
    return good;
}

static void add_cell(struct table *table, const char *text, struct cell cell)
{
    if (!set_text(&cell, text)
        || !array_add(&table->cells, &table->cell_count, &cell, sizeof cell)) {
        free(cell.text);
        free(cell.raw);
        table->failed = true;
    }
}

void table_text(struct table *table, const char *text)
{
    add_cell(table, text, (struct cell){ .empty = false });
}

void table_gap(struct table *table)
{
    add_cell(table, "", (struct cell){ .empty = true });
}

void table_count(struct table *table, uint64_t value)
{
    char text[NUMBER_SIZE];
    snprintf(text, sizeof text, "%" PRIu64, value);
    add_cell(table, text, (struct cell){ .value.count = value });
}

static void add_number(struct table *table, const char *format, double value,
                       int decimals)
{
    char text[NUMBER_SIZE];
    if (isnan(value)) {
        table_gap(table);
        return;
    }
    snprintf(text, sizeof text, format, decimals, value);
    add_cell(table, text, (struct cell){ .value.number = value });
}

void table_signed(struct table *table, double value, int decimals)
{
    add_number(table, "%+.*f", value, decimals);
}

void table_rounded(struct table *table, double value, int decimals)
{
    enum { MAX_DECIMALS = 15 };
    double size = value != 0 ? floor(log10(fabs(value))) : 0;
    if (value == 0 || (decimals <= MAX_DECIMALS && size < MAX_DECIMALS))
        add_number(table, "%.*f", value,
                   decimals < 0 || decimals > MAX_DECIMALS ? 0 : decimals);
    else
        add_number(table, "%.*e", value,
                   (int)fmax(0, fmin(decimals + size, MAX_DECIMALS)));
}

void table_number(struct table *table, double value)
{
    size_t column = table->cell_count % table->column_count;
    table_rounded(table, value, table->columns[column].decimals);
}

size_t table_rows(const struct table *table)
{
    return table->cell_count / table->column_count;
}

const char *table_key(const struct table *table, size_t column)
{
    return table->columns[column].key;
}

double table_value(const struct table *table, size_t row, size_t column)
{
    const struct cell *cell = &table->cells[row * table->column_count + column];
    enum table_kind kind = table->columns[column].kind;
    if (cell->empty || kind == TABLE_TEXT)
        return NAN;
    return kind == TABLE_COUNT ? (double)cell->value.count : cell->value.number;
}

bool table_is_whole(const struct table *table)
{
    return !table->failed;
}

/* ---- Aligned columns ---------------------------------------------------- */

typedef size_t measure_text(const char *text);

static size_t column_width(const struct table *table, size_t column,
                           measure_text *length_of)
{
    size_t width = length_of(table->columns[column].heading);
    for (size_t i = column; i < table->cell_count; i += table->column_count) {
        size_t length = length_of(table->cells[i].text);
        width = length > width ? length : width;
    }
    return width;
}

/* Returns the width of each column; the caller frees the array. NULL: out of memory. */
static size_t *widths_of(const struct table *table, measure_text *length_of)
{
    size_t *widths = malloc(table->column_count * sizeof *widths);
    for (size_t i = 0; widths && i < table->column_count; i++)
        widths[i] = column_width(table, i, length_of);
    return widths;
}

size_t table_width(const struct table *table)
{
    size_t *widths = widths_of(table, strlen);
    size_t width = 0;
    for (size_t i = 0; widths && i < table->column_count; i++)
        width += widths[i] + (i > 0 ? strlen(between) : 0);
    free(widths);
    return widths ? width : SIZE_MAX;
}

static void plain_cell(const struct table *table, size_t column, const size_t *widths,
                       const char *text, FILE *file)
{
    bool last = column + 1 == table->column_count;
    size_t begins = 0;
    if (table->columns[column].kind != TABLE_TEXT) {
        fprintf(file, "%*s%s", (int)widths[column], text, last ? "\n" : between);
    } else if (!last) {
        fprintf(file, "%-*s%s", (int)widths[column], text, between);
    } else {
        for (size_t i = 0; i < column; i++)
            begins += widths[i] + strlen(between);
        word_wrap_print(text, begins, file);
    }
}

static bool write_plain(const struct table *table, FILE *file)
{
    size_t count = table->column_count;
    size_t *widths = widths_of(table, strlen);
    if (!widths)
        return false;
    for (size_t i = 0; i < count; i++)
        plain_cell(table, i, widths, table->columns[i].heading, file);
    for (size_t i = 0; i < table->cell_count; i++)
        plain_cell(table, i % count, widths, table->cells[i].text, file);
    free(widths);
    return true;
}

/* ---- Markdown ---- */

/* Returns true for characters that would end a cell or be interpreted as markup. */
static bool is_markup(char c)
{
    return strchr("\\|<*`", c) != NULL;
}

static size_t markdown_length(const char *text)
{
    size_t length = 0;
    for (; *text; text++)
        length += is_markup(*text) ? 2 : 1;
    return length;
}

static void put_blanks(size_t count, FILE *file)
{
    fprintf(file, "%*s", (int)count, "");
}

static void markdown_cell(const struct table_column *column, size_t width,
                          const char *text, FILE *file)
{
    size_t rest = width - markdown_length(text);
    bool right = column->kind != TABLE_TEXT;
    put_blanks(right ? rest + 1 : 1, file);
    for (; *text; text++) {
        if (is_markup(*text))
            putc('\\', file);
        putc(*text == '\n' ? ' ' : *text, file);
    }
    put_blanks(right ? 1 : rest + 1, file);
    putc('|', file);
}

/* Writes the line under the headings. A colon marks the side of the alignment. */
static void markdown_rule(const struct table *table, const size_t *widths, FILE *file)
{
    putc('|', file);
    for (size_t i = 0; i < table->column_count; i++) {
        bool right = table->columns[i].kind != TABLE_TEXT;
        putc(right ? '-' : ':', file);
        for (size_t k = 0; k < widths[i]; k++)
            putc('-', file);
        fputs(right ? ":|" : "-|", file);
    }
    putc('\n', file);
}

static bool write_markdown(const struct table *table, FILE *file)
{
    size_t count = table->column_count;
    size_t *widths = widths_of(table, markdown_length);
    if (!widths)
        return false;
    putc('|', file);
    for (size_t i = 0; i < count; i++)
        markdown_cell(&table->columns[i], widths[i], table->columns[i].heading, file);
    putc('\n', file);
    markdown_rule(table, widths, file);
    for (size_t i = 0; i < table->cell_count; i++) {
        fputs(i % count == 0 ? "|" : "", file);
        markdown_cell(&table->columns[i % count], widths[i % count],
                      table->cells[i].text, file);
        fputs(i % count == count - 1 ? "\n" : "", file);
    }
    free(widths);
    return true;
}

/* ---- CSV ---- */

/* Returns true if a spreadsheet would evaluate the cell because of its first character.
 * Quotes do not prevent this. An apostrophe before the character makes the cell a
 * text. */
static bool is_formula(const char *text)
{
    char *end;
    if (!*text || !strchr("=+-@\t\r\n", *text))
        return false;
    strtod(text, &end);
    return *end || text[strspn(text, "+-.0123456789eE")];
}

/* Quotes a cell if necessary. A cell that begins with # is quoted, because it would
 * look like a remark. */
static void put_quoted(const char *text, FILE *file)
{
    bool quoted = text[0] == '#' || strpbrk(text, ",\"\r\n");
    fputs(quoted ? "\"" : "", file);
    fputs(is_formula(text) ? "'" : "", file);
    for (; *text; text++) {
        fputs(*text == '"' ? "\"" : "", file);
        putc(*text, file);
    }
    fputs(quoted ? "\"" : "", file);
}

static void csv_cell(const struct cell *cell, const struct table_column *column,
                     FILE *file)
{
    char digits[JSON_NUMBER_SIZE];
    if (cell->empty)
        return;
    if (column->kind == TABLE_TEXT) {
        put_quoted(cell->text, file);
    } else if (column->kind == TABLE_COUNT) {
        fprintf(file, "%" PRIu64, cell->value.count);
    } else if (isfinite(cell->value.number)) {
        json_digits(digits, cell->value.number);
        fputs(digits, file);
    }
}

static void write_csv(const struct table *table, FILE *file)
{
    size_t count = table->column_count;
    for (size_t i = 0; i < count; i++) {
        put_quoted(table->columns[i].key, file);
        putc(i == count - 1 ? '\n' : ',', file);
    }
    for (size_t i = 0; i < table->cell_count; i++) {
        csv_cell(&table->cells[i], &table->columns[i % count], file);
        putc(i % count == count - 1 ? '\n' : ',', file);
    }
}

/* ---- All formats -------------------------------------------------------- */

bool table_write(const struct table *table, enum table_format format, FILE *file)
{
    if (table->failed)
        return false;
    switch (format) {
    case TABLE_CSV: write_csv(table, file); return true;
    case TABLE_MARKDOWN: return write_markdown(table, file);
    default: return write_plain(table, file);
    }
}

bool table_print(const struct table *table, FILE *file)
{
    return table_write(table, TABLE_PLAIN, file);
}

void table_heading(const char *heading, enum table_format format, FILE *file)
{
    static const struct {
        const char *before, *after;
    } marks[] = {
        [TABLE_PLAIN] = { "", ":\n\n" },
        [TABLE_CSV] = { "# ", "\n" },
        [TABLE_MARKDOWN] = { "## ", "\n\n" },
    };
    fprintf(file, "\n%s", marks[format].before);
    for (; *heading; heading++)
        putc(*heading == '\n' && format != TABLE_PLAIN ? ' ' : *heading, file);
    fputs(marks[format].after, file);
}

const char *table_remark(enum table_format format)
{
    return format == TABLE_CSV ? "# " : "";
}

/* ---- JSON ---- */

static void cell_json(const struct cell *cell, const struct table_column *column,
                      struct json *json)
{
    if (cell->empty)
        json_null(json, column->key);
    else if (column->kind == TABLE_TEXT)
        json_text(json, column->key, cell->raw);
    else if (column->kind == TABLE_COUNT)
        json_count(json, column->key, cell->value.count);
    else
        json_number(json, column->key, cell->value.number);
}

bool table_json(const struct table *table, struct json *json, const char *key)
{
    size_t count = table->column_count;
    if (!table_is_whole(table))
        return false;
    json_array(json, key);
    for (size_t i = 0; i < table->cell_count; i++) {
        if (i % count == 0)
            json_object(json, NULL);
        cell_json(&table->cells[i], &table->columns[i % count], json);
        if (i % count == count - 1)
            json_end(json);
    }
    json_end(json);
    return true;
}
