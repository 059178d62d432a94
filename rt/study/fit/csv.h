/* csv.h - reads tables from files with one row per line and fields separated by
 * commas.
 *
 * A field may be in double quotes and may then contain commas. Empty lines and
 * lines that begin with # are skipped. The first other line has the names of the
 * columns.
 */
#ifndef RT_FIT_CSV_H
#define RT_FIT_CSV_H

#include "base/diagnostic.h"

struct csv_row {
    size_t line;   /* line number in the file, from 1 */
    char **fields; /* one for each column */
};

struct csv {
    char *path;
    char *text;   /* split into fields */
    char *source; /* the unchanged text, for messages */
    size_t columns, count;
    struct csv_row *rows;
};

/* Reads a table. The columns must be these, in this order. Returns false with the
 * reason in the diagnostics. */
bool csv_read(struct csv *csv, const char *path, const char *const *columns,
              size_t count, struct diagnostics *diagnostics);
void csv_free(struct csv *csv);

/* Reports an error in a field. Returns false. */
bool csv_wrong(const struct csv *csv, const struct csv_row *row, size_t field,
               const char *message, struct diagnostics *diagnostics);
/* Reads a positive number from a field, or reports an error. */
bool csv_positive(const struct csv *csv, const struct csv_row *row, size_t field,
                  double *value, struct diagnostics *diagnostics);

#endif
