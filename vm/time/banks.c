/* banks.c - conflicts of a list of accesses to interleaved memory banks. */
#include "vm/time/banks.h"

#include "vm/memory.h"

#include <stdlib.h>
#include <string.h>

bool banks_init(struct banks *banks, size_t count, uint64_t access,
                uint64_t busy)
{
    banks->count = count;
    banks->access = access;
    banks->busy = busy;
    banks->free_at = malloc(count * sizeof *banks->free_at);
    return banks->free_at;
}

void banks_free(struct banks *banks)
{
    free(banks->free_at);
}

/* What is left of an address, by the double quotient: it lies below 2^42, so
 * that the whole quotient is one too many or too few at most. */
static inline size_t bank_of(uint64_t word, uint64_t count, double inverse)
{
    int64_t quotient = (int64_t)((double)(int64_t)word * inverse);
    int64_t bank = (int64_t)word - quotient * (int64_t)count;
    bank += bank < 0 ? (int64_t)count : 0;
    bank -= bank >= (int64_t)count ? (int64_t)count : 0;
    return (size_t)bank;
}

uint64_t banks_conflicts(struct banks *banks, uint64_t table, unsigned step,
                         const c205_word *indices, size_t count)
{
    double inverse = 1.0 / (double)banks->count;
    uint64_t bank_count = banks->count, busy = banks->busy;
    uint64_t access = banks->access;
    uint64_t *free_at = banks->free_at;
    uint64_t clock = 0;
    memset(free_at, 0, banks->count * sizeof *free_at);
    for (size_t i = 0; i < count; i++) {
        uint64_t address = (table + indices[i] * step) & ADDRESS_MASK;
        uint64_t word = address / WORD_BITS;
        uint64_t *bank = &free_at[bank_of(word, bank_count, inverse)];
        clock = clock < *bank ? *bank : clock;
        *bank = clock + busy;
        clock += access;
    }
    return clock - count * access;
}
