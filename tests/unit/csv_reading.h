/* csv_reading.h - reads CSV as RFC 4180 defines it. Commas separate cells. A quoted
 * cell may contain any character, and "" means a quote. */
#ifndef TESTS_CSV_READING_H
#define TESTS_CSV_READING_H

#include "tests/unit/unit.h"

enum { CSV_ROWS = 64, CSV_CELLS = 24, CSV_CELL = 256 };

struct csv_table {
    size_t rows, cells[CSV_ROWS]; /* cells of each row; row 0 contains the column
                                   * names */
    char cell[CSV_ROWS][CSV_CELLS][CSV_CELL];
};

/* Reads rows up to an empty line or the end of the text. Fails unless each row has the
 * same number of cells. Returns a pointer to the text after the table. */
const char *csv_table(const char *text, struct csv_table *table);

#endif
