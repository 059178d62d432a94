/* speedup_report.c - converts the results of rt205 speedup to tables. */
#include "rt/study/speedup_report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/accounts.h"
#include "rt/study/iterations_table.h"

/* The numbers of decimals are as in the paper. */
static const struct table_column table1[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "figures", "figures", TABLE_TEXT, 0 },
    { "scalar", "205 scalar, s", TABLE_NUMBER, 3 },
    { "vector", "205 vector, s", TABLE_NUMBER, 4 },
    { "cyber720", "720, s", TABLE_NUMBER, 2 },
    { "vector_over_scalar", "speedup over scalar", TABLE_NUMBER, 2 },
    { "vector_over_720", "speedup over 720", TABLE_NUMBER, 0 },
};

static const struct table_column rays[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "rays", "rays", TABLE_COUNT, 0 },
    { "hits", "hits", TABLE_COUNT, 0 },
    { "percent", "% hit", TABLE_NUMBER, 1 },
    { "eye", "eye", TABLE_TEXT, 0 },
    { "shape", "shape", TABLE_TEXT, 0 },
};

static const struct table_column times[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "form", "form", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "clocks_per_ray", "clocks/ray", TABLE_NUMBER, 2 },
};

static const struct table_column projected[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "machine", "projected on", TABLE_TEXT, 0 },
    { "seconds", "seconds", TABLE_NUMBER, 3 },
    { "speedup", "205 vector faster", TABLE_NUMBER, 1 },
};

static const struct table_column shares[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "form", "form", TABLE_TEXT, 0 },
    { "region", "region", TABLE_TEXT, 0 },
    { "clocks", "clocks", TABLE_COUNT, 0 },
    { "percent", "%", TABLE_NUMBER, 1 },
    { "paper_percent", "paper: %", TABLE_NUMBER, 0 },
};

static const struct table_column steps[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    { "form", "form", TABLE_TEXT, 0 },
    { "falsi", "falsi", TABLE_TEXT, 0 },
    ITERATIONS_COLUMNS,
};

static const struct table_column passes[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 },
    ITERATIONS_PASS_COLUMNS,
};

static const struct table_column causes[] = {
    { "primitive", "primitive", TABLE_TEXT, 0 }, { "form", "form", TABLE_TEXT, 0 },
    { "cause", "cause", TABLE_TEXT, 0 },         { "clocks", "clocks", TABLE_COUNT, 0 },
    { "percent", "%", TABLE_NUMBER, 1 },
};

enum row_kind { TABLE1, RAYS, TIMES, PROJECTED, SHARES, STEPS, PASSES, CAUSES, KINDS };

static const struct {
    const char *key, *heading;
    const struct table_column *columns;
    size_t count;
} kinds[KINDS] = {
    [TABLE1] = { "table1",
                 "Table 1, CPU seconds for 100,000 rays, and the speedup of the "
                 "205's vector form",
                 TABLE_COLUMNS(table1) },
    [RAYS] = { "rays", "The rays", TABLE_COLUMNS(rays) },
    [TIMES] = { "times", "The kernels and their calls", TABLE_COLUMNS(times) },
    [PROJECTED] = { "projected",
                    "A machine that Table 1 lacks, projected: "
                    "CPU seconds for 100,000 rays",
                    TABLE_COLUMNS(projected) },
    [SHARES] = { "shares", "Clocks by part", TABLE_COLUMNS(shares) },
    [STEPS] = { "steps",
                "Falsi in the root solver, to roots of the "
                "derivative (knots) and of the quartic",
                TABLE_COLUMNS(steps) },
    [PASSES] = { "passes", "The vector form, pass by pass", TABLE_COLUMNS(passes) },
    [CAUSES] = { "causes", "Where the clocks went", TABLE_COLUMNS(causes) },
};

struct speedup_report {
    const c205_model *model;
    struct table *tables[KINDS];
};

struct speedup_report *speedup_report_new(const c205_model *model)
{
    struct speedup_report *report = calloc(1, sizeof *report);
    if (!report)
        return NULL;
    report->model = model;
    for (int i = 0; i < KINDS; i++) {
        report->tables[i] = table_new(kinds[i].columns, kinds[i].count);
        if (!report->tables[i]) {
            speedup_report_free(report);
            return NULL;
        }
    }
    return report;
}

void speedup_report_free(struct speedup_report *report)
{
    if (!report)
        return;
    for (int i = 0; i < KINDS; i++)
        table_free(report->tables[i]);
    free(report);
}

static double percent(uint64_t part, uint64_t whole)
{
    return 100.0 * (double)part / (double)whole;
}

static double quotient(uint64_t a, uint64_t b)
{
    return (double)a / (double)b;
}

/* Returns a figure of the paper. If the paper does not contain it, returns NAN, which
 * becomes an empty cell. */
static double reported(double figure)
{
    return figure > 0 ? figure : NAN;
}

/* Scales seconds to the number of rays in the paper. */
static double scaled(double seconds, const struct speedup_measure *measure)
{
    return seconds * SPEEDUP_PAPER_RAYS / (double)measure->rays;
}

static double scaled_seconds(const c205_model *model,
                             const struct speedup_measure *measure)
{
    return scaled(accounts_seconds(model, measure->total), measure);
}

void speedup_figures(const c205_model *model,
                     const struct speedup_measure measures[TRACE_FORMS],
                     double figures[SPEEDUP_FIGURES])
{
    const struct speedup_measure *scalar = &measures[TRACE_SCALAR];
    double vector = scaled_seconds(model, &measures[TRACE_VECTOR]);
    figures[SPEEDUP_SCALAR_SECONDS] = scaled_seconds(model, scalar);
    figures[SPEEDUP_VECTOR_SECONDS] = vector;
    figures[SPEEDUP_720_SECONDS] = scaled(scalar->projected[SPEEDUP_720], scalar);
    figures[SPEEDUP_OVER_SCALAR] = figures[SPEEDUP_SCALAR_SECONDS] / vector;
    figures[SPEEDUP_OVER_720] = figures[SPEEDUP_720_SECONDS] / vector;
}

void speedup_paper_figures(const struct speedup_paper *paper,
                           double figures[SPEEDUP_FIGURES])
{
    figures[SPEEDUP_SCALAR_SECONDS] = paper->seconds[TRACE_SCALAR];
    figures[SPEEDUP_VECTOR_SECONDS] = paper->seconds[TRACE_VECTOR];
    figures[SPEEDUP_720_SECONDS] = paper->projected[SPEEDUP_720].seconds;
    figures[SPEEDUP_OVER_SCALAR] = paper->speedup;
    figures[SPEEDUP_OVER_720] = paper->projected[SPEEDUP_720].speedup;
}

double speedup_error(double figure, double reported)
{
    return 100 * (figure / reported - 1);
}

static void add_figures(struct table *table, const char *primitive, const char *whose,
                        const double figures[SPEEDUP_FIGURES])
{
    table_text(table, primitive);
    table_text(table, whose);
    for (int i = 0; i < SPEEDUP_FIGURES; i++)
        table_number(table, figures[i]);
}

static void add_table1(struct speedup_report *report,
                       const struct speedup_subject *subject,
                       const struct speedup_measure measures[TRACE_FORMS])
{
    struct table *table = report->tables[TABLE1];
    double ours[SPEEDUP_FIGURES], paper[SPEEDUP_FIGURES];
    speedup_figures(report->model, measures, ours);
    speedup_paper_figures(&subject->paper, paper);
    add_figures(table, subject->name, "ours", ours);
    if (paper[SPEEDUP_SCALAR_SECONDS] == 0)
        return;
    add_figures(table, subject->name, "paper", paper);
    table_text(table, subject->name);
    table_text(table, "error %");
    for (int i = 0; i < SPEEDUP_FIGURES; i++)
        table_signed(table, speedup_error(ours[i], paper[i]), 1);
}

static void add_rays(struct table *table, const struct speedup_subject *subject,
                     const struct speedup_view *view,
                     const struct speedup_measure *measure)
{
    char eye[64];
    snprintf(eye, sizeof eye, "<%g, %g, %g>", view->distance * subject->from[0],
             view->distance * subject->from[1], view->distance * subject->from[2]);
    table_text(table, subject->name);
    table_count(table, measure->rays);
    table_count(table, measure->hits);
    table_number(table, percent(measure->hits, measure->rays));
    table_text(table, eye);
    table_text(table, subject->shape);
}

static void add_name(struct table *table, const struct speedup_subject *subject,
                     int mode)
{
    table_text(table, subject->name);
    table_text(table, trace_mode_name((enum trace_mode)mode));
}

static void add_times(struct table *table, const struct speedup_subject *subject,
                      int mode, const struct speedup_measure *measure)
{
    add_name(table, subject, mode);
    table_count(table, measure->total);
    table_number(table, quotient(measure->total, measure->rays));
}

/* Adds a row for the projection to the 6600. The projection to the CYBER 720 is in
 * Table 1. */
static void add_projected(struct speedup_report *report,
                          const struct speedup_subject *subject,
                          const struct speedup_measure measures[TRACE_FORMS])
{
    struct table *table = report->tables[PROJECTED];
    const struct speedup_measure *scalar = &measures[TRACE_SCALAR];
    double seconds = scaled(scalar->projected[SPEEDUP_6600], scalar);
    table_text(table, subject->name);
    table_text(table, speedup_projections[SPEEDUP_6600]);
    table_number(table, seconds);
    table_number(table,
                 seconds / scaled_seconds(report->model, &measures[TRACE_VECTOR]));
}

static void add_shares(struct table *table, const struct speedup_subject *subject,
                       int mode, const struct speedup_measure *measure)
{
    for (size_t i = 0; i < MAX_SPEEDUP_REGIONS; i++) {
        const char *region = subject->regions[i];
        if (!region)
            break;
        add_name(table, subject, mode);
        table_text(table, region);
        table_count(table, measure->regions[i]);
        table_number(table, percent(measure->regions[i], measure->total));
        table_number(table, strcmp(region, speedup_solver) == 0
                                ? reported(subject->paper.solver)
                                : NAN);
    }
}

static void add_steps(struct table *table, const struct speedup_subject *subject,
                      int mode, const struct speedup_measure *measure)
{
    for (int i = 0; i < STAGES; i++) {
        if (measure->iterations.stage[i].brackets == 0)
            continue;
        add_name(table, subject, mode);
        table_text(table, falsi_name(measure->falsi));
        iterations_add(table, &measure->iterations, (enum stage)i);
    }
}

static void add_passes(struct table *table, const struct speedup_subject *subject,
                       const struct speedup_measure *measure)
{
    const struct iterations *iterations = &measure->iterations;
    for (int i = 0; i < STAGES; i++) {
        size_t count = iterations_passes(iterations, (enum stage)i);
        for (size_t pass = 0; pass < count; pass++) {
            table_text(table, subject->name);
            iterations_add_pass(table, iterations, (enum stage)i, pass);
        }
    }
}

static void add_causes(struct table *table, const struct speedup_subject *subject,
                       int mode, const struct speedup_measure *measure)
{
    for (int cause = 0; cause < C205_CAUSES; cause++) {
        if (measure->clocks[cause] == 0)
            continue;
        add_name(table, subject, mode);
        table_text(table, c205_cause_name((c205_cause)cause));
        table_count(table, measure->clocks[cause]);
        table_number(table, percent(measure->clocks[cause], measure->total));
    }
}

void speedup_report_add(struct speedup_report *report,
                        const struct speedup_subject *subject,
                        const struct speedup_view *view,
                        const struct speedup_measure measures[TRACE_FORMS])
{
    struct table *const *tables = report->tables;
    add_table1(report, subject, measures);
    add_rays(tables[RAYS], subject, view, &measures[TRACE_VECTOR]);
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        add_times(tables[TIMES], subject, mode, &measures[mode]);
        add_shares(tables[SHARES], subject, mode, &measures[mode]);
        add_steps(tables[STEPS], subject, mode, &measures[mode]);
        add_causes(tables[CAUSES], subject, mode, &measures[mode]);
    }
    add_projected(report, subject, measures);
    add_passes(tables[PASSES], subject, &measures[TRACE_VECTOR]);
}

static bool print_table(const struct speedup_report *report, enum row_kind kind,
                        enum table_format format, FILE *file)
{
    table_heading(kinds[kind].heading, format, file);
    return table_write(report->tables[kind], format, file);
}

bool speedup_report_table1(const struct speedup_report *report,
                           enum table_format format, FILE *file)
{
    return print_table(report, TABLE1, format, file);
}

bool speedup_report_detail(const struct speedup_report *report,
                           enum table_format format, FILE *file)
{
    for (int i = TABLE1 + 1; i < KINDS; i++)
        if (i != PASSES && !print_table(report, (enum row_kind)i, format, file))
            return false;
    return true;
}

bool speedup_report_passes(const struct speedup_report *report,
                           enum table_format format, FILE *file)
{
    return print_table(report, PASSES, format, file);
}

bool speedup_report_json(const struct speedup_report *report, struct json *json)
{
    for (int i = 0; i < KINDS; i++)
        if (!table_json(report->tables[i], json, kinds[i].key))
            return false;
    return true;
}
