/* table.c - see table.h. */
#include "asm/table.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBER_SIZE = 48, FIRST_ROOM = 64 };
static const char between[] = "  ";

struct cell {
    char *text; /* as printed */
    bool empty;
    union {
        uint64_t count;
        double number;
    } value;
};

struct table {
    const struct table_column *columns;
    size_t column_count;
    size_t cell_count, room;
    struct cell *cells;
    bool failed;
};

struct table *table_new(const struct table_column *columns, size_t count)
{
    struct table *table = calloc(1, sizeof *table);
    if (table) {
        table->columns = columns;
        table->column_count = count;
    }
    return table;
}

void table_free(struct table *table)
{
    if (!table) {
        return;
    }
    for (size_t i = 0; i < table->cell_count; i++) {
        free(table->cells[i].text);
    }
    free(table->cells);
    free(table);
}

static bool make_room(struct table *table)
{
    if (table->cell_count < table->room) {
        return true;
    }
    size_t room = table->room ? 2 * table->room : FIRST_ROOM;
    struct cell *cells = realloc(table->cells, room * sizeof *cells);
    if (cells) {
        table->cells = cells;
        table->room = room;
    }
    return cells != NULL;
}

static void add(struct table *table, const char *text, struct cell cell)
{
    cell.text = malloc(strlen(text) + 1);
    if (!cell.text || !make_room(table)) {
        free(cell.text);
        table->failed = true;
        return;
    }
    strcpy(cell.text, text);
    table->cells[table->cell_count++] = cell;
}

void table_text(struct table *table, const char *text)
{
    add(table, text, (struct cell){ .empty = false });
}

void table_gap(struct table *table)
{
    add(table, "", (struct cell){ .empty = true });
}

void table_count(struct table *table, uint64_t value)
{
    char text[NUMBER_SIZE];
    snprintf(text, sizeof text, "%" PRIu64, value);
    add(table, text, (struct cell){ .value.count = value });
}

void table_number(struct table *table, double value)
{
    char text[NUMBER_SIZE];
    size_t column = table->cell_count % table->column_count;
    if (isnan(value)) {
        table_gap(table);
        return;
    }
    snprintf(text, sizeof text, "%.*f", table->columns[column].decimals,
             value);
    add(table, text, (struct cell){ .value.number = value });
}

static size_t width_of(const struct table *table, size_t column)
{
    size_t width = strlen(table->columns[column].heading);
    for (size_t i = column; i < table->cell_count;
         i += table->column_count) {
        size_t length = strlen(table->cells[i].text);
        width = length > width ? length : width;
    }
    return width;
}

static void print_cell(const struct table *table, size_t column, int width,
                       const char *text, FILE *file)
{
    bool last = column + 1 == table->column_count;
    if (table->columns[column].kind != TABLE_TEXT) {
        fprintf(file, "%*s%s", width, text, last ? "" : between);
    } else if (last) {
        fputs(text, file);
    } else {
        fprintf(file, "%-*s%s", width, text, between);
    }
    if (last) {
        putc('\n', file);
    }
}

bool table_print(const struct table *table, FILE *file)
{
    size_t count = table->column_count;
    int *width = malloc(count * sizeof *width);
    if (!width || table->failed) {
        free(width);
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        width[i] = (int)width_of(table, i);
    }
    for (size_t i = 0; i < count; i++) {
        print_cell(table, i, width[i], table->columns[i].heading, file);
    }
    for (size_t i = 0; i < table->cell_count; i++) {
        print_cell(table, i % count, width[i % count],
                   table->cells[i].text, file);
    }
    free(width);
    return true;
}

static void cell_json(const struct cell *cell,
                      const struct table_column *column, struct json *json)
{
    if (cell->empty) {
        json_null(json, column->key);
    } else if (column->kind == TABLE_TEXT) {
        json_text(json, column->key, cell->text);
    } else if (column->kind == TABLE_COUNT) {
        json_count(json, column->key, cell->value.count);
    } else {
        json_number(json, column->key, cell->value.number);
    }
}

void table_json(const struct table *table, struct json *json,
                const char *key)
{
    size_t count = table->column_count;
    json_array(json, key);
    for (size_t i = 0; i < table->cell_count; i++) {
        if (i % count == 0) {
            json_object(json, NULL);
        }
        cell_json(&table->cells[i], &table->columns[i % count], json);
        if (i % count == count - 1) {
            json_end(json);
        }
    }
    json_end(json);
}
