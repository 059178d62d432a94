/* speedup_report.h - what rt205 speedup has measured, as tables.
 *
 * The same tables are printed, in several formats, and written as JSON.
 */
#ifndef RT_SPEEDUP_REPORT_H
#define RT_SPEEDUP_REPORT_H

#include "base/table.h"
#include "rt/study/speedup.h"

/* A line of Table 1: CPU seconds for SPEEDUP_PAPER_RAYS, and how much faster
 * the 205's vector form is. */
enum speedup_figure {
    SPEEDUP_SCALAR_SECONDS,
    SPEEDUP_VECTOR_SECONDS,
    SPEEDUP_720_SECONDS,
    SPEEDUP_OVER_SCALAR,
    SPEEDUP_OVER_720,
    SPEEDUP_FIGURES
};
void speedup_figures(const c205_model *model,
                     const struct speedup_measure measures[TRACE_FORMS],
                     double figures[SPEEDUP_FIGURES]);
void speedup_paper_figures(const struct speedup_paper *paper,
                           double figures[SPEEDUP_FIGURES]);
/* By how many percent a figure is off. */
double speedup_error(double figure, double reported);

struct speedup_report;

/* The model, whose seconds count, must outlive it.  NULL: no memory. */
struct speedup_report *speedup_report_new(const c205_model *model);
void speedup_report_free(struct speedup_report *report);

/* What both forms took on the model, and the scalar one on those of
 * speedup_projection_model. */
void speedup_report_add(struct speedup_report *report,
                        const struct speedup_subject *subject,
                        const struct speedup_view *view,
                        const struct speedup_measure measures[TRACE_FORMS]);

/* The paper's Table 1: of each primitive our figures, the paper's, and by how
 * many percent ours are off.  False: memory ran out. */
bool speedup_report_table1(const struct speedup_report *report,
                           enum table_format format, FILE *file);
/* All other tables, but for that pass by pass, which is long.  False: memory ran
 * out, here as below. */
bool speedup_report_detail(const struct speedup_report *report,
                           enum table_format format, FILE *file);
bool speedup_report_passes(const struct speedup_report *report,
                           enum table_format format, FILE *file);
/* Every one of them.  False: memory ran out, and the JSON is to be dropped. */
bool speedup_report_json(const struct speedup_report *report, struct json *json);

#endif
