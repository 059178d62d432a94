/* tables.c - converts the results of a sweep to tables. */
#include <math.h>
#include <string.h>

#include "asm/sweep/swept.h"
#include "base/accounts.h"

const char *const swept_names[SWEPT_PROGRAMS] = { "first", "second" };

static double point_clocks(const struct swept_point *point, size_t which)
{
    return (double)accounts_clocks(&point->runs[which]);
}

struct table *swept_points(const struct program_sweep *sweep)
{
    struct table_column columns[] = {
        { "value", sweep->constant, TABLE_COUNT, 0 },
        { "clocks", "clocks", TABLE_COUNT, 0 },
        { "per_element", sweep->per_element, TABLE_NUMBER, 2 },
        { "mflops", "Mflop/s", TABLE_NUMBER, 2 },
        { "second_clocks", "second clocks", TABLE_COUNT, 0 },
        { "second_per_element", sweep->per_element, TABLE_NUMBER, 2 },
        { "second_mflops", "Mflop/s", TABLE_NUMBER, 2 },
        { "ratio", "first / second", TABLE_NUMBER, 3 },
    };
    bool two = sweep->program_count == SWEPT_PROGRAMS;
    struct table *table;
    if (two) {
        columns[1] = (struct table_column){ "first_clocks", "first clocks", TABLE_COUNT,
                                            0 };
        columns[2].key = "first_per_element";
        columns[3].key = "first_mflops";
    }
    table = table_new(columns, two ? 8 : 4);
    for (size_t i = 0; table && i < sweep->count; i++) {
        const struct swept_point *point = &sweep->points[i];
        table_count(table, point->value);
        for (size_t k = 0; k < sweep->program_count; k++) {
            const c205_account *run = &point->runs[k];
            table_count(table, accounts_clocks(run));
            table_number(table, point_clocks(point, k) / (double)point->value);
            table_number(table, accounts_rate(sweep->model, run));
        }
        if (two)
            table_number(table, point_clocks(point, SWEPT_FIRST)
                                    / point_clocks(point, SWEPT_SECOND));
    }
    return table;
}

/* Returns the column of clocks of a program. Each program has three columns after the
 * value. */
size_t swept_clocks_column(int which)
{
    return 1 + 3 * (size_t)which;
}

struct table *swept_causes(const struct program_sweep *sweep)
{
    struct table_column columns[3 + C205_CAUSES] = {
        { "program", "program", TABLE_TEXT, 0 },
        { "value", sweep->constant, TABLE_COUNT, 0 },
        { "clocks", "clocks", TABLE_COUNT, 0 },
    };
    struct table *table;
    memcpy(columns + 3, accounts_cause_columns, sizeof accounts_cause_columns);
    table = table_new(TABLE_COLUMNS(columns));
    for (size_t i = 0; table && i < sweep->count; i++) {
        for (size_t k = 0; k < sweep->program_count; k++) {
            const c205_account *run = &sweep->points[i].runs[k];
            table_text(table, swept_names[k]);
            table_count(table, sweep->points[i].value);
            table_count(table, accounts_clocks(run));
            for (int cause = 0; cause < C205_CAUSES; cause++)
                table_count(table, run->clocks[cause]);
        }
    }
    return table;
}

/* Adds a row with the line of a program. If its points are not on a line, the row has
 * only the largest deviation. */
static void add_line(struct table *table, const struct program_sweep *sweep, int which)
{
    struct swept_line line = swept_line_of(sweep, which);
    double per_second = 1 / accounts_seconds(sweep->model, 1);
    double rate = per_second / line.clocks.slope / 1e6;
    double figures[] = { line.clocks.at_zero, line.clocks.slope, rate,
                         line.flops > 0 ? line.flops * rate : NAN,
                         swept_half_length(&line) };
    table_text(table, swept_names[which]);
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++)
        table_number(table, line.good ? figures[i] : NAN);
    table_number(table, 100 * line.off);
    table_count(table, line.off_at);
}

struct table *swept_lines(const struct program_sweep *sweep)
{
    struct table_column columns[] = {
        { "program", "line", TABLE_TEXT, 0 },
        { "startup", "start-up clk", TABLE_NUMBER, 1 },
        { "per_element", sweep->per_element, TABLE_NUMBER, 4 },
        { "r_infinity", "r-infinity M/s", TABLE_NUMBER, 2 },
        { "mflops", "Mflop/s", TABLE_NUMBER, 2 },
        { "n_half", "n-half", TABLE_NUMBER, 1 },
        { "off_percent", "off %", TABLE_NUMBER, 2 },
        { "off_at", "at", TABLE_COUNT, 0 },
    };
    struct table *table = table_new(TABLE_COLUMNS(columns));
    for (size_t i = 0; table && i < sweep->program_count; i++)
        add_line(table, sweep, (int)i);
    return table;
}

static const struct table_column crossing_columns[] = {
    { "value", "from", TABLE_COUNT, 0 },
    { "faster", "faster", TABLE_TEXT, 0 },
    { "first_clocks", "first clocks", TABLE_COUNT, 0 },
    { "second_clocks", "second clocks", TABLE_COUNT, 0 },
};

struct table *swept_crossings(const struct program_sweep *sweep)
{
    struct table *table = table_new(TABLE_COLUMNS(crossing_columns));
    for (size_t i = 0; table && i < sweep->crossing_count; i++) {
        const struct swept_crossing *crossing = &sweep->crossings[i];
        table_count(table, crossing->at.value);
        table_text(table, swept_names[crossing->faster]);
        for (size_t k = 0; k < SWEPT_PROGRAMS; k++)
            table_count(table, accounts_clocks(&crossing->at.runs[k]));
    }
    return table;
}
