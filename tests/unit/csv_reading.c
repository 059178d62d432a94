/* csv_reading.c - reads a CSV table cell by cell, row by row. */
#include "csv_reading.h"

/* Reads one cell. Returns a pointer to the text after it. */
static const char *csv_cell(const char *text, char *cell)
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

static const char *csv_row(const char *text, struct csv_table *table)
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

const char *csv_table(const char *text, struct csv_table *table)
{
    table->rows = 0;
    while (*text != '\0' && *text != '\n') {
        text = csv_row(text, table);
        assert_int_equal(table->cells[table->rows - 1], table->cells[0]);
    }
    return text;
}
