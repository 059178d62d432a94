/* banks.c - computes the conflicts of a list of accesses to interleaved memory banks.
 *
 * If a bank is busy for at most the time of LATEST + 1 accesses, an access can wait
 * only for one of the LATEST accesses before it. The loops then vectorise and need no
 * table of banks. Otherwise a table contains the time at which each bank becomes free.
 * The conflicts of the latest list of indices are cached, because programs use the same
 * list for several tables.
 */
#include "vm/time/banks.h"

#include "vm/memory.h"
#include "vm/min_max.h"
#include "vm/number/host.h"

#include <stdlib.h>
#include <string.h>

bool banks_init(struct banks *banks, size_t count, uint64_t access, uint64_t busy)
{
    banks->count = count;
    banks->access = access;
    banks->busy = busy;
    banks->latest = (struct bank_list){ 0 };
    banks->free_at = malloc(count * sizeof *banks->free_at);
    return banks->free_at;
}

void banks_free(struct banks *banks)
{
    free(banks->free_at);
}

/* ---- Banks of accesses ---------------------------------------------------- */

/* SPAN is the number of accesses that are processed at once. LATEST is the number of
 * preceding accesses with which an access is compared. */
enum { SPAN = 256, LATEST = 3 };

/* Returns d rounded to an integer: adding a large number removes the fraction bits. The
 * assignment to a variable removes excess precision. */
static inline double nearest_whole(double d)
{
    double large = 0x1p52, sum = d + large;
    return sum - large;
}

/* Computes the bank of each access: the word address, below 2^42, modulo count. The
 * quotient in double arithmetic is off by at most 1 in every rounding mode of the host.
 * The remainder is then corrected. */
#define FIND_BANKS_PARAMETERS \
    (double *restrict bank, const c205_word *restrict indices, size_t n, \
     uint64_t table, uint64_t step, double count)
LANEWISE void find_banks_span FIND_BANKS_PARAMETERS
{
    for (size_t i = 0; i < n; i++) {
        uint64_t address = (table + indices[i] * step) & ADDRESS_MASK;
        double word = (double)(int64_t)(address / WORD_BITS);
        double rest = word - nearest_whole(word * (1 / count)) * count;
        rest = rest < 0 ? rest + count : rest;
        bank[i] = rest >= count ? rest - count : rest;
    }
}

/* The minimum times from the starts of the last, second last and third last access to
 * the start of access i. The array of banks begins with the banks of the LATEST
 * preceding accesses. */
struct waits {
    int64_t last[SPAN], second[SPAN + 1], third[SPAN + 1];
};
#define FIND_WAITS_PARAMETERS \
    (struct waits *restrict waits, const double *restrict bank, size_t n, \
     int64_t access, int64_t busy)
LANEWISE void find_waits_span FIND_WAITS_PARAMETERS
{
    for (size_t i = 0; i < n; i++) {
        const double *at = bank + LATEST + i;
        waits->last[i] = at[0] == at[-1] ? busy : access;
        waits->second[i] = at[0] == at[-2] ? busy : 0;
        waits->third[i] = at[0] == at[-3] ? busy : 0;
    }
    waits->second[n] = waits->third[n] = 0;
}

static void find_banks FIND_BANKS_PARAMETERS;
static void find_waits FIND_WAITS_PARAMETERS;
VERSIONS(find_banks, find_banks_span, FIND_BANKS_PARAMETERS,
         (bank, indices, n, table, step, count))
VERSIONS(find_waits, find_waits_span, FIND_WAITS_PARAMETERS,
         (waits, bank, n, access, busy))

/* ---- Conflicts ------------------------------------------------------------ */

/* The start times of the latest accesses. */
struct begun {
    int64_t last, second, third;
};

/* Computes the start time of each access. The part that does not depend on the last
 * access is computed in advance, so each access adds only one sum and one maximum to
 * the chain of dependences. */
static void begin_accesses(struct begun *begun, const struct waits *waits, size_t n)
{
    struct begun now = *begun;
    int64_t earliest = max_int64(now.second + waits->second[0],
                                 now.third + waits->third[0]);
    for (size_t i = 0; i < n; i++) {
        int64_t next = max_int64(now.last + waits->last[i], earliest);
        now.third = now.second;
        now.second = now.last;
        now.last = next;
        earliest = max_int64(now.second + waits->second[i + 1],
                             now.third + waits->third[i + 1]);
    }
    *begun = now;
}

static uint64_t conflicts_of_latest(const struct banks *banks, uint64_t table,
                                    unsigned step, const c205_word *indices,
                                    size_t count)
{
    int64_t access = (int64_t)banks->access, busy = (int64_t)banks->busy;
    struct begun begun = { -access, -access, -access };
    double bank[LATEST + SPAN] = { -1, -1, -1 }; /* begins with the banks of the
                                                    preceding accesses */
    struct waits waits;
    for (size_t i = 0, n; i < count; i += n) {
        n = count - i < SPAN ? count - i : SPAN;
        find_banks(bank + LATEST, indices + i, n, table, step, (double)banks->count);
        find_waits(&waits, bank, n, access, busy);
        begin_accesses(&begun, &waits, n);
        memmove(bank, bank + n, LATEST * sizeof *bank);
    }
    return (uint64_t)(begun.last + access) - count * banks->access;
}

static uint64_t conflicts_of_all(const struct banks *banks, uint64_t table,
                                 unsigned step, const c205_word *indices, size_t count)
{
    uint64_t *free_at = banks->free_at;
    uint64_t clock = 0;
    double bank[SPAN];
    memset(free_at, 0, banks->count * sizeof *free_at);
    for (size_t i = 0; i < count; i++) {
        if (i % SPAN == 0)
            find_banks(bank, indices + i, count - i < SPAN ? count - i : SPAN, table,
                       step, (double)banks->count);
        uint64_t *free = &free_at[(size_t)bank[i % SPAN]];
        clock = clock < *free ? *free : clock;
        *free = clock + banks->busy;
        clock += banks->access;
    }
    return clock - count * banks->access;
}

static uint64_t conflicts(const struct banks *banks, uint64_t table, unsigned step,
                          const c205_word *indices, size_t count)
{
    return banks->busy <= (LATEST + 1) * banks->access
               ? conflicts_of_latest(banks, table, step, indices, count)
               : conflicts_of_all(banks, table, step, indices, count);
}

/* ---- A list that is used again ------------------------------------------ */

/* Returns true if the bank of every access changes by the same number when the table
 * moves. This holds if no address wraps around to the start of memory. */
static bool is_whole(uint64_t table, unsigned step, c205_word spread)
{
    return step == WORD_BITS && table % WORD_BITS == 0
           && spread < ADDRESS_SPACE_WORDS - table / WORD_BITS;
}

uint64_t banks_conflicts(struct banks *banks, uint64_t table, unsigned step,
                         const struct index_list *list)
{
    struct bank_list *latest = &banks->latest;
    bool whole = is_whole(table, step, list->spread);
    if (banks->busy <= banks->access)
        return 0;
    if (whole && latest->whole && latest->number == list->number)
        return latest->conflicts;
    latest->number = list->number;
    latest->whole = whole;
    latest->conflicts = conflicts(banks, table, step, list->indices, list->count);
    return latest->conflicts;
}
