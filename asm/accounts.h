/* accounts.h - where the clocks of a run went, as tables. */
#ifndef ASM_ACCOUNTS_H
#define ASM_ACCOUNTS_H

#include "asm/table.h"

/* By the model's clock.period. */
double accounts_seconds(const c205_model *model, uint64_t clocks);
uint64_t accounts_clocks(const c205_account *account);

/* Clocks of the whole run by cause; causes without clocks are left out.  NULL:
 * no memory, here as below. */
struct table *accounts_of_run(const c205 *machine);
/* The same, and then that of each region. */
struct table *accounts_by_cause(const c205 *machine);
/* Instructions, elements and clocks of each region. */
struct table *accounts_by_region(const c205 *machine);

#endif
