/* test_arith.c - the edge cases of each rule of docs/arithmetic.md. Operations on words
 * and half words, and conversions between the two sizes, are compared with results
 * computed by hand. A different rounding, normalisation or flag fails here. */
#include "tests/random.h"
#include "tests/unit/rule_cases.h"

enum { ROUNDS = 20000, HALF_TOP = 111, HALF_BOTTOM = -112 };

static const struct size {
    word_format format;
    int32_t top, bottom; /* largest and smallest exponents of numbers */
    c205_word one;
} sizes[] = {
    { { 16, 47 }, WORD_EXPONENT_MAX, WORD_EXPONENT_MIN, C205_ONE },
    { { 8, 23 }, HALF_TOP, HALF_BOTTOM, C205_HALF_ONE },
};

/* The word size under test. Results are written in terms of B, its number of digits. */
static const struct size *size;
#define B size->format.digits
#define TOP size->top
#define BOTTOM size->bottom
#define ONE size->one
#define HALF (INT64_C(1) << (B - 1))
#define MAX (2 * HALF - 1)
#define MIN (-2 * HALF)
#define N(exponent, coefficient) format_make(size->format, exponent, coefficient)
/* A negative coefficient, for words whose exponents make them special. */
#define ANY N(0, MIN + 0x123456)

#define SIZED(op) (size == sizes ? arith_##op : half_##op)
#define BINARY(op, a, b, expected, flags) BINARY_GIVES(SIZED(op), a, b, expected, flags)
#define UNARY(op, a, expected, flags) UNARY_GIVES(SIZED(op), a, expected, flags)

static void format(void)
{
    assert_int_equal(format_exponent_max(size->format), TOP);
    assert_int_equal(format_exponent_min(size->format), BOTTOM);
    assert_int_equal(N(1 - B, HALF), ONE);
    assert_true(word_is_machine_zero(N(BOTTOM - 1, 5)));
    assert_true(word_is_indefinite(N(TOP + 1, 5)));
    assert_true(format_is_normalised(size->format, N(TOP, MIN)));
    assert_false(format_is_normalised(size->format, N(TOP, -HALF)));
}

/* ---- Add, subtract ------------------------------------------------------ */

static void sums(void)
{
    BINARY(add_upper, N(3, 5), MZ | ANY, N(3, 5), 0);
    BINARY(add_upper, MZ | ANY, N(BOTTOM, 5), N(BOTTOM, 5), 0);
    BINARY(add_lower, N(3, 5), MZ | ANY, N(3 - B, 0), 0);
    BINARY(add_lower, N(BOTTOM, 5), MZ, MZ, ZERO_FLAG);
    BINARY(add_normalised, MZ, N(3, 1), N(4 - B, HALF), 0);
    BINARY(add_normalised, MZ, N(3, 0), MZ, ZERO_FLAG);
    BINARY(subtract_upper, MZ, N(3, 5), N(3, -5), 0);
    BINARY(subtract_upper, MZ, N(3, MIN), N(4, HALF), 0);
    BINARY(subtract_lower, MZ, N(3, MIN), N(4 - B, 0), 0);
    BINARY(subtract_normalised, MZ, N(3, HALF), N(2, MIN), 0);
    BINARY(add_upper, N(4, 3), N(0, 0x25), N(4, 5), 0);
    BINARY(add_lower, N(4, 3), N(0, 0x25), N(4 - B, INT64_C(5) << (B - 4)), 0);
    BINARY(add_upper, N(4, 3), N(0, -1), N(4, 2), 0);
    BINARY(add_lower, N(4, 3), N(0, -1), N(4 - B, INT64_C(15) << (B - 4)), 0);
    BINARY(add_upper, N(0, 0x25), N(4, -3), N(4, -1), 0);
    /* The exponent of a zero coefficient matters. */
    BINARY(add_upper, N(B - 3, 0), N(0, MAX), N(B - 3, 7), 0);
    BINARY(add_normalised, N(2 * B, 0), N(0, MAX), MZ, ZERO_FLAG);
    BINARY(add_normalised, N(2 * B - 1, 0), N(0, MAX), N(0, HALF), 0);
    /* Bits that are shifted out of the register of 2 B + 1 bits are floored. Bits of a
     * subtrahend are floored before it is negated. */
    BINARY(add_upper, N(0, HALF), N(-2 * B - 1, 1), N(0, HALF), 0);
    BINARY(add_upper, N(0, HALF), N(-2 * B - 1, -1), N(0, HALF - 1), 0);
    BINARY(add_lower, N(0, HALF), N(-2 * B - 1, -1), N(-B, MAX), 0);
    BINARY(add_normalised, N(0, HALF), N(BOTTOM, -1), N(-1, MAX), 0);
    BINARY(subtract_upper, N(0, HALF), N(-2 * B - 1, 1), N(0, HALF), 0);
    BINARY(subtract_lower, N(0, HALF), N(-2 * B - 1, -1), N(-B, 1), 0);
    BINARY(subtract_normalised, N(0, HALF), N(-B - 1, 1), N(0, HALF), 0);
    BINARY(subtract_normalised, N(0, HALF), N(-B, 1), N(-1, MAX), 0);
    BINARY(subtract_normalised, N(-B - 1, 1), N(0, HALF), N(-1, MIN), 0);
    BINARY(subtract_normalised, N(-B - 1, -1), N(0, HALF), N(0, -HALF - 1), 0);
    BINARY(add_upper, N(0, MAX), N(0, MAX), N(1, MAX), 0);
    BINARY(add_upper, N(0, MAX), N(0, 2), N(1, HALF), 0);
    BINARY(add_upper, N(0, MIN), N(0, -1), N(1, -HALF - 1), 0);
    BINARY(add_lower, N(0, MIN), N(0, -1), N(1 - B, HALF), 0);
    BINARY(add_lower, N(0, MIN), N(1 - B, -1), N(1 - B, MAX), 0);
    BINARY(subtract_upper, N(0, 0), N(0, MIN), N(1, HALF), 0);
    BINARY(add_upper, N(TOP, MAX), N(TOP, 1), IND, OVERFLOW_FLAGS);
    BINARY(add_lower, N(TOP, MAX), N(TOP, 2), N(TOP + 1 - B, HALF), 0);
    BINARY(add_normalised, N(0, 1), N(0, 1), N(2 - B, HALF), 0);
    BINARY(add_normalised, N(0, 0), N(0, -1), N(-B, MIN), 0);
    BINARY(add_normalised, N(9, 5), N(9, -5), MZ, ZERO_FLAG);
    BINARY(subtract_normalised, N(0, HALF), N(-1, MAX), N(-B, HALF), 0);
    BINARY(subtract_normalised, N(B, 1), N(0, 1), N(0, MAX), 0);
    BINARY(add_normalised, N(BOTTOM, HALF), N(BOTTOM, -HALF - 1), MZ, ZERO_FLAG);
    BINARY(add_normalised, N(TOP, MAX), N(TOP, 1), IND, OVERFLOW_FLAGS);
    BINARY(add_normalised, N(TOP, 1), N(TOP, 1), N(TOP + 2 - B, HALF), 0);
    BINARY(average, N(0, HALF), N(0, HALF), N(0, HALF), 0);
    BINARY(average, N(0, HALF), N(0, HALF + 1), N(0, HALF), 0);
    BINARY(average, N(0, 1), N(0, -1), MZ, ZERO_FLAG);
    BINARY(average, N(BOTTOM, HALF), MZ, MZ, ZERO_FLAG);
    BINARY(average, N(BOTTOM + 1, HALF), MZ, N(BOTTOM, HALF), 0);
    BINARY(average, N(TOP, MAX), N(TOP, MAX), IND, OVERFLOW_FLAGS);
    BINARY(average_difference, N(0, HALF + 2), N(0, HALF), N(1 - B, HALF), 0);
}

/* ---- Multiply ----------------------------------------------------------- */

static void products(void)
{
    BINARY(multiply_upper, IND | ANY, MZ, IND, INDEFINITE_FLAG);
    BINARY(multiply_lower, MZ, IND, IND, INDEFINITE_FLAG);
    BINARY(multiply_significant, MZ | ANY, ONE, MZ, ZERO_FLAG);
    BINARY(multiply_upper, N(0, 0), MZ, MZ, ZERO_FLAG);
    BINARY(multiply_lower, N(0, 0), MZ, MZ, ZERO_FLAG);
    BINARY(multiply_lower, ONE, MZ, MZ, ZERO_FLAG);
    BINARY(multiply_lower, N(1, 6), N(2, 7), N(3, 42), 0);
    BINARY(multiply_upper, N(1, 6), N(2, 7), N(3 + B, 0), 0);
    BINARY(multiply_upper, N(1, 6), N(2, -7), N(3 + B, -1), 0);
    BINARY(multiply_lower, N(1, 6), N(2, -7), N(3, MAX - 41), 0);
    BINARY(multiply_upper, N(0, MAX), N(0, MAX), N(B, MAX - 1), 0);
    BINARY(multiply_lower, N(0, MAX), N(0, MAX), N(0, 1), 0);
    BINARY(multiply_upper, N(0, MIN), N(0, MIN), N(B + 1, HALF), 0);
    BINARY(multiply_lower, N(0, MIN), N(0, MIN), N(0, 0), 0);
    BINARY(multiply_upper, N(0, MIN), N(0, MAX), N(B, -MAX), 0);
    BINARY(multiply_upper, N(0, MIN), N(TOP - B, MIN), IND, OVERFLOW_FLAGS);
    BINARY(multiply_lower, N(BOTTOM, 1), N(-1, 1), MZ, ZERO_FLAG);
    BINARY(multiply_lower, N(BOTTOM, 1), N(0, 1), N(BOTTOM, 1), 0);
    BINARY(multiply_upper, N(TOP, 0), N(0, 0), IND, OVERFLOW_FLAGS);
    BINARY(multiply_significant, ONE, N(5, MAX), N(5, MAX), 0);
    BINARY(multiply_significant, N(0, MAX), N(0, MAX), N(B, MAX - 1), 0);
    BINARY(multiply_significant, N(0, HALF), N(0, MIN), N(B - 1, MIN), 0);
    BINARY(multiply_significant, N(0, MIN), N(0, MIN), N(B + 1, HALF), 0);
    BINARY(multiply_significant, N(0, 6), N(0, 7), N(3, 5), 0);
    BINARY(multiply_significant, N(0, -6), N(0, 7), N(3, -6), 0);
    BINARY(multiply_significant, N(0, 1), N(0, MAX), N(B - 1, 1), 0);
    /* -1 has no significant bits. The least number of significant bits is one. */
    BINARY(multiply_significant, N(0, -1), N(0, -1), N(0, 1), 0);
    BINARY(multiply_significant, N(0, -1), N(0, 1), N(-1, -2), 0);
    BINARY(multiply_significant, N(0, -1), N(0, MIN), N(B, 1), 0);
    BINARY(multiply_significant, N(3, 0), ONE, MZ, ZERO_FLAG);
    BINARY(multiply_significant, N(TOP, HALF), N(2 - B, HALF), IND, OVERFLOW_FLAGS);
    BINARY(multiply_significant, N(TOP, HALF), N(1 - B, HALF), N(TOP, HALF), 0);
    BINARY(multiply_significant, N(BOTTOM, HALF), N(-B, HALF), MZ, ZERO_FLAG);
}

/* ---- Divide, square root ------------------------------------------------ */

static void quotients(void)
{
    int64_t seven_thirds = HALF / 2 * 7 / 3;
    BINARY(divide_upper, IND, MZ, IND, INDEFINITE_FLAG);
    BINARY(divide_upper, MZ, MZ, IND, FAULT_FLAGS);
    BINARY(divide_upper, ONE, N(5, 0), IND, FAULT_FLAGS);
    BINARY(divide_upper, MZ, ONE, MZ, ZERO_FLAG);
    BINARY(divide_upper, N(0, 1), N(0, 3), N(-B, MAX / 3), 0);
    BINARY(divide_upper, N(0, -1), N(0, 3), N(-B, -(MAX / 3)), 0);
    BINARY(divide_upper, N(0, 1), N(0, 1), N(1 - B, HALF), 0);
    BINARY(divide_upper, N(0, -1), N(0, 1), N(-B, MIN), 0);
    BINARY(divide_upper, N(0, 7), N(0, 3), N(2 - B, seven_thirds), 0);
    BINARY(divide_upper, N(0, -7), N(0, 3), N(2 - B, -seven_thirds - 1), 0);
    BINARY(divide_upper, N(5, 0), N(2, 3), N(3 - B, 0), 0);
    BINARY(divide_upper, N(0, 1), N(0, MIN), N(-B, -1), 0);
    BINARY(divide_upper, N(0, MIN), N(0, -1), N(1, HALF), 0);
    BINARY(divide_upper, N(BOTTOM, 1), N(0, MAX), MZ, ZERO_FLAG);
    BINARY(divide_upper, N(TOP, 1), N(-B, MAX), N(TOP, 1), 0);
    BINARY(divide_significant, MZ, IND | ANY, IND, INDEFINITE_FLAG);
    BINARY(divide_significant, ONE, MZ, IND, FAULT_FLAGS);
    BINARY(divide_significant, ONE, N(5, 0), IND, FAULT_FLAGS);
    BINARY(divide_significant, MZ, N(0, 3), MZ, ZERO_FLAG);
    BINARY(divide_significant, ONE, ONE, ONE, 0);
    BINARY(divide_significant, ONE, N(2 - B, HALF / 2 * 3), N(-B - 1, 4 * HALF / 3), 0);
    /* The quotient is truncated towards zero, then shifted by floor. */
    BINARY(divide_significant, N(0, -HALF - 1), N(0, MAX), N(-B, -HALF - 1), 0);
    BINARY(divide_significant, N(0, HALF), N(0, MIN), N(-B - 1, MIN), 0);
    BINARY(divide_significant, N(0, MIN), N(0, HALF), N(1 - B, MIN), 0);
    BINARY(divide_significant, N(0, MIN), N(0, MIN), N(1 - B, HALF), 0);
    BINARY(divide_significant, N(0, 7), N(0, 3), N(0, 2), 0);
    BINARY(divide_significant, N(0, -7), N(0, 3), N(0, -3), 0);
    BINARY(divide_significant, N(0, 1), N(0, MAX), N(-B, 1), 0);
    BINARY(divide_significant, N(0, 0), N(0, MAX), MZ, ZERO_FLAG);
    BINARY(divide_significant, N(TOP, MAX), N(-B, HALF), IND, OVERFLOW_FLAGS);
    BINARY(divide_significant, N(BOTTOM, HALF), N(1 - B, HALF + 1), MZ, ZERO_FLAG);
}

static void roots(void)
{
    int64_t root_of_two = INT64_C(0x5A827999FCEF) >> (47 - B);
    int64_t root_below = INT64_C(0x5A827999FCEE) >> (47 - B);
    UNARY(square_root, ONE, ONE, 0);
    UNARY(square_root, N(3 - B, HALF), N(2 - B, HALF), 0);
    UNARY(square_root, N(2 - B, HALF), N(1 - B, root_of_two), 0);
    UNARY(square_root, N(0, MAX), N(-(B / 2), root_below), 0);
    UNARY(square_root, N(1, MAX), N(-(B / 2), MAX), 0);
    UNARY(square_root, N(0, 4), N(-1, 4), 0);
    UNARY(square_root, N(0, 9), N(-2, 12), 0);
    UNARY(square_root, N(0, 1), N(0, 1), 0);
    UNARY(square_root, N(BOTTOM, HALF), N(BOTTOM / 2 - B / 2, HALF), 0);
    UNARY(square_root, N(3, 0), MZ, ZERO_FLAG);
    UNARY(square_root, MZ | N(0, 1), MZ, ZERO_FLAG);
    UNARY(square_root, MZ | N(0, -1), MZ, ZERO_FLAG);
    UNARY(square_root, N(0, -1), IND, ROOT_FLAGS);
    UNARY(square_root, IND | N(0, -1), IND, INDEFINITE_FLAG);
}

/* ---- Parts of a number, sign -------------------------------------------- */

static void parts(void)
{
    UNARY(truncate, N(-1, 5), N(0, 2), 0);
    UNARY(floor, N(-1, 5), N(0, 2), 0);
    UNARY(ceiling, N(-1, 5), N(0, 3), 0);
    UNARY(truncate, N(-1, -5), N(0, -2), 0);
    UNARY(floor, N(-1, -5), N(0, -3), 0);
    UNARY(truncate, N(-B - 1, MIN), N(0, 0), 0);
    UNARY(floor, N(-B - 1, MIN), N(0, -1), 0);
    UNARY(ceiling, N(-B - 1, MIN), N(0, 0), 0);
    UNARY(truncate, N(-B, MIN), N(0, -1), 0);
    UNARY(truncate, N(BOTTOM, MAX), N(0, 0), 0);
    UNARY(truncate, N(BOTTOM, MIN), N(0, 0), 0);
    UNARY(floor, N(BOTTOM, -1), N(0, -1), 0);
    UNARY(floor, N(7, -5), N(7, -5), 0);
    UNARY(truncate, N(-7, 0), N(0, 0), 0);
    UNARY(truncate, MZ | ANY, MZ | ANY, ZERO_FLAG);
    UNARY(floor, MZ | N(0, -1), MZ | N(0, -1), ZERO_FLAG);
    UNARY(floor, IND | N(0, 77), IND | N(0, 77), INDEFINITE_FLAG);
    UNARY(ceiling, IND | ANY, IND | ANY, INDEFINITE_FLAG);
    UNARY(negate, N(3, 5), N(3, -5), 0);
    UNARY(negate, N(3, 0), N(3, 0), 0);
    UNARY(negate, N(3, MIN), N(4, HALF), 0);
    UNARY(negate, N(3, HALF), N(2, MIN), 0);
    UNARY(negate, N(3, -HALF), N(3, HALF), 0);
    UNARY(negate, N(TOP, MIN), IND, OVERFLOW_FLAGS);
    UNARY(negate, N(BOTTOM, HALF), MZ, ZERO_FLAG);
    UNARY(negate, MZ | N(0, 5), MZ, ZERO_FLAG);
    UNARY(negate, N(BOTTOM - 1, MIN), MZ, ZERO_FLAG);
    UNARY(negate, IND | N(0, 5), IND, INDEFINITE_FLAG);
    UNARY(absolute, N(3, -5), N(3, 5), 0);
    UNARY(absolute, N(3, 5), N(3, 5), 0);
    UNARY(absolute, N(3, MIN), N(4, HALF), 0);
    UNARY(absolute, MZ | N(0, 5), MZ | N(0, 5), ZERO_FLAG);
    UNARY(absolute, IND | N(0, 5), IND | N(0, 5), INDEFINITE_FLAG);
    UNARY(absolute, IND | ANY, IND, INDEFINITE_FLAG);
}

static void exponents(void)
{
    int64_t least = -(INT64_C(1) << (size->format.exponent_bits - 1));
    UNARY(exponent, ONE, N(0, 1 - B), 0);
    UNARY(exponent, IND, N(0, TOP + 1), 0);
    UNARY(exponent, MZ, N(0, least), 0);
    BINARY(pack, N(0, 1 - B), N(9, HALF), ONE, 0);
    BINARY(pack, N(5, (0x1235 << size->format.exponent_bits) + 1 - B), ONE, ONE, 0);
    BINARY(pack, N(0, -least), N(0, -1), MZ | N(0, -1), 0);
}

static void adjust(void)
{
    BINARY(adjust_significance, N(0, 5), N(0, 2), N(-2, 20), 0);
    BINARY(adjust_significance, N(0, 5), IND | N(0, -1), N(1, 2), 0);
    BINARY(adjust_significance, N(0, 5), N(0, 99), N(3 - B, INT64_C(5) << (B - 3)), 0);
    BINARY(adjust_significance, N(0, 0), N(0, 99), N(-B, 0), 0);
    BINARY(adjust_significance, N(BOTTOM, 1), N(0, 1), MZ, ZERO_FLAG);
    BINARY(adjust_significance, N(TOP, 8), N(0, -1), IND, OVERFLOW_FLAGS);
    BINARY(adjust_significance, MZ | ANY, N(0, 1), MZ, ZERO_FLAG);
    BINARY(adjust_exponent, N(4, 3), N(0, 1), N(1, 24), 0);
    BINARY(adjust_exponent, N(4, -3), N(0, 6), N(6, -1), 0);
    BINARY(adjust_exponent, N(4, 3), IND, N(0, 48), 0);
    BINARY(adjust_exponent, N(B - 2, 2), N(0, 0), N(0, HALF), 0);
    BINARY(adjust_exponent, N(B - 1, 2), N(0, 0), IND, OVERFLOW_FLAGS);
    BINARY(adjust_exponent, N(4, 3), N(0, TOP + 1), IND, OVERFLOW_FLAGS);
    BINARY(adjust_exponent, N(4, 0), N(0, MIN), MZ, ZERO_FLAG);
    BINARY(adjust_exponent, IND | ANY, N(0, 1), IND, INDEFINITE_FLAG);
}

/* ---- Compare, shift ----------------------------------------------------- */

/* Compares words of a table, whose values increase. Up to four words of a row are
 * equal. */
static void compare(void)
{
    const c205_word ladder[][4] = {
        { N(TOP, MIN) },
        { N(1, MIN) },
        { N(0, MIN), N(1, -HALF), N(B, -1), N(B - 1, -2) },
        { N(0, -2), N(1, -1), N(1 - B, MIN), N(2 - B, -HALF) },
        { N(BOTTOM, -1) },
        { MZ, N(TOP, 0), N(BOTTOM, 0), N(BOTTOM - 1, -1) },
        { N(BOTTOM, 1) },
        { N(BOTTOM, HALF), N(BOTTOM + B - 1, 1), N(BOTTOM + B - 2, 2) },
        { ONE, N(0, 1), N(-1, 2), N(2 - B, HALF / 2) },
        { N(1 - B, HALF + 1) },
        { N(TOP, MAX) },
    };
    const c205_word others[] = { IND, ONE, MZ, N(TOP, MIN) };
    for (size_t i = 0; i < 16 * COUNT(ladder) * COUNT(ladder); i++) {
        size_t step = i / 16 / COUNT(ladder), other = i / 16 % COUNT(ladder);
        c205_word a = ladder[step][i / 4 % 4], b = ladder[other][i % 4];
        if (a == 0 || b == 0)
            continue;
        assert_int_equal(SIZED(equal)(a, b), step == other);
        assert_int_equal(SIZED(not_equal)(a, b), step != other);
        assert_int_equal(SIZED(not_less)(a, b), step >= other);
        assert_int_equal(SIZED(less)(a, b), step < other);
    }
    for (size_t i = 0; i < COUNT(others); i++) {
        assert_false(SIZED(equal)(IND, others[i]));
        assert_true(SIZED(not_equal)(others[i], IND));
        assert_false(SIZED(not_less)(IND, others[i]));
        assert_false(SIZED(less)(others[i], IND));
    }
}

/* Shifts by a word's coefficient. A half word's result is the left half. */
static void shift(void)
{
    int32_t width = format_width(size->format);
    const struct {
        int64_t count;
        c205_word expected;
    } cases[] = {
        { 0, UINT64_C(0x8123456789ABCDEF) },
        { 4, UINT64_C(0x123456789ABCDEF8) },
        { width - 1, UINT64_C(0xC091A2B3C4D5E6F7) },
        { width, UINT64_C(0x8123456789ABCDEF) },
        { width + 4, UINT64_C(0x123456789ABCDEF8) },
        { -4, UINT64_C(0xF8123456789ABCDE) },
        { -width, UINT64_MAX },
        { MIN, UINT64_MAX },
    };
    c205_word mask = format_mask(size->format), a = cases[0].expected & mask;
    for (size_t i = 0; i < COUNT(cases); i++)
        BINARY(shift, a, N(TOP + 2, cases[i].count), cases[i].expected & mask, 0);
    BINARY(shift, a >> 1 & mask, N(0, -width), 0, 0);
}

/* ---- Laws --------------------------------------------------------------- */

static c205_word any(uint64_t *seed)
{
    return xorshift(seed) & 1 ? xorshift_normalised_of(size->format, seed, -60, 60)
                              : xorshift_unnormalised_of(size->format, seed, -60, 60);
}

/* Sums and products are commutative. Upper and lower results together contain the whole
 * register, so that their sum is the normalised result. */
static void laws_of_sums(void)
{
    uint64_t seed = RANDOM_SEED, flags = 0;
    for (int i = 0; i < ROUNDS; i++) {
        c205_word a = any(&seed), b = any(&seed);
        c205_word upper = SIZED(subtract_upper)(a, b, &flags);
        c205_word lower = SIZED(subtract_lower)(a, b, &flags);
        assert_int_equal(SIZED(add_upper)(a, b, &flags),
                         SIZED(add_upper)(b, a, &flags));
        assert_int_equal(SIZED(add_lower)(a, b, &flags),
                         SIZED(add_lower)(b, a, &flags));
        assert_int_equal(SIZED(multiply_significant)(a, b, &flags),
                         SIZED(multiply_significant)(b, a, &flags));
        assert_int_equal(SIZED(add_normalised)(upper, lower, &flags),
                         SIZED(subtract_normalised)(a, b, &flags));
    }
}

/* r = root of c satisfies r^2 <= c <= (r + 1)^2, with products of the machine. */
static void laws_of_roots(void)
{
    uint64_t seed = RANDOM_SEED, flags = 0;
    c205_word step = UINT64_C(1) << format_padding(size->format);
    for (int i = 0; i < ROUNDS; i++) {
        c205_word either = xorshift_normalised_of(size->format, &seed, -60, 60);
        c205_word a = SIZED(absolute)(either, &flags);
        c205_word r = SIZED(square_root)(a, &flags), next = r + step;
        assert_true(format_is_normalised(size->format, r));
        assert_true(SIZED(not_less)(a, SIZED(multiply_significant)(r, r, &flags)));
        assert_true(
            SIZED(not_less)(SIZED(multiply_significant)(next, next, &flags), a));
    }
}

TEST(rules)
{
    static void (*const rules[])(void) = {
        format,    sums,   products, quotients, roots,        parts,
        exponents, adjust, compare,  shift,     laws_of_sums, laws_of_roots,
    };
    for (size = sizes; size < sizes + COUNT(sizes); size++)
        for (size_t i = 0; i < COUNT(rules); i++)
            rules[i]();
}

/* ---- Conversion between the sizes --------------------------------------- */

#define W(exponent, coefficient) word_make(exponent, coefficient)
#define H(exponent, coefficient) format_make(half_words, exponent, coefficient)
#define CONVERTS(op, a, expected, flags) UNARY_GIVES(arith_##op, a, expected, flags)

enum {
    WORD_TOP = WORD_EXPONENT_MAX,
    WORD_BOTTOM = WORD_EXPONENT_MIN,
    HALF_MAX = 0x7FFFFF,
    HALF_HALF = 0x400000
};

TEST(contract)
{
    CONVERTS(contract, C205_ONE, C205_HALF_ONE, 0);
    CONVERTS(contract, W(0, 0xFFFFFF), H(24, 0), 0);
    CONVERTS(contract, W(0, 0x1000000), H(24, 1), 0);
    CONVERTS(contract, W(0, -1), H(24, -1), 0);
    CONVERTS(contract, W(0, WORD_COEFFICIENT_MAX), H(24, HALF_MAX), 0);
    CONVERTS(contract, W(HALF_TOP - 24, 1), H(HALF_TOP, 0), 0);
    CONVERTS(contract, W(HALF_TOP - 23, 0), IND, OVERFLOW_FLAGS);
    CONVERTS(contract, W(HALF_BOTTOM - 24, -1), H(HALF_BOTTOM, -1), 0);
    CONVERTS(contract, W(HALF_BOTTOM - 25, -1), MZ, ZERO_FLAG);
    CONVERTS(contract, MZ | 77, MZ, ZERO_FLAG);
    CONVERTS(contract, IND | 77, IND, INDEFINITE_FLAG);
    CONVERTS(contract_rounded, C205_ONE, C205_HALF_ONE, 0);
    CONVERTS(contract_rounded, W(0, 0x7FFFFF), H(24, 0), 0);
    CONVERTS(contract_rounded, W(0, 0x800000), H(24, 1), 0);
    CONVERTS(contract_rounded, W(0, -0x800000), H(24, 0), 0);
    CONVERTS(contract_rounded, W(0, -0x800001), H(24, -1), 0);
    CONVERTS(contract_rounded, W(0, WORD_COEFFICIENT_MAX), H(25, HALF_HALF), 0);
    CONVERTS(contract_rounded, W(HALF_TOP - 24, WORD_COEFFICIENT_MAX), IND,
             OVERFLOW_FLAGS);
    CONVERTS(contract_rounded, W(HALF_BOTTOM - 25, WORD_COEFFICIENT_MAX),
             H(HALF_BOTTOM, HALF_HALF), 0);
    CONVERTS(contract_rounded, MZ | 77, MZ, ZERO_FLAG);
    CONVERTS(contract_rounded, IND | 77, IND, INDEFINITE_FLAG);
}

TEST(extend)
{
    CONVERTS(extend, C205_HALF_ONE, C205_ONE, 0);
    CONVERTS(extend, H(HALF_BOTTOM, -1), W(HALF_BOTTOM - 24, -0x1000000), 0);
    CONVERTS(extend, H(HALF_TOP, 0), W(HALF_TOP - 24, 0), 0);
    CONVERTS(extend, MZ | H(0, 0x923456), MZ, ZERO_FLAG);
    CONVERTS(extend, IND | H(0, 0x923456), IND, INDEFINITE_FLAG);
}

TEST(extended_come_back)
{
    uint64_t seed = RANDOM_SEED, flags = 0;
    for (int i = 0; i < ROUNDS; i++) {
        c205_word a = xorshift_unnormalised_of(half_words, &seed, HALF_BOTTOM,
                                               HALF_TOP);
        c205_word word = arith_extend(a, &flags);
        assert_int_equal(arith_contract(word, &flags), a);
        assert_int_equal(arith_contract_rounded(word, &flags), a);
        assert_true(c205_to_double(word) == c205_half_to_double(a));
    }
}

/* All results are floored, so a half result is the truncated full result. */
TEST(half_results_are_cut)
{
    uint64_t seed = RANDOM_SEED, flags = 0;
    for (int i = 0; i < ROUNDS; i++) {
        c205_word a = half_absolute(xorshift_normalised_of(half_words, &seed, -40, 30),
                                    &flags);
        c205_word b = xorshift_normalised_of(half_words, &seed, -40, 30);
        c205_word x = arith_extend(a, &flags), y = arith_extend(b, &flags);
        c205_word sum = arith_add_normalised(x, y, &flags);
        c205_word product = arith_multiply_significant(x, y, &flags);
        c205_word root = arith_square_root(x, &flags);
        assert_int_equal(half_add_normalised(a, b, &flags),
                         arith_contract(sum, &flags));
        assert_int_equal(half_multiply_significant(a, b, &flags),
                         arith_contract(product, &flags));
        assert_int_equal(half_square_root(a, &flags), arith_contract(root, &flags));
        assert_int_equal(half_less(a, b), arith_less(x, y));
    }
}
