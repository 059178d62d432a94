/* csv_reading.h - CSV read back as RFC 4180 has it: cells between commas,
 * quoted ones with any character in them and "" for a quote.
 */
#ifndef TESTS_CSV_READING_H
#define TESTS_CSV_READING_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

enum { CSV_ROWS = 64, CSV_CELLS = 16, CSV_CELL = 256 };

struct csv_table {
    size_t rows, cells[CSV_ROWS]; /* in each row; the first has the names */
    char cell[CSV_ROWS][CSV_CELLS][CSV_CELL];
};

/* One cell; what follows it. */
static inline const char *csv_cell(const char *text, char *cell)
{
    bool quoted = *text == '"';
    size_t length = 0;

    text += quoted;
    while (*text != '\0' && (quoted || !strchr(",\n", *text))) {
        if (quoted && *text == '"' && *++text != '"')
            break;
        assert_true(length + 1 < CSV_CELL);
        cell[length++] = *text++;
    }
    cell[length] = '\0';
    return text;
}

static inline const char *csv_row(const char *text, struct csv_table *table)
{
    size_t row = table->rows++;
    size_t cells = 0;

    assert_true(row < CSV_ROWS);
    do {
        assert_true(cells < CSV_CELLS);
        text = csv_cell(text + (cells > 0), table->cell[row][cells]);
        cells++;
    } while (*text == ',');
    table->cells[row] = cells;
    return text + (*text == '\n');
}

/* The rows up to an empty line or the end, each as long as the first; what
 * follows them. */
static inline const char *csv_table(const char *text, struct csv_table *table)
{
    table->rows = 0;
    while (*text != '\0' && *text != '\n') {
        text = csv_row(text, table);
        assert_int_equal(table->cells[table->rows - 1], table->cells[0]);
    }
    return text;
}

#endif
