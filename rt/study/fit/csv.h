/* csv.h - reads tables from files. A line is a row, and commas separate the fields.
 *
 * A field in double quotes may contain commas. Empty lines and lines that begin with #
 * are skipped. The first other line contains the names of the columns.
 */
#ifndef RT_FIT_CSV_H
#define RT_FIT_CSV_H

#include "base/diagnostic.h"

struct csv_row {
    size_t line;   /* line number in the file from 1 */
    char **fields; /* one field for each column */
};

struct csv {
    char *path;
    char *text;   /* split into fields */
    char *source; /* the unchanged text, for messages */
    size_t columns, count;
    struct csv_row *rows;
};

/* Reads a table. It must have these columns in this order. On failure reports
 * diagnostics and returns false. */
bool csv_read(struct csv *csv, const char *path, const char *const *columns,
              size_t count, struct diagnostics *diagnostics);
void csv_free(struct csv *csv);

/* Reports an error in a field. Always returns false. */
bool csv_wrong(const struct csv *csv, const struct csv_row *row, size_t field,
               const char *message, struct diagnostics *diagnostics);
/* Reads a field that must be a positive number. If it is not, reports an error and
 * returns false. */
bool csv_positive(const struct csv *csv, const struct csv_row *row, size_t field,
                  double *value, struct diagnostics *diagnostics);

#endif
