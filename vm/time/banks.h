/* banks.h - memory banks, as far as they delay gather and scatter.
 *
 * Word w is in bank w mod count. An accessed bank is busy for some clocks (80 ns:
 * source P). An access to a busy bank waits, and all later accesses wait with it. At
 * most one access starts per clock.
 */
#ifndef C205_BANKS_H
#define C205_BANKS_H

#include "vm/time/index_list.h"

/* The result for the latest list. A list has the same conflicts with any other table if
 * both tables are whole: they start at a word, step by a word, and stay within the
 * address space. */
struct bank_list {
    uint64_t number; /* the list's; 0: none */
    bool whole;
    uint64_t conflicts;
};

struct banks {
    size_t count;
    uint64_t access;   /* time of an access: a clock, in the clock's ticks */
    uint64_t busy;     /* time for which an access keeps its bank busy */
    uint64_t *free_at; /* the time at which each bank takes the next access */
    struct bank_list latest;
};

bool banks_init(struct banks *banks, size_t count, uint64_t access, uint64_t busy);
void banks_free(struct banks *banks);

/* Returns the delay of the accesses to table + step x index, in this order, relative to
 * accesses without conflicts. All banks are free at the start. */
uint64_t banks_conflicts(struct banks *banks, uint64_t table, unsigned step,
                         const struct index_list *list);

#endif
