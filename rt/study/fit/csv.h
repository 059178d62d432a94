/* csv.h - tables in files: a line a row, fields between commas.
 *
 * A field may stand in double quotes, which then may hold commas.  Empty lines
 * and lines that begin with # are passed over; the first other line names the
 * columns.
 */
#ifndef RT_FIT_CSV_H
#define RT_FIT_CSV_H

#include "vm/c205.h"

struct csv_row {
    size_t line;   /* of the file, from 1 */
    char **fields; /* as many as there are columns */
};

struct csv {
    char *path, *text;
    size_t columns, count;
    struct csv_row *rows;
};

/* The columns must be these, in this order.  False: the error says why. */
bool csv_read(struct csv *csv, const char *path, const char *const *columns,
              size_t count, c205_error *error);
void csv_free(struct csv *csv);

/* A positive number in a field; false with the line in the error. */
bool csv_positive(const struct csv *csv, const struct csv_row *row,
                  size_t field, double *value, c205_error *error);

#endif
