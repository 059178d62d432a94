/* formulations.h - makes a table of Table 1's cylinder in several formulations, with
 * their times and the times of the paper. */
#ifndef RT_FORMULATIONS_H
#define RT_FORMULATIONS_H

#include "base/table.h"
#include "rt/study/speedup.h"

/* Returns the table. measures[i] belongs to speedup_formulations[i], on the model.
 * Returns NULL if out of memory. The caller frees the table. */
struct table *formulations_table(const c205_model *model,
                                 const struct speedup_measure (*measures)[TRACE_FORMS]);

#endif
