/* pipes.c - measures the cost of a ray as a function of the number of pipes, with
 * operands of 64 and 32 bits. */
#include <math.h>

#include "vm/error.h"
#include "rt/study/sweep/sweep_types.h"

/* The machines, in the order of the table. The slowest is the first. */
static const struct {
    unsigned pipes, bits;
} machines[] = { { 1, 64 }, { 2, 64 }, { 4, 64 }, { 1, 32 }, { 2, 32 }, { 4, 32 } };
enum { MACHINES = sizeof machines / sizeof *machines };
enum { ONE_PIPE = 0, TWO_PIPES = 1, SIZES = 2, PER_SIZE = MACHINES / SIZES };

static unsigned results_a_clock(size_t machine)
{
    return machines[machine].pipes * (64 / machines[machine].bits);
}

static bool measure(struct sweep *sweep, c205_error *error)
{
    struct sweep_point points[MACHINES];
    for (size_t i = 0; i < MACHINES; i++) {
        const c205_setting settings[] = {
            { "machine.pipes", machines[i].pipes },
            { "vector.word_rate", 64 / machines[i].bits },
        };
        points[i] = sweep->base;
        points[i].trace.model = sweep_model(sweep, settings, 2, error);
        if (!points[i].trace.model)
            return false;
    }
    return sweep_run(sweep, points, MACHINES, error);
}

/* ---- Tables -------------------------------------------------------------- */

static const struct table_column point_columns[] = {
    { "pipes", "pipes", TABLE_COUNT, 0 },
    { "bits", "bits", TABLE_COUNT, 0 },
    SWEEP_COLUMNS,
};

static const struct table_column limit_columns[] = {
    { "pipes", "pipes", TABLE_COUNT, 0 },
    { "bits", "bits", TABLE_COUNT, 0 },
    { "results", "results a clock", TABLE_COUNT, 0 },
    { "of_two_percent", "% of two pipes", TABLE_NUMBER, 1 },
    { "faster", "x one pipe", TABLE_NUMBER, 2 },
    { "amdahl", "Amdahl", TABLE_NUMBER, 2 },
    { "limit", "limit", TABLE_NUMBER, 2 },
    { "startup_percent", "% start-up", TABLE_NUMBER, 1 },
};

static void add_machine(struct table *table, size_t machine)
{
    table_count(table, machines[machine].pipes);
    table_count(table, machines[machine].bits);
}

static uint64_t queued_total(const struct sweep *sweep, size_t machine)
{
    return sweep->measures[machine].forms[SWEEP_QUEUED].total;
}

static double faster_than(const struct sweep *sweep, size_t than, size_t machine)
{
    return (double)queued_total(sweep, than) / (double)queued_total(sweep, machine);
}

/* Returns the speedup over one pipe that Amdahl's law predicts if only the vector
 * stream of one pipe becomes faster, by the factor `times`. */
static double amdahl(const struct sweep *sweep, double times)
{
    const struct sweep_form *one = &sweep->measures[ONE_PIPE].forms[SWEEP_QUEUED];
    double all = (double)one->total;
    double stream = (double)sweep_group_clocks(one, SWEEP_STREAM);
    return all / (all - stream + stream / times);
}

static void add_limit(struct table *table, const struct sweep *sweep, size_t machine)
{
    const struct sweep_form *form = &sweep->measures[machine].forms[SWEEP_QUEUED];
    add_machine(table, machine);
    table_count(table, results_a_clock(machine));
    table_number(table, 100 * faster_than(sweep, TWO_PIPES, machine));
    table_number(table, faster_than(sweep, ONE_PIPE, machine));
    table_number(table, amdahl(sweep, results_a_clock(machine)));
    table_number(table, amdahl(sweep, INFINITY));
    table_number(table, 100 * (double)sweep_group_clocks(form, SWEEP_STARTUP)
                            / (double)form->total);
}

/* ---- The plot: pipes on the x axis --------------------------------------- */

static const struct table_column plot_columns[] = {
    { "pipes", "pipes", TABLE_COUNT, 0 },
    { "faster_64", "64 bits", TABLE_NUMBER, 2 },
    { "faster_32", "32 bits", TABLE_NUMBER, 2 },
    { "ideal_64", "64 bits, stream alone", TABLE_NUMBER, 2 },
    { "ideal_32", "32 bits, stream alone", TABLE_NUMBER, 2 },
};

static void fill_plot(struct table *table, const struct sweep *sweep)
{
    for (size_t i = 0; i < PER_SIZE; i++) {
        table_count(table, machines[i].pipes);
        for (size_t size = 0; size < SIZES; size++)
            table_number(table, faster_than(sweep, ONE_PIPE, size * PER_SIZE + i));
        for (size_t size = 0; size < SIZES; size++)
            table_number(table, results_a_clock(size * PER_SIZE + i));
    }
}

static void draw_pipes(struct sweep_report *report, const struct table *table)
{
    report->plotted = table;
    report->plot.x = (struct plot_axis){ "pipes", PLOT_LOG2 };
    report->plot.y = (struct plot_axis){ "times as fast as one pipe, 64 bits",
                                         PLOT_LOG2 };
    for (size_t i = 1; i < sizeof plot_columns / sizeof *plot_columns; i++)
        sweep_report_curve(report, i, plot_columns[i].heading);
}

static void print_pipes(struct sweep_report *report, const struct sweep *sweep)
{
    size_t last = MACHINES - 1;
    sweep_report_line(report,
                      "%u pipes with 32 bits have %u times the "
                      "results a clock of one with 64, and are %.2f",
                      machines[last].pipes, results_a_clock(last),
                      faster_than(sweep, ONE_PIPE, last));
    sweep_report_line(report, "times as fast: start-up, scalar code and the "
                              "streams of gathers gain nothing.");
    sweep_report_line(report,
                      "If streams took no time at all it would be "
                      "%.2f times.",
                      amdahl(sweep, INFINITY));
}

static bool report_pipes(struct sweep *sweep, struct sweep_report *report,
                         c205_error *error)
{
    struct table *points = sweep_report_table(report, "points", sweep_points_heading,
                                              TABLE_COLUMNS(point_columns));
    struct table
        *limits = sweep_report_table(report, "limits",
                                     "In queues: how far start-up limits more pipes",
                                     TABLE_COLUMNS(limit_columns));
    struct table *plotted = sweep_report_table(report, "plot",
                                               "Times as fast as one pipe with 64 bits",
                                               TABLE_COLUMNS(plot_columns));
    error_set(error, "out of memory");
    if (!points || !limits || !plotted)
        return false;
    for (size_t i = 0; i < sweep->count; i++) {
        add_machine(points, i);
        sweep_add_cells(points, &sweep->measures[i]);
        add_limit(limits, sweep, i);
    }
    fill_plot(plotted, sweep);
    print_pipes(report, sweep);
    draw_pipes(report, plotted);
    return true;
}

const struct sweep_kind sweep_pipes = {
    .name = "pipes",
    .title = "Pipes",
    .angle = SPEEDUP_ANGLE,
    .measure = measure,
    .report = report_pipes,
};
