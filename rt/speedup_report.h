/* speedup_report.h - what rt205 speedup has measured, as tables.
 *
 * The same tables are printed and written as JSON.
 */
#ifndef RT_SPEEDUP_REPORT_H
#define RT_SPEEDUP_REPORT_H

#include "asm/json.h"
#include "rt/speedup.h"

struct speedup_report;

/* The model, whose seconds count, must outlive it.  NULL: no memory. */
struct speedup_report *speedup_report_new(const c205_model *model);
void speedup_report_free(struct speedup_report *report);

/* What both forms took. */
void speedup_report_add(struct speedup_report *report,
                        const struct speedup_subject *subject,
                        const struct speedup_view *view,
                        const struct speedup_measure measures[TRACE_FORMS]);

/* The table pass by pass, which is long, only if wanted.  False: memory ran
 * out, or a write error. */
bool speedup_report_print(const struct speedup_report *report,
                          bool with_passes, FILE *file);
/* All tables. */
void speedup_report_json(const struct speedup_report *report,
                         struct json *json);

#endif
