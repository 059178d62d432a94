/* sweep_report.c - prints the results of a sweep as text and JSON, and draws its
 * plot. */
#include "rt/study/sweep/sweep_report.h"

#include <stdarg.h>
#include <string.h>

const char sweep_points_heading[] =
    "Clocks per ray: scalar; in queues, with their causes";

void sweep_add_cells(struct table *table, const struct sweep_measure *measure)
{
    const struct sweep_form *queued = &measure->forms[SWEEP_QUEUED];
    table_number(table, sweep_hit_percent(measure));
    table_number(table, sweep_cost(measure, SWEEP_SCALAR));
    table_number(table, sweep_cost(measure, SWEEP_QUEUED));
    table_number(table, sweep_speedup(measure));
    for (int group = 0; group < SWEEP_GROUPS; group++)
        table_number(table, sweep_per_ray(measure,
                                          sweep_group_clocks(queued,
                                                             (enum sweep_group)group)));
}

void sweep_report_free(struct sweep_report *report)
{
    for (size_t i = 0; i < report->part_count; i++)
        table_free(report->parts[i].table);
}

struct table *sweep_report_table(struct sweep_report *report, const char *key,
                                 const char *heading,
                                 const struct table_column *columns, size_t count)
{
    struct table *table = table_new(columns, count);
    if (table)
        report->parts[report->part_count++] = (struct sweep_part){ key, heading,
                                                                   table };
    return table;
}

void sweep_report_line(struct sweep_report *report, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(report->lines[report->line_count++], SWEEP_LINE_SIZE, format, arguments);
    va_end(arguments);
}

/* ---- The plot ------------------------------------------------------------ */

void sweep_report_curve(struct sweep_report *report, size_t column, const char *title)
{
    report->curves[report->plot.curve_count++] = (struct plot_curve){ column, title,
                                                                      NULL };
    report->plot.curves = report->curves;
}

static struct plot_mark label_mark(struct sweep_report *report, double at,
                                   const char *format, va_list arguments)
{
    char *label = report->labels[report->label_count++];
    vsnprintf(label, SWEEP_LABEL_SIZE, format, arguments);
    return (struct plot_mark){ at, label };
}

void sweep_report_mark(struct sweep_report *report, double x, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    report->marks[report->plot.mark_count++] = label_mark(report, x, format, arguments);
    va_end(arguments);
    report->plot.marks = report->marks;
}

void sweep_report_level(struct sweep_report *report, double y, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    report->levels[report->plot.level_count++] = label_mark(report, y, format,
                                                            arguments);
    va_end(arguments);
    report->plot.levels = report->levels;
}

/* ---- Output -------------------------------------------------------------- */

bool sweep_report_write(const struct sweep_report *report, enum table_format format,
                        FILE *file)
{
    for (size_t i = 0; i < report->part_count; i++) {
        table_heading(report->parts[i].heading, format, file);
        if (!table_write(report->parts[i].table, format, file))
            return false;
    }
    if (report->line_count > 0)
        putc('\n', file);
    for (size_t i = 0; i < report->line_count; i++)
        fprintf(file, "%s%s\n", table_remark(format), report->lines[i]);
    return true;
}

static const struct table_column causes[] = {
    { "point", "point", TABLE_COUNT, 0 }, /* counted from 1, in the order of
                                           * measurement */
    { "queue", "queue", TABLE_COUNT, 0 }, { "form", "form", TABLE_TEXT, 0 },
    { "cause", "cause", TABLE_TEXT, 0 },  { "clocks", "clocks", TABLE_COUNT, 0 },
};

static void add_causes(struct table *table, size_t number,
                       const struct sweep_measure *measure, int form)
{
    const struct trace_options *trace = &measure->point.trace;
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        uint64_t clocks = measure->forms[form].clocks[cause];
        if (clocks == 0)
            continue;
        table_count(table, number);
        table_count(table, trace->queue);
        table_text(table,
                   trace_mode_name(form == SWEEP_SCALAR ? TRACE_SCALAR : trace->mode));
        table_text(table, c205_cause_name((c205_cause)cause));
        table_count(table, clocks);
    }
}

static bool json_causes(const struct sweep *sweep, struct json *json)
{
    struct table *table = table_new(TABLE_COLUMNS(causes));
    bool good;
    if (!table)
        return false;
    for (size_t i = 0; i < sweep->count; i++)
        for (int form = 0; form < SWEEP_FORMS; form++)
            add_causes(table, i + 1, &sweep->measures[i], form);
    good = table_json(table, json, "causes");
    table_free(table);
    return good;
}

bool sweep_report_json(const struct sweep_report *report, const struct sweep *sweep,
                       struct json *json)
{
    for (size_t i = 0; i < report->part_count; i++)
        if (!table_json(report->parts[i].table, json, report->parts[i].key))
            return false;
    json_array(json, "text");
    for (size_t i = 0; i < report->line_count; i++)
        json_text(json, NULL, report->lines[i]);
    json_end(json);
    return json_causes(sweep, json);
}
