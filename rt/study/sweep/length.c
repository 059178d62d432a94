/* length.c - measures the cost of a ray as a function of the length of the vectors.
 *
 * The frame is one row across the centre, with as many rays as the queue length, so
 * that all work per queue is done once. Page faults do not count, because such a short
 * run accesses each page for the first time.
 */
#include <stdlib.h>

#include "vm/error.h"
#include "rt/study/sweep/sweep_types.h"

/* Beyond this queue length, the lengths around the crossover are not measured one by
 * one. */
enum { MAX_TRIED = 256 };

static bool run_lengths(struct sweep *sweep, const size_t *lengths, size_t count,
                        c205_error *error)
{
    struct sweep_point *points = malloc((count + 1) * sizeof *points);
    bool good;
    error_set(error, "out of memory");
    if (!points)
        return false;
    for (size_t i = 0; i < count; i++) {
        points[i] = sweep->base;
        points[i].trace.width = points[i].trace.queue = lengths[i];
        points[i].trace.height = 1;
    }
    good = sweep_run(sweep, points, count, error);
    free(points);
    return good;
}

static size_t length_of(const struct sweep_measure *measure)
{
    return measure->point.trace.queue;
}

static int by_length(const void *left, const void *right)
{
    size_t a = length_of(left), b = length_of(right);
    return (a > b) - (a < b);
}

static void sort(struct sweep *sweep)
{
    qsort(sweep->measures, sweep->count, sizeof *sweep->measures, by_length);
}

/* ---- Refinement ---------------------------------------------------------- */

/* Returns the index of the last measure whose speedup is at most `speedup`, or -1. */
static ptrdiff_t last_not_above(const struct sweep *sweep, double speedup)
{
    ptrdiff_t i = (ptrdiff_t)sweep->count - 1;
    while (i >= 0 && sweep_speedup(&sweep->measures[i]) > speedup)
        i--;
    return i;
}

/* Returns the index of the first measure with at least this speedup. */
static size_t first_with(const struct sweep *sweep, double speedup)
{
    size_t i = 0;
    while (i < sweep->count && sweep_speedup(&sweep->measures[i]) < speedup)
        i++;
    return i;
}

/* Measures the lengths from `first` to `last`, except those that have been measured
 * already. */
static bool run_between(struct sweep *sweep, size_t first, size_t last,
                        c205_error *error)
{
    size_t *lengths = malloc((last - first + 1) * sizeof *lengths);
    size_t count = 0;
    bool good;
    error_set(error, "out of memory");
    for (size_t n = first; lengths && n <= last; n++)
        if (!sweep_with_queue(sweep, n))
            lengths[count++] = n;
    good = lengths && run_lengths(sweep, lengths, count, error);
    free(lengths);
    sort(sweep);
    return good;
}

/* Determines the crossover exactly. Measures all lengths from the last length at which
 * the scalar form is at least as fast, to twice the next measured length. */
static bool approach_crossover(struct sweep *sweep, c205_error *error)
{
    ptrdiff_t below = last_not_above(sweep, 1);
    size_t above;
    if (below < 0 || (size_t)below + 1 == sweep->count)
        return true;
    above = length_of(&sweep->measures[below + 1]);
    if (above > MAX_TRIED)
        return true;
    return run_between(sweep, length_of(&sweep->measures[below]), 2 * above, error);
}

static double best_speedup(const struct sweep *sweep)
{
    double best = 0;
    for (size_t i = 0; i < sweep->count; i++)
        if (sweep_speedup(&sweep->measures[i]) > best)
            best = sweep_speedup(&sweep->measures[i]);
    return best;
}

/* Bisects the interval before the first measure with at least this speedup, until its
 * ends are adjacent. */
static bool approach_speedup(struct sweep *sweep, double speedup, c205_error *error)
{
    for (;;) {
        size_t i = first_with(sweep, speedup);
        size_t above, below, middle;
        if (i == 0 || i == sweep->count)
            return true;
        above = length_of(&sweep->measures[i]);
        below = length_of(&sweep->measures[i - 1]);
        middle = below + (above - below) / 2;
        if (middle == below)
            return true;
        if (!run_lengths(sweep, &middle, 1, error))
            return false;
        sort(sweep);
    }
}

static bool measure(struct sweep *sweep, c205_error *error)
{
    size_t lengths[MAX_SWEEP_LENGTHS];
    size_t count = sweep_lengths(sweep, MAX_TRACE_QUEUE, lengths);
    sweep->pages_in_place = true;
    return run_lengths(sweep, lengths, count, error) && approach_crossover(sweep, error)
           && approach_speedup(sweep, best_speedup(sweep) / 2, error);
}

/* ---- Findings ------------------------------------------------------------ */

/* Starts at measure i, continues while each measured length is one more than the
 * previous length, and returns the last of these lengths. */
static size_t checked_from(const struct sweep *sweep, size_t i)
{
    while (i + 1 < sweep->count
           && length_of(&sweep->measures[i + 1]) == length_of(&sweep->measures[i]) + 1)
        i++;
    return length_of(&sweep->measures[i]);
}

/* Returns true if the length before this one was measured, too. A finding at this
 * length is then exact. */
static bool is_exact(const struct sweep *sweep, size_t length)
{
    return length == 1 || sweep_with_queue(sweep, length - 1);
}

struct sweep_lengths_found sweep_find_lengths(const struct sweep *sweep)
{
    struct sweep_lengths_found found = { .best = best_speedup(sweep) };
    size_t crossover = (size_t)(last_not_above(sweep, 1) + 1);
    if (crossover < sweep->count) {
        found.crossover = length_of(&sweep->measures[crossover]);
        if (is_exact(sweep, found.crossover))
            found.checked = checked_from(sweep, crossover);
    }
    found.half = length_of(&sweep->measures[first_with(sweep, found.best / 2)]);
    found.half_is_exact = is_exact(sweep, found.half);
    return found;
}

/* ---- Tables -------------------------------------------------------------- */

static const struct table_column point_columns[] = {
    { "length", "length", TABLE_COUNT, 0 },
    SWEEP_COLUMNS,
};

static bool is_asked(const struct sweep *sweep, size_t length)
{
    size_t lengths[MAX_SWEEP_LENGTHS];
    size_t count = sweep_lengths(sweep, MAX_TRACE_QUEUE, lengths);
    for (size_t i = 0; i < count; i++)
        if (lengths[i] == length)
            return true;
    return false;
}

/* Adds rows for the requested lengths, the findings, and the length before each
 * finding. */
static void fill_lengths(struct table *table, const struct sweep *sweep,
                         const struct sweep_lengths_found *found)
{
    for (size_t i = 0; i < sweep->count; i++) {
        size_t length = length_of(&sweep->measures[i]);
        if (!is_asked(sweep, length) && length != found->crossover
            && length + 1 != found->crossover && length != found->half
            && length + 1 != found->half)
            continue;
        table_count(table, length);
        sweep_add_cells(table, &sweep->measures[i]);
    }
}

static const char *or_before(bool exact)
{
    return exact ? "" : " or before";
}

static void print_lengths(struct sweep_report *report, const struct sweep *sweep,
                          const struct sweep_lengths_found *found)
{
    if (found->crossover == 0)
        sweep_report_line(report, "The scalar form is cheaper at the longest "
                                  "of these lengths.");
    else if (found->crossover == length_of(&sweep->measures[0]))
        sweep_report_line(report, "Queues are cheaper from the shortest of "
                                  "these lengths on.");
    else if (found->checked > 0)
        sweep_report_line(report,
                          "Crossover: from a length of %zu on queues "
                          "are cheaper; every length up to %zu was tried.",
                          found->crossover, found->checked);
    else
        sweep_report_line(report, "Crossover: at a length of %zu or before.",
                          found->crossover);
    sweep_report_line(report,
                      "The best speedup is %.2f; half of it is "
                      "reached at a length of %zu%s (n-half).",
                      found->best, found->half, or_before(found->half_is_exact));
}

static void draw_lengths(struct sweep_report *report,
                         const struct sweep_lengths_found *found)
{
    report->plotted = report->parts[0].table;
    report->plot.x = (struct plot_axis){ "rays, all in one queue", PLOT_LOG2 };
    report->plot.y = (struct plot_axis){ "times as fast as scalar", PLOT_LINEAR };
    sweep_report_curve(report, 1 + SWEEP_COLUMN_SPEEDUP, "speedup");
    if (found->crossover > 0)
        sweep_report_mark(report, (double)found->crossover, "crossover: %zu%s",
                          found->crossover, or_before(found->checked > 0));
    sweep_report_mark(report, (double)found->half, "n-half: %zu%s", found->half,
                      or_before(found->half_is_exact));
    sweep_report_level(report, 1, "scalar form");
    sweep_report_level(report, found->best / 2, "half of the best");
}

static bool report_length(struct sweep *sweep, struct sweep_report *report,
                          c205_error *error)
{
    struct sweep_lengths_found found = sweep_find_lengths(sweep);
    struct table *table = sweep_report_table(report, "points", sweep_points_heading,
                                             TABLE_COLUMNS(point_columns));
    error_set(error, "out of memory");
    if (!table)
        return false;
    fill_lengths(table, sweep, &found);
    print_lengths(report, sweep, &found);
    draw_lengths(report, &found);
    return true;
}

const struct sweep_kind sweep_length = {
    .name = "length",
    .title = "The length of the vectors",
    .angle = SPEEDUP_ANGLE,
    .takes_lengths = true,
    .measure = measure,
    .report = report_length,
};
