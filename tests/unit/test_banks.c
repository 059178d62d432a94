/* test_banks.c - bank conflicts of long index lists are compared with the rule, access
 * by access, over random lists, tables, steps and numbers of banks. A shortcut for
 * repeated lists that gives other clocks fails here. */
#include "tests/random.h"
#include "tests/unit/unit.h"
#include "vm/time/banks.h"

#include <fenv.h>

enum { LISTS = 2000, MAX_LENGTH = 1500, MAX_BANKS = 70, AGAIN = 4 };

/* An access waits one access time after the previous one, and for its bank. */
static uint64_t by_the_rule(const struct banks *banks, uint64_t table, unsigned step,
                            const c205_word *indices, size_t count)
{
    uint64_t free_at[MAX_BANKS] = { 0 }, next = 0;
    for (size_t i = 0; i < count; i++) {
        uint64_t address = (table + indices[i] * step) & UINT64_C(0xFFFFFFFFFFFF);
        uint64_t *free_again = &free_at[address / 64 % banks->count];
        uint64_t begin = next < *free_again ? *free_again : next;
        *free_again = begin + banks->busy;
        next = begin + banks->access;
    }
    return next - count * banks->access;
}

/* Fills a list with ascending indices, indices of one bank, or random indices. */
static void fill(c205_word *indices, size_t count, size_t banks, uint64_t *seed)
{
    uint64_t kind = xorshift(seed) % 4, at = xorshift(seed) >> 16;
    for (size_t i = 0; i < count; i++) {
        uint64_t gap = kind == 0   ? 1 + xorshift(seed) % 3
                       : kind == 1 ? banks * (xorshift(seed) % 2)
                                   : xorshift(seed);
        at = kind == 2 ? gap % (3 * banks) : at + gap;
        indices[i] = at;
    }
}

/* Changes a list to the list of a later gather, usually the same list with another
 * table. */
static void change(c205_word *indices, size_t count, uint64_t *table, unsigned *step,
                   uint64_t *seed)
{
    switch (xorshift(seed) % 8) {
    case 0: *table = xorshift(seed) >> 16; break;
    case 1: *step = 96 - *step; break;
    case 2: *table = (UINT64_C(1) << 48) - 64 * (xorshift(seed) % 9); break;
    case 3:
        if (count > 0)
            indices[xorshift(seed) % count] += xorshift(seed) % 3;
        break;
    default: *table += 64 * (xorshift(seed) % 99) + xorshift(seed) % 16 / 15;
    }
}

static void check_list(uint64_t *seed)
{
    static c205_word indices[MAX_LENGTH];
    size_t count = (size_t)xorshift_between(seed, 0, MAX_LENGTH);
    uint64_t access = 1 + xorshift(seed) % 3;
    uint64_t table = xorshift(seed) >> 16, busy = xorshift(seed) % 16;
    unsigned step = xorshift(seed) % 4 ? 64 : 32;
    SCOPED_VALUE(banks) banks;
    SCOPED_VALUE(index_list) list = { 0 };
    assert_true(
        banks_init(&banks, (size_t)xorshift_between(seed, 1, MAX_BANKS), access, busy));
    fill(indices, count, banks.count, seed);
    for (int i = 0; i < AGAIN; i++) {
        index_list_meet(&list, indices, count);
        assert_int_equal(banks_conflicts(&banks, table, step, &list),
                         by_the_rule(&banks, table, step, indices, count));
        change(indices, count, &table, &step, seed);
    }
}

TEST(lists_by_chance)
{
    uint64_t seed = RANDOM_SEED;
    for (int i = 0; i < LISTS; i++)
        check_list(&seed);
}

/* The result does not depend on the caller's rounding mode. */
TEST(roundings)
{
    static const int ways[] = { FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO };
    uint64_t seed = RANDOM_SEED;
    int before = fegetround();
    for (size_t i = 0; i < 3 * LISTS; i++) {
        assert_int_equal(fesetround(ways[i % 3]), 0);
        check_list(&seed);
    }
    fesetround(before);
}
