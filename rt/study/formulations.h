/* formulations.h - compares formulations of the kernel for Table 1's cylinder. The
 * table has their times and the times of the paper. */
#ifndef RT_FORMULATIONS_H
#define RT_FORMULATIONS_H

#include "base/table.h"
#include "rt/study/speedup.h"

/* Returns a table that compares all formulations. measures[i] are the measures of
 * speedup_formulations[i] on the model. Returns NULL if out of memory. The caller frees
 * the table. */
struct table *formulations_table(const c205_model *model,
                                 const struct speedup_measure (*measures)[TRACE_FORMS]);

#endif
