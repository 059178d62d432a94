/* speedup_report.h - converts the results of rt205 speedup to tables.
 *
 * The same tables are printed in several formats and written as JSON.
 */
#ifndef RT_SPEEDUP_REPORT_H
#define RT_SPEEDUP_REPORT_H

#include "base/table.h"
#include "rt/study/speedup.h"

/* The figures in a line of Table 1: CPU seconds for SPEEDUP_PAPER_RAYS, and the speedup
 * of the vector form on the 205. */
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
/* Returns the error of a figure in percent of the reported figure. */
double speedup_error(double figure, double reported);

struct speedup_report;

/* Returns an empty report, or NULL if out of memory. The model, which converts clocks
 * to seconds, must outlive the report. */
struct speedup_report *speedup_report_new(const c205_model *model);
void speedup_report_free(struct speedup_report *report);

/* Adds the measures of a subject: both forms on the model, and the scalar form on the
 * models of speedup_projection_model. */
void speedup_report_add(struct speedup_report *report,
                        const struct speedup_subject *subject,
                        const struct speedup_view *view,
                        const struct speedup_measure measures[TRACE_FORMS]);

/* Prints the paper's Table 1. Each primitive has the measured figures, the paper's
 * figures, and the errors of the measured figures in percent. Returns false if out of
 * memory. */
bool speedup_report_table1(const struct speedup_report *report,
                           enum table_format format, FILE *file);
/* speedup_report_detail prints all other tables, except the long table by pass, which
 * speedup_report_passes prints. Both return false if out of memory. */
bool speedup_report_detail(const struct speedup_report *report,
                           enum table_format format, FILE *file);
bool speedup_report_passes(const struct speedup_report *report,
                           enum table_format format, FILE *file);
/* Writes all tables as JSON. If out of memory, returns false; the JSON must then be
 * discarded. */
bool speedup_report_json(const struct speedup_report *report, struct json *json);

#endif
