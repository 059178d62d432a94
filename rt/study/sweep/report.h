/* report.h - what a sweep found, for print, JSON and a plot.
 *
 * Tables, and lines of text with figures in them; all of it is worked out
 * from the measures.
 */
#ifndef RT_SWEEP_REPORT_H
#define RT_SWEEP_REPORT_H

#include "base/table.h"
#include "rt/study/plot/plot.h"
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
    /* The first is of all points. */
    struct sweep_part parts[MAX_SWEEP_PARTS];
    size_t part_count;
    char lines[MAX_SWEEP_LINES][SWEEP_LINE_SIZE];
    size_t line_count;

    /* What is plotted, from one of the tables; its title and subtitles are
     * the caller's. */
    struct plot plot;
    const struct table *plotted;
    struct plot_curve curves[MAX_SWEEP_CURVES];
    struct plot_mark marks[MAX_SWEEP_MARKS], levels[MAX_SWEEP_MARKS];
    char labels[2 * MAX_SWEEP_MARKS][SWEEP_LABEL_SIZE];
    size_t label_count;
};

/* Columns of every table of points, behind those that tell them apart. */
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
/* Where they are, from the first of them on. */
enum sweep_column {
    SWEEP_COLUMN_HITS,
    SWEEP_COLUMN_SCALAR,
    SWEEP_COLUMN_QUEUED,
    SWEEP_COLUMN_SPEEDUP,
    SWEEP_COLUMN_GROUPS /* one each */
};
extern const char sweep_points_heading[];
/* The cells of those columns. */
void sweep_add_cells(struct table *table, const struct sweep_measure *measure);

void sweep_report_free(struct sweep_report *report);
/* A new table of the report, which keeps it.  NULL: no memory. */
struct table *sweep_report_table(struct sweep_report *report, const char *key,
                                 const char *heading,
                                 const struct table_column *columns, size_t count);
void sweep_report_line(struct sweep_report *report, const char *format, ...);
void sweep_report_curve(struct sweep_report *report, size_t column, const char *title);
/* NaN: there is none. */
void sweep_report_mark(struct sweep_report *report, double x, const char *format, ...);
void sweep_report_level(struct sweep_report *report, double y, const char *format, ...);

/* All tables, and the lines behind them.  False: memory ran out. */
bool sweep_report_write(const struct sweep_report *report, enum table_format format,
                        FILE *file);
/* The same, and all causes of both forms point by point.  False likewise. */
bool sweep_report_json(const struct sweep_report *report, const struct sweep *sweep,
                       struct json *json);

#endif
