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

static inline size_t accessed_bank(const struct banks *banks, double inverse,
                                   uint64_t address)
{
    return bank_of((address & ADDRESS_MASK) / WORD_BITS, banks->count,
                   inverse);
}

static inline uint64_t later(uint64_t a, uint64_t b)
{
    return a < b ? b : a;
}

/* A bank is free again before the access after LATEST more begins: only so
 * many need to be looked at, and no table of the banks. */
enum { LATEST = 3 };

struct access {
    size_t bank;
    uint64_t begin;
};

static inline uint64_t wait_for(struct access access, size_t bank,
                                uint64_t busy)
{
    return access.bank == bank ? access.begin + busy : 0;
}

static uint64_t conflicts_of_latest(const struct banks *banks, uint64_t table,
                                    unsigned step, const c205_word *indices,
                                    size_t count)
{
    double inverse = 1.0 / (double)banks->count;
    uint64_t access = banks->access, busy = banks->busy;
    struct access last = { SIZE_MAX, 0 - access };
    struct access second = { SIZE_MAX, 0 }, third = { SIZE_MAX, 0 };
    for (size_t i = 0; i < count; i++) {
        struct access next = {
            accessed_bank(banks, inverse, table + indices[i] * step), 0
        };
        next.begin = later(last.begin
                               + (next.bank == last.bank ? busy : access),
                           later(wait_for(second, next.bank, busy),
                                 wait_for(third, next.bank, busy)));
        third = second;
        second = last;
        last = next;
    }
    return last.begin + access - count * access;
}

static uint64_t conflicts_of_all(const struct banks *banks, uint64_t table,
                                 unsigned step, const c205_word *indices,
                                 size_t count)
{
    double inverse = 1.0 / (double)banks->count;
    uint64_t *free_at = banks->free_at;
    uint64_t clock = 0;
    memset(free_at, 0, banks->count * sizeof *free_at);
    for (size_t i = 0; i < count; i++) {
        uint64_t *bank = &free_at[accessed_bank(banks, inverse,
                                                table + indices[i] * step)];
        clock = later(clock, *bank);
        *bank = clock + banks->busy;
        clock += banks->access;
    }
    return clock - count * banks->access;
}

uint64_t banks_conflicts(struct banks *banks, uint64_t table, unsigned step,
                         const c205_word *indices, size_t count)
{
    if (banks->busy <= banks->access)
        return 0;
    return banks->busy <= (LATEST + 1) * banks->access
               ? conflicts_of_latest(banks, table, step, indices, count)
               : conflicts_of_all(banks, table, step, indices, count);
}
