/* test_lanes.c - spans against the rule for one word: the same bits, the same
 * flags, for every length and place, for words and half words. */
#include "tests/oracle/arithmetic_oracle.h"
#include "tests/random.h"
#include "vm/number/lanes.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum {
    LENGTH_MAX = 257,
    SLACK = 3,  /* words behind a span, which must stay as they are */
    PLACES = 8, /* words of the longest vectors of hosts */
    SPAN = LENGTH_MAX + SLACK + PLACES,
    BITS = (LENGTH_MAX + 63) / 64 + SLACK,
    LONG_LENGTH = 4096,
    ROUNDS = 30
};

#define SIZE(table) (sizeof(table) / sizeof *(table))

/* ---- Operands ----------------------------------------------------------- */

/* Both sides of the edges: of the special exponents, of exponents and
 * coefficients, of integers; and one. */
enum {
    EXPONENTS = 10,
    COEFFICIENTS = 8,
    SPECIALS = EXPONENTS * COEFFICIENTS
};

static c205_word special_at(word_format f, size_t i)
{
    int32_t top = format_exponent_max(f);
    int32_t bottom = format_exponent_min(f);
    int32_t end = 1 << (f.exponent_bits - 1);
    int64_t half = INT64_C(1) << (f.digits - 1);
    const int32_t exponents[EXPONENTS] = { -end,     bottom - 1, top + 1,
                                           end - 1,  bottom,     top,
                                           0,        -1,         1 - f.digits,
                                           -f.digits };
    const int64_t coefficients[COEFFICIENTS] = {
        0, 1, -1, half, -half, 2 * half - 1, -2 * half, -half - 1
    };

    return format_make(f, exponents[i / COEFFICIENTS],
                       coefficients[i % COEFFICIENTS]);
}

static c205_word special(word_format f, uint64_t *seed)
{
    return special_at(f, xorshift(seed) % SPECIALS);
}

static c205_word near(word_format f, uint64_t *seed)
{
    return xorshift_normalised_of(f, seed, -f.digits - 2, -f.digits + 2);
}

static c205_word around(word_format f, uint64_t *seed)
{
    return xorshift_normalised_of(f, seed, -2 * f.digits - 6, 10);
}

static c205_word near_top(word_format f, uint64_t *seed)
{
    int32_t top = format_exponent_max(f);

    return xorshift_normalised_of(f, seed, top - 3, top);
}

static c205_word near_bottom(word_format f, uint64_t *seed)
{
    int32_t bottom = format_exponent_min(f);

    return xorshift_normalised_of(f, seed, bottom, bottom + f.digits + 3);
}

static c205_word anywhere(word_format f, uint64_t *seed)
{
    return xorshift_normalised_of(f, seed, format_exponent_min(f),
                                  format_exponent_max(f));
}

static c205_word or_machine_zero(word_format f, uint64_t *seed)
{
    return xorshift(seed) % 4 == 0 ? C205_MACHINE_ZERO : around(f, seed);
}

static c205_word unnormalised(word_format f, uint64_t *seed)
{
    return xorshift_unnormalised_of(f, seed, -2 * f.digits - 6, 10);
}

static c205_word any_bits(word_format f, uint64_t *seed)
{
    return xorshift(seed) & format_mask(f);
}

/* Coefficients of few ones or zeros: where carries go far. */
static c205_word sparse(word_format f, uint64_t *seed)
{
    c205_word word = around(f, seed);
    int64_t c = format_coefficient(f, word);
    int64_t kept = -(INT64_C(1) << xorshift_between(seed, 0, f.digits - 1));

    return format_make(f, format_exponent(f, word),
                       c < 0 ? c | ~kept : c & kept);
}

static c205_word mostly_usual(word_format f, uint64_t *seed)
{
    return xorshift(seed) % 64 == 0 ? special(f, seed) : near(f, seed);
}

/* A machine zero, whatever its digits. */
static c205_word zero(word_format f, uint64_t *seed)
{
    c205_word digits = xorshift(seed) & UINT64_C(0x0FFFFFFFFFFFFFFF);

    return (C205_MACHINE_ZERO | digits) & format_mask(f);
}

static c205_word mostly_zero(word_format f, uint64_t *seed)
{
    return xorshift(seed) % 128 == 0 ? special(f, seed) : zero(f, seed);
}

/* From the ends of exponents with so many bits less than there are. */
static c205_word at_the_ends(word_format f, uint64_t *seed, int less)
{
    int32_t end = 1 << (f.exponent_bits - 1 - less);
    int32_t e = xorshift(seed) % 2 ? end - 1 : -end;

    return xorshift_normalised_of(f, seed, e, e);
}

/* Of what is usual (vm/number/usual.h), with others rarely; just not usual. */
static c205_word about_usual(word_format f, uint64_t *seed)
{
    return at_the_ends(f, seed, xorshift(seed) % 128 == 0 ? 1 : 2);
}

static c205_word beyond_usual(word_format f, uint64_t *seed)
{
    return at_the_ends(f, seed, 1);
}

typedef c205_word supply(word_format f, uint64_t *seed);

/* With exponents of so many bits less than there are; the ends of coefficients,
 * and machine zeros, among them. */
static c205_word within(word_format f, uint64_t *seed, int less)
{
    int32_t end = 1 << (f.exponent_bits - 1) >> less;
    int64_t half = INT64_C(1) << (f.digits - 1);
    const int64_t ends[] = { half, 2 * half - 1, -half - 1, -2 * half };
    size_t kind = xorshift(seed) % 16;
    int32_t e = (int32_t)xorshift_between(seed, -end, end > 0 ? end - 1 : 0);

    if (kind < SIZE(ends))
        return format_make(f, e, ends[kind]);
    return kind == SIZE(ends) ? C205_MACHINE_ZERO
                              : xorshift_normalised_of(f, seed, e, e);
}

/* What doubles hold (vm/number/floored.h); likewise, of much the same exponents;
 * with others rarely; and just not. */
static c205_word moderate(word_format f, uint64_t *seed)
{
    return within(f, seed, 7);
}

static c205_word moderate_near(word_format f, uint64_t *seed)
{
    return within(f, seed, 13);
}

static c205_word mostly_moderate(word_format f, uint64_t *seed)
{
    supply *const others[] = { special, zero, unnormalised, anywhere };
    uint64_t which = xorshift(seed) % 1024;

    return which < SIZE(others) ? others[which](f, seed) : moderate(f, seed);
}

static c205_word beyond_moderate(word_format f, uint64_t *seed)
{
    return within(f, seed, 6);
}

/* As indices are, of few digits or many, machine zeros among them; with others
 * rarely. */
static c205_word whole(word_format f, uint64_t *seed)
{
    int64_t end = INT64_C(1) << xorshift_between(seed, 0, f.digits);

    if (xorshift(seed) % 8 == 0)
        return zero(f, seed);
    return format_make(f, 0, xorshift_between(seed, -end, end - 1));
}

static c205_word mostly_whole(word_format f, uint64_t *seed)
{
    supply *const others[] = { special, unnormalised, anywhere };
    uint64_t which = xorshift(seed) % 256;

    return which < SIZE(others) ? others[which](f, seed) : whole(f, seed);
}

static c205_word absolute(word_format f, c205_word word)
{
    uint64_t flags = 0;

    return f.digits == WORD_DIGITS ? arith_absolute(word, &flags)
                                   : half_absolute(word, &flags);
}

static c205_word positive(word_format f, uint64_t *seed)
{
    return absolute(f, anywhere(f, seed));
}

static c205_word moderate_positive(word_format f, uint64_t *seed)
{
    return absolute(f, moderate(f, seed));
}

/* Squares and their neighbours, where a root turns. */
static c205_word about_a_square(word_format f, uint64_t *seed)
{
    int64_t least = INT64_C(1) << (f.digits / 2);
    int64_t root = xorshift_between(seed, least, least * 707 / 500);

    return format_make(f, (int32_t)xorshift_between(seed, -90, 90),
                       root * root - (int64_t)(xorshift(seed) & 1));
}

static supply *const supplies[] = {
    special,
    near,
    around,
    near_top,
    near_bottom,
    anywhere,
    any_bits,
    unnormalised,
    sparse,
    mostly_usual,
    or_machine_zero,
    positive,
    zero,
    mostly_zero,
    about_usual,
    beyond_usual,
    moderate,
    moderate_near,
    mostly_moderate,
    beyond_moderate,
    moderate_positive,
    whole,
    mostly_whole,
};

static void fill(c205_word *words, size_t n, supply *next, word_format f,
                 uint64_t *seed)
{
    for (size_t i = 0; i < n; i++)
        words[i] = next(f, seed);
}

/* ---- The operations ----------------------------------------------------- */

/* What arith.h has no functions for, by the rule of the oracle. */
#define BITWISE_OF(size, name, format) \
    static c205_word size##_##name(c205_word a, c205_word b, \
                                   uint64_t *flags) \
    { \
        return oracle_##name(&format, a, b, flags); \
    }
#define BITWISE(name) \
    BITWISE_OF(arith, name, oracle_full) BITWISE_OF(half, name, oracle_half)
#define COPY(name, ...) \
    static c205_word arith_##name(c205_word a, uint64_t *flags) \
    { \
        return oracle_##name(&oracle_full, a, 0, flags); \
    }
#include "vm/arith.def"

typedef struct binary {
    const char *name;
    lanes_binary *span;
    arith_binary *exact;
} binary;

typedef struct unary {
    const char *name;
    lanes_unary *span;
    arith_unary *exact;
} unary;

typedef struct comparison {
    const char *name;
    lanes_compare *span;
    arith_relation *exact;
} comparison;

typedef struct reduction {
    const char *name;
    lanes_reduction *span;
    arith_binary *step;
} reduction;

/* clang-format off */
#define WORDS(name, exact) { "lanes_" #name, lanes_##name, arith_##exact }
#define HALVES(name, exact) { "halves_" #name, halves_##name, half_##exact }
/* clang-format on */

static const binary binaries_of_words[] = {
#define BINARY(name, ...) WORDS(name, name),
#define BITWISE(name) WORDS(name, name),
#include "vm/arith.def"
};
static const binary binaries_of_halves[] = {
#define BINARY(name, ...) HALVES(name, name),
#define BITWISE(name) HALVES(name, name),
#include "vm/arith.def"
};

/* The conversions stand with the size that they take. */
static const unary unaries_of_words[] = {
#define UNARY(name, ...) WORDS(name, name),
#define COPY(name, ...) WORDS(name, name),
#define CONVERSION_OF_WORDS(name) WORDS(name, name),
#define CONVERSION_OF_HALVES(name)
#define CONVERSION(name, of, specials) CONVERSION_OF_##of(name)
#include "vm/arith.def"
#undef CONVERSION_OF_WORDS
#undef CONVERSION_OF_HALVES
};
static const unary unaries_of_halves[] = {
#define UNARY(name, ...) HALVES(name, name),
#define CONVERSION_OF_WORDS(name)
#define CONVERSION_OF_HALVES(name) WORDS(name, name),
#define CONVERSION(name, of, specials) CONVERSION_OF_##of(name)
#include "vm/arith.def"
};

static const comparison comparisons_of_words[] = {
#define RELATION(name) WORDS(name, name),
#include "vm/arith.def"
};
static const comparison comparisons_of_halves[] = {
#define RELATION(name) HALVES(name, name),
#include "vm/arith.def"
};

static const reduction reductions_of_words[] = {
#define REDUCTION(name, step, specials) WORDS(name, step),
#include "vm/arith.def"
};
static const reduction reductions_of_halves[] = {
#define REDUCTION(name, step, specials) HALVES(name, step),
#include "vm/arith.def"
};

enum {
    BINARIES = SIZE(binaries_of_words),
    COMPARISONS = SIZE(comparisons_of_words),
    REDUCTIONS = SIZE(reductions_of_words)
};

/* The operations of one size. */
typedef struct operations {
    word_format format;
    const binary *binaries;
    const comparison *comparisons;
    const reduction *reductions;
    const unary *unaries;
    size_t unary_count;
} operations;

static const operations sizes[] = {
    { { 16, 47 },
      binaries_of_words,
      comparisons_of_words,
      reductions_of_words,
      unaries_of_words,
      SIZE(unaries_of_words) },
    { { 8, 23 },
      binaries_of_halves,
      comparisons_of_halves,
      reductions_of_halves,
      unaries_of_halves,
      SIZE(unaries_of_halves) },
};

/* ---- Spans against words ------------------------------------------------ */

/* Flags that no operation sets stay. */
static const uint64_t other_flags = 5;

static void check_binary(const binary *op, const c205_word *a,
                         const c205_word *b, size_t n, size_t place)
{
    static c205_word room[LONG_LENGTH + SLACK + PLACES];
    c205_word *c = room + place;
    uint64_t flags = other_flags, exact_flags = other_flags;

    memset(c, 0x5A, (n + SLACK) * sizeof *c);
    op->span(c, a, b, n, &flags);
    for (size_t i = 0; i < n; i++) {
        c205_word exact = op->exact(a[i], b[i], &exact_flags);
        if (c[i] != exact)
            fail_msg("%s(%016llX, %016llX) = %016llX, not %016llX; "
                     "lane %zu of %zu",
                     op->name, (unsigned long long)a[i],
                     (unsigned long long)b[i], (unsigned long long)c[i],
                     (unsigned long long)exact, i, n);
    }
    if (flags != exact_flags)
        fail_msg("%s, length %zu: flags %llX, not %llX", op->name, n,
                 (unsigned long long)flags, (unsigned long long)exact_flags);
    for (size_t i = 0; i < SLACK; i++)
        assert_int_equal(c[n + i], UINT64_C(0x5A5A5A5A5A5A5A5A));
}

static void check_unary(const unary *op, const c205_word *a, size_t n,
                        size_t place)
{
    static c205_word room[LONG_LENGTH + SLACK + PLACES];
    c205_word *c = room + place;
    uint64_t flags = other_flags, exact_flags = other_flags;

    memset(c, 0x5A, (n + SLACK) * sizeof *c);
    op->span(c, a, n, &flags);
    for (size_t i = 0; i < n; i++) {
        c205_word exact = op->exact(a[i], &exact_flags);
        if (c[i] != exact)
            fail_msg("%s(%016llX) = %016llX, not %016llX; lane %zu of %zu",
                     op->name, (unsigned long long)a[i],
                     (unsigned long long)c[i], (unsigned long long)exact, i,
                     n);
    }
    if (flags != exact_flags)
        fail_msg("%s, length %zu: flags %llX, not %llX", op->name, n,
                 (unsigned long long)flags, (unsigned long long)exact_flags);
    for (size_t i = 0; i < SLACK; i++)
        assert_int_equal(c[n + i], UINT64_C(0x5A5A5A5A5A5A5A5A));
}

static void check_comparison(const comparison *op, const c205_word *a,
                             const c205_word *b, size_t n)
{
    uint64_t bits[BITS], expected[BITS];

    memset(bits, 0x5A, sizeof bits);
    memset(expected, 0x5A, sizeof expected);
    memset(expected, 0, (n + 63) / 64 * sizeof *expected);
    op->span(bits, a, b, n);
    for (size_t i = 0; i < n; i++)
        expected[i / 64] |= (uint64_t)op->exact(a[i], b[i]) << (63 - i % 64);
    if (memcmp(bits, expected, sizeof bits) != 0)
        fail_msg("%s, length %zu", op->name, n);
}

static void check_pairs(const operations *size, const c205_word *a,
                        const c205_word *b, size_t n, size_t place)
{
    size_t compared = n < LENGTH_MAX ? n : LENGTH_MAX;

    for (size_t i = 0; i < BINARIES; i++)
        check_binary(&size->binaries[i], a, b, n, place);
    for (size_t i = 0; i < COMPARISONS; i++)
        check_comparison(&size->comparisons[i], a, b, compared);
}

static void check_unaries(const operations *size, const c205_word *a,
                          size_t n, size_t place)
{
    for (size_t i = 0; i < size->unary_count; i++)
        check_unary(&size->unaries[i], a, n, place);
}

/* Every length, with the supplies of the two operands taking turns. */
static void check_lengths(const operations *size, size_t place, uint64_t seed)
{
    static c205_word a[SPAN], b[SPAN];
    size_t turns = SIZE(supplies);

    for (size_t n = 0; n <= LENGTH_MAX; n++) {
        c205_word *placed_a = a + place;
        c205_word *placed_b = b + 3 * place % PLACES;
        fill(placed_a, n, supplies[n % turns], size->format, &seed);
        fill(placed_b, n, supplies[n / turns % turns], size->format, &seed);
        check_pairs(size, placed_a, placed_b, n, 5 * place % PLACES);
        check_unaries(size, placed_a, n, 5 * place % PLACES);
    }
}

/* ---- Upon an operand ----------------------------------------------------- */

enum { UPON_LENGTH = 600, BELOW = 9 };

struct upon {
    const c205_word *a, *b;
    size_t n, below;
};

/* The result begins so many words below a copy of the operand: it is the same
 * as one apart, and what is left of the operand stays. */
static void check_made_upon(const char *name, const struct upon *upon,
                            const c205_word *operand,
                            const c205_word *expected, const c205_word *room,
                            bool same_flags)
{
    size_t n = upon->n, below = upon->below;
    size_t left = below < n ? below : n;

    if (memcmp(room, expected, n * sizeof *room) != 0 || !same_flags
        || memcmp(room + below + n - left, operand + n - left,
                  left * sizeof *room)
               != 0)
        fail_msg("%s upon an operand, %zu words below, length %zu", name,
                 below, n);
}

static void check_binary_upon(const binary *op, const struct upon *upon)
{
    static c205_word room[UPON_LENGTH + BELOW], expected[UPON_LENGTH];
    c205_word *placed = room + upon->below;

    for (int which = 0; which < 2; which++) {
        const c205_word *operand = which ? upon->b : upon->a;
        uint64_t flags = 0, flags_upon = 0;
        memcpy(placed, operand, upon->n * sizeof *room);
        op->span(expected, upon->a, upon->b, upon->n, &flags);
        op->span(room, which ? upon->a : placed, which ? placed : upon->b,
                 upon->n, &flags_upon);
        check_made_upon(op->name, upon, operand, expected, room,
                        flags == flags_upon);
    }
}

static void check_unary_upon(const unary *op, const struct upon *upon)
{
    static c205_word room[UPON_LENGTH + BELOW], expected[UPON_LENGTH];
    c205_word *placed = room + upon->below;
    uint64_t flags = 0, flags_upon = 0;

    memcpy(placed, upon->a, upon->n * sizeof *room);
    op->span(expected, upon->a, upon->n, &flags);
    op->span(room, placed, upon->n, &flags_upon);
    check_made_upon(op->name, upon, upon->a, expected, room,
                    flags == flags_upon);
}

static void check_upon(const operations *size, size_t n, size_t below,
                       uint64_t *seed)
{
    static c205_word a[UPON_LENGTH], b[UPON_LENGTH];
    struct upon upon = { a, b, n, below };

    fill(a, n, mostly_usual, size->format, seed);
    fill(b, n, or_machine_zero, size->format, seed);
    for (size_t i = 0; i < BINARIES; i++)
        check_binary_upon(&size->binaries[i], &upon);
    for (size_t i = 0; i < size->unary_count; i++)
        check_unary_upon(&size->unaries[i], &upon);
}

static void test_upon_an_operand(void **state)
{
    static const size_t lengths[] = { 1, 7, 8, 9, 64, 255, 256, 261, 600 };
    uint64_t seed = RANDOM_SEED;
    (void)state;

    for (size_t i = 0; i < SIZE(sizes); i++)
        for (size_t k = 0; k < SIZE(lengths); k++)
            for (size_t below = 0; below <= BELOW; below++)
                check_upon(&sizes[i], lengths[k], below, &seed);
}

/* ---- All lengths --------------------------------------------------------- */

static void test_every_length_and_place(void **state)
{
    (void)state;
    for (size_t i = 0; i < SIZE(sizes); i++)
        for (size_t place = 0; place < PLACES; place++)
            check_lengths(&sizes[i], place, RANDOM_SEED + place);
}

/* Alone in a span, so that no other word sends the block to the exact rule. */
static void check_specials(const operations *size)
{
    for (size_t i = 0; i < SPECIALS; i++) {
        c205_word a = special_at(size->format, i);
        check_unaries(size, &a, 1, 0);
        for (size_t j = 0; j < SPECIALS; j++) {
            c205_word b = special_at(size->format, j);
            check_pairs(size, &a, &b, 1, 0);
        }
    }
}

static void test_every_pair_of_specials(void **state)
{
    (void)state;
    for (size_t i = 0; i < SIZE(sizes); i++)
        check_specials(&sizes[i]);
}

/* Long spans of operands of one kind each, so that the fast paths run. */
static void check_supplies(const operations *size, uint64_t seed)
{
    static c205_word a[LONG_LENGTH], b[LONG_LENGTH];
    size_t turns = SIZE(supplies);

    for (size_t s = 0; s < turns * turns; s++) {
        fill(a, LONG_LENGTH, supplies[s / turns], size->format, &seed);
        fill(b, LONG_LENGTH, supplies[s % turns], size->format, &seed);
        check_pairs(size, a, b, LONG_LENGTH, 0);
    }
}

static void test_every_pair_of_supplies(void **state)
{
    (void)state;
    for (size_t i = 0; i < SIZE(sizes); i++)
        check_supplies(&sizes[i], RANDOM_SEED + 1);
}

/* Close operands: cancellation, quotients near 1, sums near 0. */
static c205_word close_to(word_format f, c205_word a, uint64_t *seed)
{
    uint64_t shift = xorshift(seed) % 7;
    int32_t e = format_exponent(f, a) + (int32_t)(xorshift(seed) % 3);
    int64_t c = format_coefficient(f, a) + (int64_t)shift - 3;

    return format_make(f, e, shift & 1 ? -c : c);
}

static void check_close_operands(const operations *size, uint64_t seed)
{
    static c205_word a[LONG_LENGTH], b[LONG_LENGTH];

    for (int round = 0; round < ROUNDS; round++) {
        fill(a, LONG_LENGTH, round & 1 ? sparse : near, size->format, &seed);
        for (size_t i = 0; i < LONG_LENGTH; i++)
            b[i] = close_to(size->format, a[i], &seed);
        check_pairs(size, a, b, LONG_LENGTH, 0);
    }
}

static void test_close_operands(void **state)
{
    (void)state;
    for (size_t i = 0; i < SIZE(sizes); i++)
        check_close_operands(&sizes[i], RANDOM_SEED + 2);
}

/* Counts, exponents and significances are small integers. */
static void check_by_integers(const operations *size, uint64_t seed)
{
    static c205_word a[LONG_LENGTH], b[LONG_LENGTH];

    for (size_t s = 0; s < SIZE(supplies); s++) {
        fill(a, LONG_LENGTH, supplies[s], size->format, &seed);
        for (size_t i = 0; i < LONG_LENGTH; i++)
            b[i] = format_make(size->format, (int32_t)(xorshift(&seed) & 3),
                               xorshift_between(&seed, -140, 140));
        check_pairs(size, a, b, LONG_LENGTH, 0);
    }
}

static void test_by_integers(void **state)
{
    (void)state;
    for (size_t i = 0; i < SIZE(sizes); i++)
        check_by_integers(&sizes[i], RANDOM_SEED + 5);
}

static void check_unary_operands(const operations *size, uint64_t seed)
{
    static c205_word a[LONG_LENGTH];

    for (size_t s = 0; s < SIZE(supplies) + ROUNDS; s++) {
        fill(a, LONG_LENGTH,
             s < SIZE(supplies) ? supplies[s] : about_a_square, size->format,
             &seed);
        check_unaries(size, a, LONG_LENGTH, 0);
    }
}

static void test_unary_operands(void **state)
{
    (void)state;
    for (size_t i = 0; i < SIZE(sizes); i++)
        check_unary_operands(&sizes[i], RANDOM_SEED + 3);
}

/* The roots come from doubles, which err: every coefficient is tried, with
 * both parities of the exponent. */
static void test_every_root_of_a_half_word(void **state)
{
    static c205_word a[LONG_LENGTH];
    unary square_root = HALVES(square_root, square_root);

    (void)state;
    for (int64_t c = INT64_C(1) << 22; c < INT64_C(1) << 23;
         c += LONG_LENGTH / 2) {
        for (int i = 0; i < LONG_LENGTH; i++)
            a[i] = format_make(half_words, i & 1, c + i / 2);
        check_unary(&square_root, a, LONG_LENGTH, 0);
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
        fill(a, SPAN, any_bits, whole_words, &seed);
        fill(c, SPAN, any_bits, whole_words, &seed);
        fill(bits, BITS, any_bits, whole_words, &seed);
        for (size_t i = 0; i < SPAN; i++)
            expected[i] = i < n && bits[i / 64] >> (63 - i % 64) & 1 ? a[i]
                                                                     : c[i];
        lanes_store_masked(c, a, bits, n);
        assert_memory_equal(c, expected, sizeof c);
    }
}

static void check_reduction(const reduction *op, supply *next, word_format f,
                            uint64_t seed)
{
    for (size_t n = 0; n <= LENGTH_MAX; n++) {
        c205_word a[SPAN];
        uint64_t flags = other_flags, exact_flags = other_flags;
        c205_word accumulator = next(f, &seed), expected = accumulator;
        fill(a, n, next, f, &seed);
        for (size_t i = 0; i < n; i++)
            expected = op->step(expected, a[i], &exact_flags);
        op->span(&accumulator, a, n, &flags);
        if (accumulator != expected || flags != exact_flags)
            fail_msg("%s, length %zu", op->name, n);
    }
}

static void test_reductions(void **state)
{
    (void)state;
    for (size_t i = 0; i < SIZE(sizes); i++)
        for (size_t s = 0; s < SIZE(supplies); s++)
            for (size_t r = 0; r < REDUCTIONS; r++)
                check_reduction(&sizes[i].reductions[r], supplies[s],
                                sizes[i].format, RANDOM_SEED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_length_and_place),
        cmocka_unit_test(test_upon_an_operand),
        cmocka_unit_test(test_every_pair_of_specials),
        cmocka_unit_test(test_every_pair_of_supplies),
        cmocka_unit_test(test_close_operands),
        cmocka_unit_test(test_by_integers),
        cmocka_unit_test(test_unary_operands),
        cmocka_unit_test(test_every_root_of_a_half_word),
        cmocka_unit_test(test_store_masked),
        cmocka_unit_test(test_reductions),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
