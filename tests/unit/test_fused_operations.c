/* test_fused_operations.c - two operations in one pass are compared with two passes by
 * the rule for one word, over random operands. Bits and flags must be the same. A fast
 * path with another rounding, or a changed rounding mode, fails here. */
#include "tests/random.h"
#include "tests/unit/unit.h"
#include "vm/number/round_down.h"
#include "vm/number/pairs.h"

enum { TURNS = 40000, BELOW = 9, SLACK = 3 };

/* ---- Operands ------------------------------------------------------------ */

/* Returns a normalised word, sometimes extreme, or machine zero. */
static c205_word word_within(uint64_t *seed, int32_t low, int32_t high)
{
    int64_t half = INT64_C(1) << 46;
    const int64_t ends[] = { half, 2 * half - 1, -half - 1, -2 * half };
    size_t kind = xorshift(seed) % 16;
    int32_t e = (int32_t)xorshift_between(seed, low, high);
    if (kind < COUNT(ends))
        return word_make(e, ends[kind]);
    return kind == COUNT(ends) ? C205_MACHINE_ZERO : xorshift_normalised(seed, e, e);
}

/* Returns a random word that the fast path rejects. */
static c205_word stranger(uint64_t *seed)
{
    static const c205_word strangers[] = {
        UINT64_C(0x7000000000000000), UINT64_C(0x8001000000000001),
        UINT64_C(0x80FF7FFFFFFFFFFF), UINT64_C(0x7FFF400000000000),
        UINT64_C(0x0000000000000000), UINT64_C(0xFFFF000000000001),
        UINT64_C(0x0100400000000000), UINT64_C(0xFEFF800000000000),
    };
    return strangers[xorshift(seed) % COUNT(strangers)];
}

/* Fills words with exponents of a wide range, or of one where sums cancel. */
static void fill(c205_word *words, size_t n, uint64_t *seed)
{
    int32_t high = xorshift(seed) % 2 ? 255 : (int32_t)(xorshift(seed) % 50);
    int32_t low = xorshift(seed) % 2 ? -high - 1 : high - 3;
    for (size_t i = 0; i < n; i++)
        words[i] = word_within(seed, low, high);
}

/* ---- One operation after the other --------------------------------------- */

typedef struct operation {
    const char *name;
    lanes_binary *span;
    arith_binary *exact;
} operation;

static const operation operations[] = {
    { "add", lanes_add_normalised, arith_add_normalised },
    { "subtract", lanes_subtract_normalised, arith_subtract_normalised },
    { "multiply", lanes_multiply_significant, arith_multiply_significant },
    { "divide", lanes_divide_significant, arith_divide_significant },
};

struct pair {
    const operation *first, *second;
    bool hands_a;
    c205_word a[PAIR_LENGTH + BELOW], b[PAIR_LENGTH + BELOW];
    c205_word d[PAIR_LENGTH + BELOW];
    bool constant_a, constant_b;
    size_t n;
};

static c205_word exact_result(const struct pair *pair, size_t i, uint64_t *flags)
{
    c205_word handed = pair->first->exact(pair->a[pair->constant_a ? 0 : i],
                                          pair->b[pair->constant_b ? 0 : i], flags);
    return pair->hands_a ? pair->second->exact(handed, pair->d[i], flags)
                         : pair->second->exact(pair->d[i], handed, flags);
}

/* Returns true for the fast path's words: a moderate exponent, normalised or zero. */
static bool is_moderate(c205_word w)
{
    int32_t e = word_exponent(w);
    int64_t c = word_coefficient(w);
    bool normalised = c >= INT64_C(1) << 46 || c < -(INT64_C(1) << 46);
    return w == C205_MACHINE_ZERO || (e >= -256 && e <= 255 && normalised);
}

/* ---- Random pairs ----------------------------------------------------- */

static void make_pair(struct pair *pair, uint64_t *seed)
{
    pair->first = &operations[xorshift(seed) % COUNT(operations)];
    pair->second = &operations[xorshift(seed) % COUNT(operations)];
    pair->hands_a = xorshift(seed) % 2;
    pair->constant_a = xorshift(seed) % 3 == 0;
    pair->constant_b = xorshift(seed) % 3 == 0;
    pair->n = (size_t)xorshift_between(seed, 1, PAIR_LENGTH);
    fill(pair->a, pair->n, seed);
    fill(pair->b, pair->n, seed);
    fill(pair->d, pair->n, seed);
    c205_word *of[] = { pair->a, pair->b, pair->d };
    if (xorshift(seed) % 8 == 0)
        of[xorshift(seed) % 3][xorshift(seed) % pair->n] = stranger(seed);
}

/* Places the result apart from all operands, or `below` words before one of them. */
static c205_word *place_result(struct pair *pair, c205_word *apart, c205_word *read[3],
                               uint64_t *seed)
{
    size_t below = xorshift(seed) % BELOW, which = xorshift(seed) % 4;
    bool is_constant[] = { pair->constant_a, pair->constant_b, false };
    if (which == 3 || is_constant[which])
        return apart;
    memmove(read[which] + below, read[which], pair->n * sizeof *apart);
    c205_word *result = read[which];
    read[which] += below;
    return result;
}

static void check_pair(struct pair *pair, uint64_t *seed, size_t *done_count)
{
    static c205_word apart[PAIR_LENGTH + SLACK], expected[PAIR_LENGTH];
    static c205_word before[PAIR_LENGTH];
    lanes_pair *both = lanes_pair_of(pair->first->span, pair->second->span,
                                     pair->hands_a, !pair->hands_a);
    uint64_t flags = 5, exact_flags = 5; /* other flags are unchanged */
    c205_word *read[] = { pair->a, pair->b, pair->d };
    bool done = false, moderate = true;
    for (size_t i = 0; i < pair->n; i++) {
        expected[i] = exact_result(pair, i, &exact_flags);
        moderate = moderate && is_moderate(pair->a[i]) && is_moderate(pair->b[i])
                   && is_moderate(pair->d[i]);
    }
    if (!both)
        return;
    memset(apart, 0x5A, sizeof apart);
    c205_word *c = place_result(pair, apart, read, seed);
    memcpy(before, c, pair->n * sizeof *c);
    const pair_operand a = { read[0], pair->constant_a };
    const pair_operand b = { read[1], pair->constant_b };
    both(&done, c, a, b, read[2], pair->n, &flags);
    if (!done) {
        assert_int_equal(flags, 5);
        if (c != apart)
            assert_memory_equal(c, before, pair->n * sizeof *c);
        return;
    }
    *done_count += moderate;
    for (size_t i = 0; i < pair->n; i++)
        FAIL_IF(c[i] != expected[i], "%s, then %s %s: %016llX, not %016llX; %zu of %zu",
                pair->first->name, pair->second->name, pair->hands_a ? "with" : "from",
                (unsigned long long)c[i], (unsigned long long)expected[i], i, pair->n);
    assert_int_equal(flags, exact_flags);
    if (c == apart)
        for (size_t i = 0; i < SLACK; i++)
            assert_int_equal(c[pair->n + i], UINT64_C(0x5A5A5A5A5A5A5A5A));
}

/* Reads the current rounding mode. Returns false if the host cannot round down. */
static bool find_rounding(host_rounding *now)
{
    bool can = host_vectors() >= HOST_LANES && host_round_down(now);
    if (can)
        host_round_as(*now);
    return can;
}

TEST(pairs_by_chance)
{
    static struct pair pair;
    uint64_t seed = RANDOM_SEED;
    host_rounding now;
    bool can = find_rounding(&now);
    size_t done = 0;
    volatile double one = 1, fixture = 0x1p-60;
    for (int turn = 0; turn < TURNS; turn++) {
        make_pair(&pair, &seed);
        check_pair(&pair, &seed, &done);
        assert_true(one - fixture == one); /* the rounding mode is restored */
    }
    print_message("%zu pairs in one pass\n", done);
    if (can)
        assert_true(done > TURNS / 10);
}

/* The caller may enable floating-point exceptions of doubles. Only the first words are
 * checked in advance. Words with all exponents follow them. */
TEST(traps)
{
    static struct pair pair;
    uint64_t seed = RANDOM_SEED;
    host_rounding now, untrapped = 0x3FU << 7, inexact = 0x20U << 7;
    size_t done = 0;
    if (!find_rounding(&now))
        return;
    host_round_as((now & ~untrapped) | inexact);
    for (int turn = 0; turn < TURNS / 20; turn++) {
        make_pair(&pair, &seed);
        for (size_t i = 1; i < pair.n; i++)
            pair.a[i] = pair.b[i] = pair.d[i] = xorshift_normalised(&seed, -28672,
                                                                    28671);
        check_pair(&pair, &seed, &done);
    }
    host_round_as(now);
}
