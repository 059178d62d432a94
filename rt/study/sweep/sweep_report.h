/* sweep_report.h - prints the results of a sweep as text and JSON, and draws its plot.
 *
 * A report consists of tables, and of lines of text with numbers. All of them are
 * computed from the measures.
 */
#ifndef RT_SWEEP_REPORT_H
#define RT_SWEEP_REPORT_H

#include "base/plot.h"
#include "base/table.h"
#include "rt/study/sweep/sweep.h"

enum {
    MAX_SWEEP_PARTS = 4,
    MAX_SWEEP_LINES = 8,
    SWEEP_LINE_SIZE = 128,
    MAX_SWEEP_MARKS = 3,
    SWEEP_LABEL_SIZE = 48,
    MAX_SWEEP_CURVES = SWEEP_GROUPS + 2
};

struct sweep_part {
    const char *key, *heading;
    struct table *table;
};

struct sweep_report {
    /* The first part is the table of all points. */
    struct sweep_part parts[MAX_SWEEP_PARTS];
    size_t part_count;
    char lines[MAX_SWEEP_LINES][SWEEP_LINE_SIZE];
    size_t line_count;

    /* The plot shows one of the tables. The caller sets its title and subtitles. */
    struct plot plot;
    const struct table *plotted;
    struct plot_curve curves[MAX_SWEEP_CURVES];
    struct plot_mark marks[MAX_SWEEP_MARKS], levels[MAX_SWEEP_MARKS];
    char labels[2 * MAX_SWEEP_MARKS][SWEEP_LABEL_SIZE];
    size_t label_count;
};

/* The columns that all tables of points have, after the columns that identify a
 * point. */
/* clang-format off */
#define SWEEP_COLUMNS \
    { "hit_percent", "% hit", TABLE_NUMBER, 1 }, \
    { "scalar", "scalar", TABLE_NUMBER, 2 }, \
    { "queued", "in queues", TABLE_NUMBER, 2 }, \
    { "speedup", "speedup", TABLE_NUMBER, 2 }, \
    { "scalar_code", "scalar code", TABLE_NUMBER, 2 }, \
    { "startup", "start-up", TABLE_NUMBER, 2 }, \
    { "stream", "stream", TABLE_NUMBER, 2 }, \
    { "conflict", "conflict", TABLE_NUMBER, 2 }, \
    { "miss", "miss", TABLE_NUMBER, 2 }, \
    { "fault", "page fault", TABLE_NUMBER, 2 }
/* clang-format on */
/* The indices of SWEEP_COLUMNS, starting with 0. */
enum sweep_column {
    SWEEP_COLUMN_HITS,
    SWEEP_COLUMN_SCALAR,
    SWEEP_COLUMN_QUEUED,
    SWEEP_COLUMN_SPEEDUP,
    SWEEP_COLUMN_GROUPS /* one column for each group */
};
extern const char sweep_points_heading[];
/* Adds the cells of a row of SWEEP_COLUMNS: the values of a measure. */
void sweep_add_cells(struct table *table, const struct sweep_measure *measure);

void sweep_report_free(struct sweep_report *report);
/* Adds a new table to the report, which owns the table. Returns NULL if out of
 * memory. */
struct table *sweep_report_table(struct sweep_report *report, const char *key,
                                 const char *heading,
                                 const struct table_column *columns, size_t count);
void sweep_report_line(struct sweep_report *report, const char *format, ...);
void sweep_report_curve(struct sweep_report *report, size_t column, const char *title);
/* Add a labelled vertical line at x, or a horizontal line at y, to the plot. NaN: add
 * nothing. */
void sweep_report_mark(struct sweep_report *report, double x, const char *format, ...);
void sweep_report_level(struct sweep_report *report, double y, const char *format, ...);

/* Prints all tables, then the lines of text. Returns false if out of memory. */
bool sweep_report_write(const struct sweep_report *report, enum table_format format,
                        FILE *file);
/* Writes the tables and lines as JSON, with all causes of both forms for each point.
 * Returns false if out of memory. */
bool sweep_report_json(const struct sweep_report *report, const struct sweep *sweep,
                       struct json *json);

#endif
