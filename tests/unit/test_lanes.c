/* test_lanes.c - spans against the rule for one word: the same bits, the same
 * flags, for every length. */
#include "tests/random.h"
#include "vm/lanes.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

enum {
    LENGTH_MAX = 257,
    SLACK = 3, /* words behind a span, which must stay as they are */
    SPAN = LENGTH_MAX + SLACK,
    BITS = (LENGTH_MAX + 63) / 64 + SLACK,
    LONG_LENGTH = 4096,
    ROUNDS = 30
};

/* ---- Operands ----------------------------------------------------------- */

static const c205_word specials[] = {
    UINT64_C(0x8000000000000000), UINT64_C(0x8FFFFFFFFFFFFFFF),
    UINT64_C(0x8FFF800000000000), UINT64_C(0x8FFF7FFFFFFFFFFF),
    UINT64_C(0x7000000000000000), UINT64_C(0x7FFFFFFFFFFFFFFF),
    UINT64_C(0x7000400000000000), UINT64_C(0x7000800000000000),
    UINT64_C(0x9000400000000000), UINT64_C(0x9000800000000000),
    UINT64_C(0x90007FFFFFFFFFFF), UINT64_C(0x9000BFFFFFFFFFFF),
    UINT64_C(0x6FFF400000000000), UINT64_C(0x6FFF800000000000),
    UINT64_C(0x6FFF7FFFFFFFFFFF), UINT64_C(0x6FFFBFFFFFFFFFFF),
    UINT64_C(0x0000000000000000), UINT64_C(0x0000FFFFFFFFFFFF),
    UINT64_C(0x0000000000000001), UINT64_C(0x0000C00000000000),
    UINT64_C(0xFFD2400000000000), UINT64_C(0xFFD1800000000000),
    UINT64_C(0xFFD27FFFFFFFFFFF), UINT64_C(0xFFD2BFFFFFFFFFFF),
    UINT64_C(0x6FFF000000000000), UINT64_C(0x9000000000000000),
};

static c205_word special(uint64_t *seed)
{
    return specials[xorshift(seed) % (sizeof specials / sizeof *specials)];
}

static c205_word near(uint64_t *seed)
{
    return xorshift_normalised(seed, -49, -45);
}

static c205_word around(uint64_t *seed)
{
    return xorshift_normalised(seed, -100, 10);
}

static c205_word near_top(uint64_t *seed)
{
    return xorshift_normalised(seed, WORD_EXPONENT_MAX - 3,
                               WORD_EXPONENT_MAX);
}

static c205_word near_bottom(uint64_t *seed)
{
    return xorshift_normalised(seed, WORD_EXPONENT_MIN,
                               WORD_EXPONENT_MIN + 50);
}

static c205_word anywhere(uint64_t *seed)
{
    return xorshift_normalised(seed, WORD_EXPONENT_MIN, WORD_EXPONENT_MAX);
}

static c205_word or_machine_zero(uint64_t *seed)
{
    return xorshift(seed) % 4 == 0 ? C205_MACHINE_ZERO : around(seed);
}

static c205_word unnormalised(uint64_t *seed)
{
    return xorshift_unnormalised(seed, -100, 10);
}

/* Coefficients of few ones or zeros: where carries go far. */
static c205_word sparse(uint64_t *seed)
{
    const c205_word word = around(seed);
    const int64_t c = word_coefficient(word);
    const int64_t kept = -(INT64_C(1) << xorshift_between(seed, 0, 46));

    return word_make(word_exponent(word), c < 0 ? c | ~kept : c & kept);
}

static c205_word mostly_usual(uint64_t *seed)
{
    return xorshift(seed) % 64 == 0 ? special(seed) : near(seed);
}

typedef c205_word supply(uint64_t *seed);
static supply *const supplies[] = {
    special,  near,         around, near_top,     near_bottom, anywhere,
    xorshift, unnormalised, sparse, mostly_usual, or_machine_zero,
};

static void fill(c205_word *words, size_t n, supply *next, uint64_t *seed)
{
    for (size_t i = 0; i < n; i++)
        words[i] = next(seed);
}

/* ---- The operations ----------------------------------------------------- */

typedef c205_word exact_binary(c205_word a, c205_word b, uint64_t *flags);
typedef c205_word exact_unary(c205_word a, uint64_t *flags);
typedef bool exact_compare(c205_word a, c205_word b);

#define LOGICAL(name, result)                                              \
    static c205_word exact_##name(c205_word a, c205_word b,                \
                                  uint64_t *flags)                         \
    {                                                                      \
        (void)flags;                                                       \
        return result;                                                     \
    }
LOGICAL(xor, a ^ b)
LOGICAL(and, a & b)
LOGICAL(or, a | b)
LOGICAL(nand, ~(a & b))
LOGICAL(nor, ~(a | b))
LOGICAL(or_not, a | ~b)
LOGICAL(and_not, a & ~b)
LOGICAL(equivalence, ~(a ^ b))
LOGICAL(shift, arith_shift(a, c205_to_integer(b)))

static c205_word exact_copy(c205_word a, uint64_t *flags)
{
    (void)flags;
    return a;
}

#define ROW(name) {#name, lanes_##name, arith_##name}
#define LOGICAL_ROW(name) {#name, lanes_##name, exact_##name}

static const struct {
    const char *name;
    lanes_binary *span;
    exact_binary *exact;
} binaries[] = {
    ROW(add_upper), ROW(add_lower), ROW(add_normalised),
    ROW(subtract_upper), ROW(subtract_lower), ROW(subtract_normalised),
    ROW(multiply_upper), ROW(multiply_lower), ROW(multiply_significant),
    ROW(divide_upper), ROW(divide_significant), ROW(average),
    ROW(average_difference), LOGICAL_ROW(xor), LOGICAL_ROW(and),
    LOGICAL_ROW(or), LOGICAL_ROW(nand), LOGICAL_ROW(nor),
    LOGICAL_ROW(or_not), LOGICAL_ROW(and_not), LOGICAL_ROW(equivalence),
    LOGICAL_ROW(shift),
};

static const struct {
    const char *name;
    lanes_unary *span;
    exact_unary *exact;
} unaries[] = {
    ROW(square_root), ROW(truncate), ROW(floor), ROW(absolute), ROW(negate),
    ROW(exponent), LOGICAL_ROW(copy),
};

static const struct {
    const char *name;
    lanes_compare *span;
    exact_compare *exact;
} compares[] = {ROW(equal), ROW(not_equal), ROW(not_less), ROW(less)};

#define SIZE(table) (sizeof(table) / sizeof *(table))

/* ---- Spans against words ------------------------------------------------ */

/* Flags that no operation sets stay. */
static const uint64_t other_flags = 5;

static void check_binary(size_t op, const c205_word *a, const c205_word *b,
                         size_t n)
{
    static c205_word c[LONG_LENGTH + SLACK];
    uint64_t flags = other_flags, exact_flags = other_flags;

    memset(c, 0x5A, (n + SLACK) * sizeof *c);
    binaries[op].span(c, a, b, n, &flags);
    for (size_t i = 0; i < n; i++) {
        const c205_word exact = binaries[op].exact(a[i], b[i], &exact_flags);
        if (c[i] != exact)
            fail_msg("%s(%016llX, %016llX) = %016llX, not %016llX; "
                     "lane %zu of %zu", binaries[op].name,
                     (unsigned long long)a[i], (unsigned long long)b[i],
                     (unsigned long long)c[i], (unsigned long long)exact, i,
                     n);
    }
    if (flags != exact_flags)
        fail_msg("%s, length %zu: flags %llX, not %llX", binaries[op].name,
                 n, (unsigned long long)flags,
                 (unsigned long long)exact_flags);
    for (size_t i = 0; i < SLACK; i++)
        assert_int_equal(c[n + i], UINT64_C(0x5A5A5A5A5A5A5A5A));
}

static void check_unary(size_t op, const c205_word *a, size_t n)
{
    static c205_word c[LONG_LENGTH + SLACK];
    uint64_t flags = other_flags, exact_flags = other_flags;

    memset(c, 0x5A, (n + SLACK) * sizeof *c);
    unaries[op].span(c, a, n, &flags);
    for (size_t i = 0; i < n; i++) {
        const c205_word exact = unaries[op].exact(a[i], &exact_flags);
        if (c[i] != exact)
            fail_msg("%s(%016llX) = %016llX, not %016llX; lane %zu of %zu",
                     unaries[op].name, (unsigned long long)a[i],
                     (unsigned long long)c[i], (unsigned long long)exact, i,
                     n);
    }
    if (flags != exact_flags)
        fail_msg("%s, length %zu: flags %llX, not %llX", unaries[op].name, n,
                 (unsigned long long)flags, (unsigned long long)exact_flags);
    for (size_t i = 0; i < SLACK; i++)
        assert_int_equal(c[n + i], UINT64_C(0x5A5A5A5A5A5A5A5A));
}

static void check_compare(size_t op, const c205_word *a, const c205_word *b,
                          size_t n)
{
    uint64_t bits[BITS], expected[BITS];

    memset(bits, 0x5A, sizeof bits);
    memset(expected, 0x5A, sizeof expected);
    memset(expected, 0, (n + 63) / 64 * sizeof *expected);
    compares[op].span(bits, a, b, n);
    for (size_t i = 0; i < n; i++)
        expected[i / 64] |= (uint64_t)compares[op].exact(a[i], b[i])
                            << (63 - i % 64);
    if (memcmp(bits, expected, sizeof bits) != 0)
        fail_msg("%s, length %zu", compares[op].name, n);
}

/* Every length, with the supplies of the two operands taking turns. */
static void test_every_length(void **state)
{
    c205_word a[SPAN], b[SPAN];
    uint64_t seed = RANDOM_SEED;

    (void)state;
    for (size_t n = 0; n <= LENGTH_MAX; n++) {
        fill(a, n, supplies[n % SIZE(supplies)], &seed);
        fill(b, n, supplies[n / SIZE(supplies) % SIZE(supplies)], &seed);
        for (size_t op = 0; op < SIZE(binaries); op++)
            check_binary(op, a, b, n);
        for (size_t op = 0; op < SIZE(unaries); op++)
            check_unary(op, a, n);
        for (size_t op = 0; op < SIZE(compares); op++)
            check_compare(op, a, b, n);
    }
}

/* Alone in a span, so that no other word sends the block to the exact rule. */
static void test_every_pair_of_specials(void **state)
{
    (void)state;
    for (size_t i = 0; i < SIZE(specials); i++) {
        for (size_t op = 0; op < SIZE(unaries); op++)
            check_unary(op, &specials[i], 1);
        for (size_t j = 0; j < SIZE(specials); j++) {
            for (size_t op = 0; op < SIZE(binaries); op++)
                check_binary(op, &specials[i], &specials[j], 1);
            for (size_t op = 0; op < SIZE(compares); op++)
                check_compare(op, &specials[i], &specials[j], 1);
        }
    }
}

/* Long spans of operands of one kind each, so that the fast paths run. */
static void test_every_pair_of_supplies(void **state)
{
    static c205_word a[LONG_LENGTH], b[LONG_LENGTH];
    uint64_t seed = RANDOM_SEED + 1;

    (void)state;
    for (size_t s = 0; s < SIZE(supplies) * SIZE(supplies); s++) {
        fill(a, LONG_LENGTH, supplies[s / SIZE(supplies)], &seed);
        fill(b, LONG_LENGTH, supplies[s % SIZE(supplies)], &seed);
        for (size_t op = 0; op < SIZE(binaries); op++)
            check_binary(op, a, b, LONG_LENGTH);
        for (size_t op = 0; op < SIZE(compares); op++)
            check_compare(op, a, b, LENGTH_MAX);
    }
}

/* Close operands: cancellation, quotients near 1, sums near 0. */
static void test_close_operands(void **state)
{
    static c205_word a[LONG_LENGTH], b[LONG_LENGTH];
    uint64_t seed = RANDOM_SEED + 2, flags = 0;

    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        fill(a, LONG_LENGTH, round & 1 ? sparse : near, &seed);
        for (size_t i = 0; i < LONG_LENGTH; i++) {
            c205_word shift = xorshift(&seed) % 7;
            b[i] = a[i] + shift - 3 + (xorshift(&seed) % 3 << 48);
            b[i] = shift & 1 ? arith_negate(b[i], &flags) : b[i];
        }
        for (size_t op = 0; op < SIZE(binaries); op++)
            check_binary(op, a, b, LONG_LENGTH);
        for (size_t op = 0; op < SIZE(compares); op++)
            check_compare(op, a, b, LENGTH_MAX);
    }
}

static c205_word positive(uint64_t *seed)
{
    return (anywhere(seed) | UINT64_C(3) << 46) ^ UINT64_C(1) << 47;
}

/* Squares and their neighbours, where a root turns. */
static c205_word about_a_square(uint64_t *seed)
{
    const int64_t root = xorshift_between(seed, 1 << 23, 11863282);

    return word_make((int32_t)xorshift_between(seed, -200, 200),
                     root * root - (int64_t)(xorshift(seed) & 1));
}

static void test_unary_operands(void **state)
{
    static c205_word a[LONG_LENGTH];
    static supply *const more[] = {positive, about_a_square};
    uint64_t seed = RANDOM_SEED + 3;

    (void)state;
    for (size_t s = 0; s < SIZE(supplies) + SIZE(more) * ROUNDS; s++) {
        fill(a, LONG_LENGTH, s < SIZE(supplies) ? supplies[s]
                                                : more[s % SIZE(more)],
             &seed);
        for (size_t op = 0; op < SIZE(unaries); op++)
            check_unary(op, a, LONG_LENGTH);
    }
}

/* ---- The rest ----------------------------------------------------------- */

static void test_store_masked(void **state)
{
    uint64_t seed = RANDOM_SEED + 4;

    (void)state;
    for (size_t n = 0; n <= LENGTH_MAX; n++) {
        c205_word a[SPAN], c[SPAN], expected[SPAN];
        uint64_t bits[BITS];
        fill(a, SPAN, xorshift, &seed);
        fill(c, SPAN, xorshift, &seed);
        fill(bits, BITS, xorshift, &seed);
        for (size_t i = 0; i < SPAN; i++)
            expected[i] = i < n && bits[i / 64] >> (63 - i % 64) & 1 ? a[i]
                                                                     : c[i];
        lanes_store_masked(c, a, bits, n);
        assert_memory_equal(c, expected, sizeof c);
    }
}

static void check_reduction(void (*reduce)(c205_word *, const c205_word *,
                                           size_t, uint64_t *),
                            exact_binary *exact, supply *next, uint64_t seed)
{
    for (size_t n = 0; n <= LENGTH_MAX; n++) {
        c205_word a[SPAN];
        uint64_t flags = other_flags, exact_flags = other_flags;
        c205_word accumulator = next(&seed), expected = accumulator;
        fill(a, n, next, &seed);
        for (size_t i = 0; i < n; i++)
            expected = exact(expected, a[i], &exact_flags);
        reduce(&accumulator, a, n, &flags);
        assert_int_equal(accumulator, expected);
        assert_int_equal(flags, exact_flags);
    }
}

static void test_reductions(void **state)
{
    (void)state;
    for (size_t s = 0; s < SIZE(supplies); s++) {
        check_reduction(lanes_sum, arith_add_normalised, supplies[s],
                        RANDOM_SEED);
        check_reduction(lanes_product, arith_multiply_significant,
                        supplies[s], RANDOM_SEED);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_length),
        cmocka_unit_test(test_every_pair_of_specials),
        cmocka_unit_test(test_every_pair_of_supplies),
        cmocka_unit_test(test_close_operands),
        cmocka_unit_test(test_unary_operands),
        cmocka_unit_test(test_store_masked),
        cmocka_unit_test(test_reductions),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
