/* banks.h - computes the delays that busy memory banks cause to gather and scatter.
 *
 * Word w is in bank w mod count. An access makes its bank busy for some clocks (80 ns,
 * from a primary source). An access to a busy bank waits, and so do all later accesses.
 * At most one access starts per clock.
 */
#ifndef C205_BANKS_H
#define C205_BANKS_H

#include "vm/time/index_list.h"

/* The bank conflicts of the latest list of indices. They are the same for all tables
 * from which the list accesses whole words without reaching the end of the address
 * space. */
struct bank_list {
    uint64_t number; /* number of the list; 0: none */
    bool whole;
    uint64_t conflicts;
};

struct banks {
    size_t count;
    uint64_t access;   /* ticks of an access; an access takes one clock */
    uint64_t busy;     /* ticks for which an access keeps its bank busy */
    uint64_t *free_at; /* the time at which each bank becomes free */
    struct bank_list latest;
};

bool banks_init(struct banks *banks, size_t count, uint64_t access, uint64_t busy);
void banks_free(struct banks *banks);

/* Returns the delay that bank conflicts cause in a sequence of accesses to the
 * addresses table + step x index. All banks are free at the start. */
uint64_t banks_conflicts(struct banks *banks, uint64_t table, unsigned step,
                         const struct index_list *list);

#endif
