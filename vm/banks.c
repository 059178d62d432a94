/* banks.c - conflicts of a list of accesses to interleaved memory banks. */
#include "banks.h"

#include "memory.h"

#include <stdlib.h>
#include <string.h>

bool banks_init(struct banks *banks, size_t count, uint64_t busy)
{
    banks->count = count;
    banks->busy = busy;
    banks->free_at = malloc(count * sizeof *banks->free_at);
    return banks->free_at;
}

void banks_free(struct banks *banks)
{
    free(banks->free_at);
}

uint64_t banks_conflicts(struct banks *banks, uint64_t table,
                         unsigned step, const c205_word *indices,
                         size_t count)
{
    uint64_t clock = 0;
    memset(banks->free_at, 0, banks->count * sizeof *banks->free_at);
    for (size_t i = 0; i < count; i++) {
        uint64_t word = ((table + indices[i] * step) & ADDRESS_MASK) >> 6;
        uint64_t *free_at = &banks->free_at[word % banks->count];
        if (clock < *free_at)
            clock = *free_at;
        *free_at = clock + banks->busy;
        clock++;
    }
    return clock - count;
}
