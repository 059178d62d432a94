/* csv_reading.h - CSV read back as RFC 4180 has it: cells between commas,
 * quoted ones with any character in them and "" for a quote.
 */
#ifndef TESTS_CSV_READING_H
#define TESTS_CSV_READING_H

#include "tests/unit/unit.h"

enum { CSV_ROWS = 64, CSV_CELLS = 24, CSV_CELL = 256 };

struct csv_table {
    size_t rows, cells[CSV_ROWS]; /* in each row; the first has the names */
    char cell[CSV_ROWS][CSV_CELLS][CSV_CELL];
};

/* The rows up to an empty line or the end, each as long as the first; what
 * follows them. */
const char *csv_table(const char *text, struct csv_table *table);

#endif
