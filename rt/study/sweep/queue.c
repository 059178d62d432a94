/* queue.c - measures the cost of a ray as a function of the length of the queue, for a
 * whole frame. */
#include <math.h>

#include "vm/error.h"
#include "rt/study/sweep/sweep_types.h"

/* Measures the cost with each queue length. A queue is only filled if a band has at
 * least as many pixels, so a queue that is longer than TRACE_BAND gets a longer
 * band. */
static bool measure(struct sweep *sweep, c205_error *error)
{
    struct sweep_point points[MAX_SWEEP_LENGTHS];
    size_t lengths[MAX_SWEEP_LENGTHS];
    size_t rays = sweep->base.trace.width * sweep->base.trace.height;
    size_t count = sweep_lengths(sweep, rays, lengths);
    for (size_t i = 0; i < count; i++) {
        size_t rows = (lengths[i] + sweep->base.trace.width - 1)
                      / sweep->base.trace.width;
        size_t band = rows * sweep->base.trace.width;
        points[i] = sweep->base;
        points[i].trace.queue = lengths[i];
        points[i].trace.band = band > TRACE_BAND ? band : TRACE_BAND;
    }
    return sweep_run(sweep, points, count, error);
}

/* ---- Tables -------------------------------------------------------------- */

static const struct table_column point_columns[] = {
    { "queue", "queue", TABLE_COUNT, 0 },
    SWEEP_COLUMNS,
};

static const struct table_column memory_columns[] = {
    { "what", "memory", TABLE_TEXT, 0 },
    { "words", "words", TABLE_NUMBER, 1 },
};

static const struct table_column difference_columns[] = {
    { "cause", "clocks per ray", TABLE_TEXT, 0 },
    { "best", "best", TABLE_NUMBER, 2 },
    { "paper", "paper's", TABLE_NUMBER, 2 },
    { "paper_more", "more", TABLE_NUMBER, 2 },
    { "longest", "longest", TABLE_NUMBER, 2 },
    { "longest_more", "more", TABLE_NUMBER, 2 },
};

static void fill_points(struct table *table, const struct sweep *sweep)
{
    for (size_t i = 0; i < sweep->count; i++) {
        table_count(table, sweep->measures[i].point.trace.queue);
        sweep_add_cells(table, &sweep->measures[i]);
    }
}

static void add_memory(struct table *table, const char *what, double words)
{
    table_text(table, what);
    table_number(table, words);
}

static void fill_memory(struct table *table, const struct sweep_memory *memory,
                        bool solids)
{
    add_memory(table, "touched for each ray of the queue", memory->a_ray);
    if (solids)
        add_memory(table,
                   "of these for crossings, kept until the visible "
                   "surface is known",
                   (double)memory->crossings);
    add_memory(table, "touched with any queue", memory->fixed);
    add_memory(table, "real memory", memory->real);
}

/* The three queues that are compared. The paper's queue may be missing. */
struct trio {
    const struct sweep_measure *best, *paper, *longest;
};

static double group_cost(const struct sweep_measure *measure, int group)
{
    const struct sweep_form *form;
    if (!measure)
        return NAN;
    form = &measure->forms[SWEEP_QUEUED];
    return sweep_per_ray(measure,
                         group < SWEEP_GROUPS
                             ? sweep_group_clocks(form, (enum sweep_group)group)
                             : form->total);
}

/* Adds a line for each group of causes, and a line for all groups. */
static void fill_difference(struct table *table, const struct trio *trio)
{
    for (int group = 0; group <= SWEEP_GROUPS; group++) {
        double best = group_cost(trio->best, group);
        double paper = group_cost(trio->paper, group);
        double longest = group_cost(trio->longest, group);
        table_text(table, group < SWEEP_GROUPS
                              ? sweep_group_name((enum sweep_group)group)
                              : "all");
        table_number(table, best);
        table_number(table, paper);
        table_number(table, paper - best);
        table_number(table, longest);
        table_number(table, longest - best);
    }
}

/* ---- Text ---------------------------------------------------------------- */

static size_t queue_of(const struct sweep_measure *measure)
{
    return measure->point.trace.queue;
}

static double percent_above(const struct sweep_measure *measure,
                            const struct sweep_measure *best)
{
    return 100
           * (sweep_cost(measure, SWEEP_QUEUED) / sweep_cost(best, SWEEP_QUEUED) - 1);
}

/* Returns the group of causes whose clocks increase most from one queue to another. */
static enum sweep_group rises_most(const struct sweep_measure *from,
                                   const struct sweep_measure *to)
{
    int most = 0;
    for (int group = 1; group < SWEEP_GROUPS; group++)
        if (group_cost(to, group) - group_cost(from, group)
            > group_cost(to, most) - group_cost(from, most))
            most = group;
    return (enum sweep_group)most;
}

static void print_other(struct sweep_report *report, const char *what,
                        const struct sweep_measure *other,
                        const struct sweep_measure *best)
{
    enum sweep_group most;
    if (!other || other == best)
        return;
    most = rises_most(best, other);
    sweep_report_line(report,
                      "%s %zu: %.2f, %.1f %% more; the largest increase is %s "
                      "(%+.2f).",
                      what, queue_of(other), sweep_cost(other, SWEEP_QUEUED),
                      percent_above(other, best), sweep_group_name(most),
                      group_cost(other, (int)most) - group_cost(best, (int)most));
}

/* Prints the range of queue lengths around the best whose cost is at most 2 %
 * higher. */
static void print_flat(struct sweep_report *report, const struct sweep *sweep,
                       const struct sweep_measure *best)
{
    const struct sweep_measure *first = best, *last = best;
    const struct sweep_measure *end = sweep->measures + sweep->count;
    while (first > sweep->measures && percent_above(first - 1, best) <= 2)
        first--;
    while (last + 1 < end && percent_above(last + 1, best) <= 2)
        last++;
    sweep_report_line(report, "Within 2 %% of the best: %zu to %zu.", queue_of(first),
                      queue_of(last));
}

static void print_memory(struct sweep_report *report, const struct sweep_memory *memory)
{
    if (memory->fills < 1)
        sweep_report_line(report, "Real memory is too small for a queue of "
                                  "any length.");
    else if (memory->fills < MAX_TRACE_QUEUE)
        sweep_report_line(report,
                          "A queue of %.0f fills real memory; the "
                          "paper's %d and the rest take %.0f %% of it.",
                          memory->fills, TRACE_QUEUE,
                          100 * (memory->fixed + TRACE_QUEUE * memory->a_ray)
                              / memory->real);
    else
        sweep_report_line(report,
                          "The longest queue of all, %d, fits in "
                          "real memory.",
                          MAX_TRACE_QUEUE);
}

static void print_queues(struct sweep_report *report, const struct sweep *sweep,
                         const struct trio *trio, const struct sweep_memory *memory)
{
    sweep_report_line(report, "Best: a queue of %zu, %.2f clocks per ray.",
                      queue_of(trio->best), sweep_cost(trio->best, SWEEP_QUEUED));
    print_other(report, "The paper's", trio->paper, trio->best);
    print_other(report, "The longest,", trio->longest, trio->best);
    print_flat(report, sweep, trio->best);
    print_memory(report, memory);
}

/* The groups in the plot from bottom to top. The groups that change most are at the
 * top. */
static const enum sweep_group drawn[SWEEP_GROUPS] = { SWEEP_STREAM, SWEEP_CONFLICT,
                                                      SWEEP_SERIAL, SWEEP_STARTUP,
                                                      SWEEP_MISS,   SWEEP_FAULT };

/* The height of the plot, as a multiple of the lowest cost. The plot then shows the
 * flat part of the curve, and where the cost begins to rise. */
enum { SHOWN_TIMES = 3 };

static void draw_queues(struct sweep_report *report, const struct trio *trio)
{
    const struct sweep_measure *best = trio->best;
    double scalar = sweep_cost(best, SWEEP_SCALAR);
    report->plotted = report->parts[0].table;
    report->plot.form = PLOT_AREAS;
    report->plot.x = (struct plot_axis){ "rays in the queue", PLOT_LOG2 };
    report->plot.y = (struct plot_axis){ "clocks per ray", PLOT_LINEAR };
    report->plot.y_most = SHOWN_TIMES * sweep_cost(best, SWEEP_QUEUED);
    for (size_t i = 0; i < SWEEP_GROUPS; i++)
        sweep_report_curve(report, 1 + SWEEP_COLUMN_GROUPS + drawn[i],
                           sweep_group_name(drawn[i]));
    sweep_report_mark(report, (double)queue_of(best), "best: %zu", queue_of(best));
    if (trio->paper && trio->paper != best)
        sweep_report_mark(report, (double)queue_of(trio->paper), "the paper's %zu",
                          queue_of(trio->paper));
    if (scalar < report->plot.y_most)
        sweep_report_level(report, scalar, "scalar form");
}

static bool report_queue(struct sweep *sweep, struct sweep_report *report,
                         c205_error *error)
{
    const struct trio trio = {
        .best = sweep_best(sweep),
        .paper = sweep_with_queue(sweep, TRACE_QUEUE),
        .longest = &sweep->measures[sweep->count - 1],
    };
    struct sweep_memory memory;
    struct table *points, *words, *difference;
    if (!sweep_memory(sweep, &memory, error))
        return false;
    points = sweep_report_table(report, "points", sweep_points_heading,
                                TABLE_COLUMNS(point_columns));
    words = sweep_report_table(report, "memory",
                               "The memory of the program "
                               "in queues",
                               TABLE_COLUMNS(memory_columns));
    difference = sweep_report_table(report, "difference",
                                    "The best queue, "
                                    "the paper's, the longest",
                                    TABLE_COLUMNS(difference_columns));
    error_set(error, "out of memory");
    if (!points || !words || !difference)
        return false;
    fill_points(points, sweep);
    fill_memory(words, &memory, sweep->scene != NULL);
    fill_difference(difference, &trio);
    print_queues(report, sweep, &trio, &memory);
    draw_queues(report, &trio);
    return true;
}

const struct sweep_kind sweep_queue = {
    .name = "queue",
    .title = "The length of the queue",
    .angle = SPEEDUP_ANGLE,
    .takes_lengths = true,
    .measure = measure,
    .report = report_queue,
};
