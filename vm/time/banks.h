/* banks.h - memory banks, as far as gather and scatter feel them.
 *
 * Word w lies in bank w mod count.  A bank that was accessed is busy for some
 * clocks (80 ns: source P); an access to it waits, and those behind it wait
 * with it.  One access a clock at most.
 */
#ifndef C205_BANKS_H
#define C205_BANKS_H

#include "vm/time/index_list.h"

/* What the list that was met last took; of any other table the same if both are whole:
 * in whole words of the address space. */
struct bank_list {
    uint64_t number; /* the list's; 0: there was none */
    bool whole;
    uint64_t conflicts;
};

struct banks {
    size_t count;
    uint64_t access;   /* time of an access: a clock, in the clock's ticks */
    uint64_t busy;     /* how long one keeps its bank busy */
    uint64_t *free_at; /* when each takes the next access */
    struct bank_list latest;
};

bool banks_init(struct banks *banks, size_t count, uint64_t access, uint64_t busy);
void banks_free(struct banks *banks);

/* By how much the accesses to table + step x index, in this order, take
 * longer than one after the other; all banks are free at the beginning. */
uint64_t banks_conflicts(struct banks *banks, uint64_t table, unsigned step,
                         const struct index_list *list);

#endif
