/* formulations.h - Table 1's cylinder in the formulations that were tried: a
 * table with their times beside the paper's.
 */
#ifndef RT_FORMULATIONS_H
#define RT_FORMULATIONS_H

#include "base/table.h"
#include "rt/study/speedup.h"

/* measures[i] of speedup_formulations[i], on the model.  The caller frees it;
 * NULL: no memory. */
struct table *formulations_table(const c205_model *model,
                                 const struct speedup_measure (*measures)[TRACE_FORMS]);

#endif
