/* test_lanes.c - spans of words and half words are compared with the rule for one word:
 * every operation, at every length and alignment, for operands of every kind, and with
 * results that overlap an operand. A lane with other bits, a flag that is lost, or a
 * word that changes after the end fails here. */
#include "tests/oracle/arithmetic_oracle.h"
#include "tests/unit/lane_operands.h"
#include "tests/unit/unit.h"
#include "vm/number/lanes.h"

enum {
    LENGTH_MAX = 257,
    SLACK = 3,  /* number of words after a span, which must not change */
    PLACES = 8, /* number of words in the longest host vector */
    SPAN = LENGTH_MAX + SLACK + PLACES,
    BITS = (LENGTH_MAX + 63) / 64 + SLACK,
    LONG_LENGTH = 4096,
    ROUNDS = 30
};

/* ---- The operations ----------------------------------------------------- */

/* Operations that are not in arith.h, by the rule of the oracle. */
#define BITWISE_OF(size, name, format) \
    static c205_word size##_##name(c205_word a, c205_word b, uint64_t *flags) \
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

/* An operation on spans, and the rule for single words. */
typedef struct operation {
    const char *name;
    enum { OF_TWO, OF_ONE, COMPARISON, REDUCTION_OF } kind;
    union {
        lanes_binary *of_two;
        lanes_unary *of_one;
        lanes_compare *compare;
        lanes_reduction *reduce;
    } span;
    union {
        arith_binary *of_two;
        arith_unary *of_one;
        arith_relation *compare;
    } exact;
} operation;

/* clang-format off */
#define ROW(kind, of, by, span, exact) { #span, kind, { .of = span }, { .by = exact } }
#define WORDS(kind, of, by, name, exact) ROW(kind, of, by, lanes_##name, arith_##exact)
#define HALVES(kind, of, by, name, exact) ROW(kind, of, by, halves_##name, half_##exact)
/* clang-format on */

static const operation of_words[] = {
#define BINARY(name, ...) WORDS(OF_TWO, of_two, of_two, name, name),
#define BITWISE(name) WORDS(OF_TWO, of_two, of_two, name, name),
#define UNARY(name, ...) WORDS(OF_ONE, of_one, of_one, name, name),
#define COPY(name, ...) WORDS(OF_ONE, of_one, of_one, name, name),
#define CONVERSION_OF_WORDS(name) WORDS(OF_ONE, of_one, of_one, name, name),
#define CONVERSION_OF_HALVES(name)
/* A conversion is listed with the size of its operand. */
#define CONVERSION(name, of, specials) CONVERSION_OF_##of(name)
#define RELATION(name) WORDS(COMPARISON, compare, compare, name, name),
#define REDUCTION(name, step, specials) WORDS(REDUCTION_OF, reduce, of_two, name, step),
#include "vm/arith.def"
#undef CONVERSION_OF_WORDS
#undef CONVERSION_OF_HALVES
};
static const operation of_halves[] = {
#define BINARY(name, ...) HALVES(OF_TWO, of_two, of_two, name, name),
#define BITWISE(name) HALVES(OF_TWO, of_two, of_two, name, name),
#define UNARY(name, ...) HALVES(OF_ONE, of_one, of_one, name, name),
#define CONVERSION_OF_WORDS(name)
#define CONVERSION_OF_HALVES(name) WORDS(OF_ONE, of_one, of_one, name, name),
#define CONVERSION(name, of, specials) CONVERSION_OF_##of(name)
#define RELATION(name) HALVES(COMPARISON, compare, compare, name, name),
#define REDUCTION(name, step, specials) \
    HALVES(REDUCTION_OF, reduce, of_two, name, step),
#include "vm/arith.def"
};

/* The operations of one size. */
typedef struct operations {
    word_format format;
    const operation *list;
    size_t count;
} operations;

static const operations sizes[] = {
    { { 16, 47 }, of_words, COUNT(of_words) },
    { { 8, 23 }, of_halves, COUNT(of_halves) },
};

/* Apply an operation of one or two operands. */
static void apply(const operation *op, c205_word *c, const c205_word *a,
                  const c205_word *b, size_t n, uint64_t *flags)
{
    if (op->kind == OF_ONE)
        op->span.of_one(c, a, n, flags);
    else
        op->span.of_two(c, a, b, n, flags);
}

static c205_word apply_rule(const operation *op, c205_word a, c205_word b,
                            uint64_t *flags)
{
    return op->kind == OF_ONE ? op->exact.of_one(a, flags)
                              : op->exact.of_two(a, b, flags);
}

/* ---- Spans against words ------------------------------------------------ */

/* Flags that no operation sets. They must not change. */
static const uint64_t other_flags = 5;

static void check_words(const operation *op, const c205_word *a, const c205_word *b,
                        size_t n, size_t place)
{
    static c205_word room[LONG_LENGTH + SLACK + PLACES];
    c205_word *c = room + place;
    uint64_t flags = other_flags, exact_flags = other_flags;
    memset(c, 0x5A, (n + SLACK) * sizeof *c);
    apply(op, c, a, b, n, &flags);
    for (size_t i = 0; i < n; i++) {
        c205_word exact = apply_rule(op, a[i], b[i], &exact_flags);
        FAIL_IF(c[i] != exact,
                "%s(%016llX, %016llX) = %016llX, not %016llX; lane %zu of %zu",
                op->name, (unsigned long long)a[i], (unsigned long long)b[i],
                (unsigned long long)c[i], (unsigned long long)exact, i, n);
    }
    FAIL_IF(flags != exact_flags, "%s, length %zu: flags %llX, not %llX", op->name, n,
            (unsigned long long)flags, (unsigned long long)exact_flags);
    for (size_t i = 0; i < SLACK; i++)
        assert_int_equal(c[n + i], UINT64_C(0x5A5A5A5A5A5A5A5A));
}

static void check_comparison(const operation *op, const c205_word *a,
                             const c205_word *b, size_t n)
{
    uint64_t bits[BITS], expected[BITS];
    memset(bits, 0x5A, sizeof bits);
    memset(expected, 0x5A, sizeof expected);
    memset(expected, 0, (n + 63) / 64 * sizeof *expected);
    op->span.compare(bits, a, b, n);
    for (size_t i = 0; i < n; i++)
        expected[i / 64] |= (uint64_t)op->exact.compare(a[i], b[i]) << (63 - i % 64);
    FAIL_IF(memcmp(bits, expected, sizeof bits) != 0, "%s, length %zu", op->name, n);
}

/* Checks the operations of two operands on all pairs of a[i] and b[i]. */
static void check_pairs(const operations *size, const c205_word *a, const c205_word *b,
                        size_t n, size_t place)
{
    for (size_t i = 0; i < size->count; i++)
        if (size->list[i].kind == OF_TWO)
            check_words(&size->list[i], a, b, n, place);
        else if (size->list[i].kind == COMPARISON)
            check_comparison(&size->list[i], a, b, n < LENGTH_MAX ? n : LENGTH_MAX);
}

static void check_unaries(const operations *size, const c205_word *a, size_t n,
                          size_t place)
{
    for (size_t i = 0; i < size->count; i++)
        if (size->list[i].kind == OF_ONE)
            check_words(&size->list[i], a, a, n, place);
}

/* Checks every place and length with all pairs of lane_supplies in turn. */
static void check_lengths(const operations *size, uint64_t seed)
{
    static c205_word a[SPAN], b[SPAN];
    size_t turns = LANE_SUPPLIES;
    for (size_t place = 0; place < PLACES; place++) {
        c205_word *placed_a = a + place, *placed_b = b + 3 * place % PLACES;
        uint64_t random = seed + place;
        for (size_t n = 0; n <= LENGTH_MAX; n++) {
            lane_fill(placed_a, n, lane_supplies[n % turns], size->format, &random);
            lane_fill(placed_b, n, lane_supplies[n / turns % turns], size->format,
                      &random);
            check_pairs(size, placed_a, placed_b, n, 5 * place % PLACES);
            check_unaries(size, placed_a, n, 5 * place % PLACES);
        }
    }
}

/* ---- Upon an operand ----------------------------------------------------- */

enum { UPON_LENGTH = 600, BELOW = 9 };

/* The result begins `below` words before a copy of the operand. It must equal a
 * separate result, and the rest of the operand must not change. */
static void check_upon(const operation *op, const c205_word *const operands[2],
                       size_t which, size_t n, size_t below)
{
    static c205_word room[UPON_LENGTH + BELOW], expected[UPON_LENGTH];
    const c205_word *upon[2] = { operands[0], operands[1] };
    uint64_t flags = 0, flags_upon = 0;
    size_t left = below < n ? below : n;
    upon[which] = memcpy(room + below, operands[which], n * sizeof *room);
    apply(op, expected, operands[0], operands[1], n, &flags);
    apply(op, room, upon[0], upon[1], n, &flags_upon);
    FAIL_IF(memcmp(room, expected, n * sizeof *room) != 0 || flags != flags_upon
                || memcmp(room + below + n - left, operands[which] + n - left,
                          left * sizeof *room)
                       != 0,
            "%s upon an operand, %zu words below, length %zu", op->name, below, n);
}

static void check_all_upon(const operations *size, size_t n, size_t below,
                           uint64_t *seed)
{
    static c205_word a[UPON_LENGTH], b[UPON_LENGTH];
    const c205_word *const operands[2] = { a, b };
    lane_fill(a, n, lane_mostly_usual, size->format, seed);
    lane_fill(b, n, lane_or_machine_zero, size->format, seed);
    for (size_t i = 0; i < size->count; i++)
        for (size_t which = 0; which < 2; which++)
            if (size->list[i].kind == OF_TWO
                || (size->list[i].kind == OF_ONE && which == 0))
                check_upon(&size->list[i], operands, which, n, below);
}

TEST(upon_an_operand)
{
    static const size_t lengths[] = { 1, 7, 8, 9, 64, 255, 256, 261, 600 };
    uint64_t seed = RANDOM_SEED;
    for (size_t i = 0; i < COUNT(sizes); i++)
        for (size_t k = 0; k < COUNT(lengths); k++)
            for (size_t below = 0; below <= BELOW; below++)
                check_all_upon(&sizes[i], lengths[k], below, &seed);
}

/* ---- Operands of all kinds ---------------------------------------------- */

/* Each span has only one word, so that no other word selects the exact rule. */
static void check_specials(const operations *size, uint64_t seed UNUSED)
{
    for (size_t i = 0; i < LANE_SPECIALS; i++) {
        c205_word a = lane_special_at(size->format, i);
        check_unaries(size, &a, 1, 0);
        for (size_t j = 0; j < LANE_SPECIALS; j++) {
            c205_word b = lane_special_at(size->format, j);
            check_pairs(size, &a, &b, 1, 0);
        }
    }
}

/* Long spans of operands of one kind, so that the fast paths run. */
static void check_supplies(const operations *size, uint64_t seed)
{
    static c205_word a[LONG_LENGTH], b[LONG_LENGTH];
    size_t turns = LANE_SUPPLIES;
    for (size_t s = 0; s < turns * turns; s++) {
        lane_fill(a, LONG_LENGTH, lane_supplies[s / turns], size->format, &seed);
        lane_fill(b, LONG_LENGTH, lane_supplies[s % turns], size->format, &seed);
        check_pairs(size, a, b, LONG_LENGTH, 0);
    }
}

/* Similar operands cause cancellation, quotients near 1 and sums near 0. */
static void check_close_operands(const operations *size, uint64_t seed)
{
    static c205_word a[LONG_LENGTH], b[LONG_LENGTH];
    for (int round = 0; round < ROUNDS; round++) {
        lane_fill(a, LONG_LENGTH, round & 1 ? lane_sparse : lane_near, size->format,
                  &seed);
        for (size_t i = 0; i < LONG_LENGTH; i++) {
            uint64_t shift = xorshift(&seed) % 7;
            int32_t e = format_exponent(size->format, a[i])
                        + (int32_t)(xorshift(&seed) % 3);
            int64_t c = format_coefficient(size->format, a[i]) + (int64_t)shift - 3;
            b[i] = format_make(size->format, e, shift & 1 ? -c : c);
        }
        check_pairs(size, a, b, LONG_LENGTH, 0);
    }
}

/* Shift counts, exponents and significances are small integers. */
static void check_by_integers(const operations *size, uint64_t seed)
{
    static c205_word a[LONG_LENGTH], b[LONG_LENGTH];
    for (size_t s = 0; s < LANE_SUPPLIES; s++) {
        lane_fill(a, LONG_LENGTH, lane_supplies[s], size->format, &seed);
        for (size_t i = 0; i < LONG_LENGTH; i++)
            b[i] = format_make(size->format, (int32_t)(xorshift(&seed) & 3),
                               xorshift_between(&seed, -140, 140));
        check_pairs(size, a, b, LONG_LENGTH, 0);
    }
}

static void check_unary_operands(const operations *size, uint64_t seed)
{
    static c205_word a[LONG_LENGTH];
    for (size_t s = 0; s < LANE_SUPPLIES + ROUNDS; s++) {
        lane_fill(a, LONG_LENGTH,
                  s < LANE_SUPPLIES ? lane_supplies[s] : lane_about_a_square,
                  size->format, &seed);
        check_unaries(size, a, LONG_LENGTH, 0);
    }
}

TEST(operands)
{
    static void (*const checks[])(const operations *, uint64_t) = {
        check_lengths,        check_specials,    check_supplies,
        check_close_operands, check_by_integers, check_unary_operands
    };
    for (size_t i = 0; i < COUNT(sizes); i++)
        for (size_t k = 0; k < COUNT(checks); k++)
            checks[k](&sizes[i], RANDOM_SEED + k);
}

/* Roots are computed from inexact doubles. Therefore every coefficient is tested, with
 * even and odd exponents. */
TEST(every_root_of_a_half_word)
{
    static c205_word a[LONG_LENGTH];
    operation square_root = HALVES(OF_ONE, of_one, of_one, square_root, square_root);
    for (int64_t c = INT64_C(1) << 22; c < INT64_C(1) << 23; c += LONG_LENGTH / 2) {
        for (int i = 0; i < LONG_LENGTH; i++)
            a[i] = format_make(half_words, i & 1, c + i / 2);
        check_words(&square_root, a, a, LONG_LENGTH, 0);
    }
}

/* ---- Other cases -------------------------------------------------------- */

TEST(store_masked)
{
    uint64_t seed = RANDOM_SEED + 4;
    for (size_t n = 0; n <= LENGTH_MAX; n++) {
        c205_word a[SPAN], c[SPAN], expected[SPAN];
        uint64_t bits[BITS];
        lane_fill(a, SPAN, lane_any_bits, whole_words, &seed);
        lane_fill(c, SPAN, lane_any_bits, whole_words, &seed);
        lane_fill(bits, BITS, lane_any_bits, whole_words, &seed);
        for (size_t i = 0; i < SPAN; i++)
            expected[i] = i < n && bits[i / 64] >> (63 - i % 64) & 1 ? a[i] : c[i];
        lanes_store_masked(c, a, bits, n);
        assert_memory_equal(c, expected, sizeof c);
    }
}

static void check_reduction(const operation *op, supply *next, word_format f,
                            uint64_t seed)
{
    for (size_t n = 0; n <= LENGTH_MAX; n++) {
        c205_word a[SPAN];
        uint64_t flags = other_flags, exact_flags = other_flags;
        c205_word accumulator = next(f, &seed), expected = accumulator;
        lane_fill(a, n, next, f, &seed);
        for (size_t i = 0; i < n; i++)
            expected = op->exact.of_two(expected, a[i], &exact_flags);
        op->span.reduce(&accumulator, a, n, &flags);
        FAIL_IF(accumulator != expected || flags != exact_flags, "%s, length %zu",
                op->name, n);
    }
}

TEST(reductions)
{
    for (size_t i = 0; i < COUNT(sizes); i++)
        for (size_t s = 0; s < LANE_SUPPLIES; s++)
            for (size_t r = 0; r < sizes[i].count; r++)
                if (sizes[i].list[r].kind == REDUCTION_OF)
                    check_reduction(&sizes[i].list[r], lane_supplies[s],
                                    sizes[i].format, RANDOM_SEED);
}
