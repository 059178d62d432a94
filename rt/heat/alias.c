/* alias.c - builds alias tables by Vose's method. */
#include "rt/heat/alias.h"

#include <stdlib.h>

/* A scarce column has a share below 1. All other columns are ample. The two lists grow
 * from the two ends of one array. */
struct columns {
    size_t *list, scarce, ample, count;
};

static void put_column(struct columns *columns, const double *share, size_t i)
{
    if (share[i] < 1)
        columns->list[columns->scarce++] = i;
    else
        columns->list[columns->count - ++columns->ample] = i;
}

/* Fills each column whose share is below 1 from a column with a larger share. The
 * larger column loses the same amount, and moves to the list of its new share. Each
 * step completes one column, so the time is linear. */
static void fill_columns(struct columns *columns, double *share, size_t *alias)
{
    while (columns->scarce > 0 && columns->ample > 0) {
        size_t poor = columns->list[--columns->scarce];
        size_t rich = columns->list[columns->count - columns->ample--];
        alias[poor] = rich;
        share[rich] -= 1 - share[poor];
        put_column(columns, share, rich);
    }
}

bool alias_build(const double *weights, size_t count, double *share, size_t *alias)
{
    struct columns columns = { malloc((count + 1) * sizeof *columns.list), 0, 0,
                               count };
    double sum = 0;
    if (!columns.list)
        return false;
    for (size_t i = 0; i < count; i++)
        sum += weights[i];
    for (size_t i = 0; i < count; i++) {
        alias[i] = i;
        share[i] = weights[i] * ((double)count / sum);
        put_column(&columns, share, i);
    }
    fill_columns(&columns, share, alias);
    for (; columns.scarce > 0; columns.scarce--) /* these columns remain only because of
                                                  * rounding errors */
        share[columns.list[columns.scarce - 1]] = 1;
    for (; columns.ample > 0; columns.ample--)
        share[columns.list[count - columns.ample]] = 1;
    free(columns.list);
    return true;
}
