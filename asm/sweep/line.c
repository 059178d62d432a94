/* line.c - fits the line through the points of a sweep. */
#include <math.h>

#include "asm/sweep/swept.h"
#include "base/accounts.h"

typedef uint64_t figure_of(const c205_account *account);

static uint64_t operations_of(const c205_account *account)
{
    return account->operations;
}

/* Fits a line that minimises the sum of squared relative errors. A point whose figure
 * is 0 is ignored. */
static struct straight_line fit(const struct program_sweep *sweep, int which,
                                figure_of *figure)
{
    struct weighted_point points[MAX_SWEPT_POINTS];
    for (size_t i = 0; i < sweep->count; i++) {
        double y = (double)figure(&sweep->points[i].runs[which]);
        points[i].x = (double)sweep->points[i].value;
        points[i].y = y;
        points[i].weight = y > 0 ? 1 / (y * y) : 0;
    }
    return straight_line_through(points, sweep->count);
}

static uint64_t clocks_at(const struct program_sweep *sweep, int which, size_t i)
{
    return accounts_clocks(&sweep->points[i].runs[which]);
}

static bool grows(const struct program_sweep *sweep, int which, figure_of *figure)
{
    return figure(&sweep->points[sweep->count - 1].runs[which])
           > figure(&sweep->points[0].runs[which]);
}

static void find_farthest(const struct program_sweep *sweep, int which,
                          struct swept_line *line)
{
    for (size_t i = 0; i < sweep->count; i++) {
        double at = straight_line_at(&line->clocks, (double)sweep->points[i].value);
        double off = at / (double)clocks_at(sweep, which, i) - 1;
        if (i == 0 || fabs(off) > fabs(line->off)) {
            line->off = off;
            line->off_at = sweep->points[i].value;
        }
    }
}

struct swept_line swept_line_of(const struct program_sweep *sweep, int which)
{
    struct swept_line line = { .clocks = fit(sweep, which, accounts_clocks) };
    if (grows(sweep, which, operations_of))
        line.flops = fit(sweep, which, operations_of).slope;
    find_farthest(sweep, which, &line);
    line.grows = grows(sweep, which, accounts_clocks);
    line.good = line.grows && fabs(line.off) <= SWEPT_FAR;
    return line;
}

double swept_half_length(const struct swept_line *line)
{
    return line->clocks.at_zero / line->clocks.slope;
}

double swept_power(const struct program_sweep *sweep, int which)
{
    size_t last = sweep->count - 1, before = last - 1;
    double value = (double)sweep->points[last].value, clocks;
    while (before > 0 && 2 * (double)sweep->points[before].value > value)
        before--;
    value /= (double)sweep->points[before].value;
    clocks = (double)clocks_at(sweep, which, last)
             / (double)clocks_at(sweep, which, before);
    return log(clocks) / log(value);
}
