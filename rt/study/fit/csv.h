/* csv.h - tables in files: a line a row, fields between commas.
 *
 * A field may be in double quotes, which then may hold commas.  Empty lines
 * and lines that begin with # are passed over; the first other line names the
 * columns.
 */
#ifndef RT_FIT_CSV_H
#define RT_FIT_CSV_H

#include "base/diagnostic.h"

struct csv_row {
    size_t line;   /* of the file, from 1 */
    char **fields; /* as many as there are columns */
};

struct csv {
    char *path;
    char *text;   /* cut into fields .. */
    char *source; /* .. and as it was */
    size_t columns, count;
    struct csv_row *rows;
};

/* The columns must be these, in this order.  False: the diagnostics say why. */
bool csv_read(struct csv *csv, const char *path, const char *const *columns,
              size_t count, struct diagnostics *diagnostics);
void csv_free(struct csv *csv);

/* Tells what is wrong with a field; false. */
bool csv_wrong(const struct csv *csv, const struct csv_row *row, size_t field,
               const char *message, struct diagnostics *diagnostics);
/* A positive number in a field, or what is wrong with it. */
bool csv_positive(const struct csv *csv, const struct csv_row *row, size_t field,
                  double *value, struct diagnostics *diagnostics);

#endif
