/* test_arith.c - the edges of each rule of docs/arithmetic.md, with results
 * worked out by hand. */
#include "tests/random.h"
#include "tests/unit/rule_cases.h"

#define MAX WORD_COEFFICIENT_MAX
#define MIN WORD_COEFFICIENT_MIN
#define HALF (INT64_C(1) << 46)

enum { TOP = WORD_EXPONENT_MAX, BOTTOM = WORD_EXPONENT_MIN, ROUNDS = 20000 };

/* word_make as a constant. */
#define W(exponent, coefficient) \
    ((c205_word)(int64_t)(exponent) << 48 \
     | ((c205_word)(coefficient)&WORD_COEFFICIENT_MASK))

#define BINARY(op, a, b, expected, flags) \
    BINARY_GIVES(arith_##op, a, b, expected, flags)
#define UNARY(op, a, expected, flags) UNARY_GIVES(arith_##op, a, expected, flags)

/* ---- Add, subtract ------------------------------------------------------ */

TEST(add_machine_zero)
{
    BINARY(add_upper, W(3, 5), MZ + 9, W(3, 5), 0);
    BINARY(add_upper, MZ + 9, W(BOTTOM, 5), W(BOTTOM, 5), 0);
    BINARY(add_lower, W(3, 5), MZ + 9, W(-44, 0), 0);
    BINARY(add_lower, W(BOTTOM, 5), MZ, MZ, ZERO_FLAG);
    BINARY(add_normalised, MZ, W(3, 1), W(-43, HALF), 0);
    BINARY(add_normalised, MZ, W(3, 0), MZ, ZERO_FLAG);
    BINARY(subtract_upper, MZ, W(3, 5), W(3, -5), 0);
    BINARY(subtract_upper, MZ, W(3, MIN), W(4, HALF), 0);
    BINARY(subtract_lower, MZ, W(3, MIN), W(4 - 47, 0), 0);
    BINARY(subtract_normalised, MZ, W(3, HALF), W(2, MIN), 0);
}

TEST(add_aligns)
{
    BINARY(add_upper, W(4, 3), W(0, 0x25), W(4, 5), 0);
    BINARY(add_lower, W(4, 3), W(0, 0x25), W(-43, INT64_C(5) << 43), 0);
    BINARY(add_upper, W(4, 3), W(0, -1), W(4, 2), 0);
    BINARY(add_lower, W(4, 3), W(0, -1), W(-43, INT64_C(15) << 43), 0);
    BINARY(add_upper, W(0, 0x25), W(4, -3), W(4, -1), 0);
    /* A zero coefficient counts with its exponent. */
    BINARY(add_upper, W(40, 0), W(0, MAX), W(40, MAX >> 40), 0);
    BINARY(add_normalised, W(94, 0), W(0, MAX), MZ, ZERO_FLAG);
    BINARY(add_normalised, W(93, 0), W(0, MAX), W(0, HALF), 0);
}

/* What leaves the register of 95 bits is floored; a subtrahend before its
 * sign changes. */
TEST(add_beyond_the_register)
{
    BINARY(add_upper, W(0, HALF), W(-95, 1), W(0, HALF), 0);
    BINARY(add_upper, W(0, HALF), W(-95, -1), W(0, HALF - 1), 0);
    BINARY(add_lower, W(0, HALF), W(-95, -1), W(-47, MAX), 0);
    BINARY(add_normalised, W(0, HALF), W(-9999, -1), W(-1, MAX), 0);
    BINARY(subtract_upper, W(0, HALF), W(-95, 1), W(0, HALF), 0);
    BINARY(subtract_lower, W(0, HALF), W(-95, -1), W(-47, 1), 0);
    BINARY(subtract_normalised, W(0, HALF), W(-48, 1), W(0, HALF), 0);
    BINARY(subtract_normalised, W(0, HALF), W(-47, 1), W(-1, MAX), 0);
    BINARY(subtract_normalised, W(-48, 1), W(0, HALF), W(-1, MIN), 0);
    BINARY(subtract_normalised, W(-48, -1), W(0, HALF), W(0, -HALF - 1), 0);
}

TEST(add_overflows_the_register)
{
    BINARY(add_upper, W(0, MAX), W(0, MAX), W(1, MAX), 0);
    BINARY(add_upper, W(0, MAX), W(0, 2), W(1, HALF), 0);
    BINARY(add_upper, W(0, MIN), W(0, -1), W(1, -HALF - 1), 0);
    BINARY(add_lower, W(0, MIN), W(0, -1), W(-46, HALF), 0);
    BINARY(add_lower, W(0, MIN), W(-46, -1), W(-46, MAX), 0);
    BINARY(subtract_upper, W(0, 0), W(0, MIN), W(1, HALF), 0);
    BINARY(add_upper, W(TOP, MAX), W(TOP, 1), IND, OVERFLOW_FLAGS);
    BINARY(add_lower, W(TOP, MAX), W(TOP, 2), W(TOP - 46, HALF), 0);
}

TEST(add_normalises)
{
    BINARY(add_normalised, W(0, 1), W(0, 1), W(-45, HALF), 0);
    BINARY(add_normalised, W(0, 0), W(0, -1), W(-47, MIN), 0);
    BINARY(add_normalised, W(9, 5), W(9, -5), MZ, ZERO_FLAG);
    BINARY(subtract_normalised, W(0, HALF), W(-1, MAX), W(-47, HALF), 0);
    BINARY(subtract_normalised, W(47, 1), W(0, 1), W(0, MAX), 0);
    BINARY(add_normalised, W(BOTTOM, HALF), W(BOTTOM, -HALF - 1), MZ, ZERO_FLAG);
    BINARY(add_normalised, W(TOP, MAX), W(TOP, 1), IND, OVERFLOW_FLAGS);
    BINARY(add_normalised, W(TOP, 1), W(TOP, 1), W(TOP - 45, HALF), 0);
}

TEST(average)
{
    BINARY(average, W(0, HALF), W(0, HALF), W(0, HALF), 0);
    BINARY(average, W(0, HALF), W(0, HALF + 1), W(0, HALF), 0);
    BINARY(average, W(0, 1), W(0, -1), MZ, ZERO_FLAG);
    BINARY(average, W(BOTTOM, HALF), MZ, MZ, ZERO_FLAG);
    BINARY(average, W(BOTTOM + 1, HALF), MZ, W(BOTTOM, HALF), 0);
    BINARY(average, W(TOP, MAX), W(TOP, MAX), IND, OVERFLOW_FLAGS);
    BINARY(average_difference, W(0, HALF + 2), W(0, HALF), W(-46, HALF), 0);
}

/* ---- Multiply ----------------------------------------------------------- */

TEST(multiply_special)
{
    BINARY(multiply_upper, IND + 1, MZ, IND, INDEFINITE_FLAG);
    BINARY(multiply_lower, MZ, IND, IND, INDEFINITE_FLAG);
    BINARY(multiply_significant, MZ + 3, C205_ONE, MZ, ZERO_FLAG);
    BINARY(multiply_upper, W(0, 0), MZ, MZ, ZERO_FLAG);
    BINARY(multiply_lower, C205_ONE, MZ, MZ, ZERO_FLAG);
}

TEST(multiply_halves)
{
    BINARY(multiply_lower, W(1, 6), W(2, 7), W(3, 42), 0);
    BINARY(multiply_upper, W(1, 6), W(2, 7), W(50, 0), 0);
    BINARY(multiply_upper, W(1, 6), W(2, -7), W(50, -1), 0);
    BINARY(multiply_lower, W(1, 6), W(2, -7), W(3, MAX - 41), 0);
    BINARY(multiply_upper, W(0, MAX), W(0, MAX), W(47, MAX - 1), 0);
    BINARY(multiply_lower, W(0, MAX), W(0, MAX), W(0, 1), 0);
    BINARY(multiply_upper, W(0, MIN), W(0, MIN), W(48, HALF), 0);
    BINARY(multiply_lower, W(0, MIN), W(0, MIN), W(0, 0), 0);
    BINARY(multiply_upper, W(0, MIN), W(0, MAX), W(47, -MAX), 0);
    BINARY(multiply_upper, W(0, MIN), W(TOP - 47, MIN), IND, OVERFLOW_FLAGS);
    BINARY(multiply_lower, W(BOTTOM, 1), W(-1, 1), MZ, ZERO_FLAG);
    BINARY(multiply_lower, W(BOTTOM, 1), W(0, 1), W(BOTTOM, 1), 0);
    BINARY(multiply_upper, W(TOP, 0), W(0, 0), IND, OVERFLOW_FLAGS);
}

TEST(multiply_significant)
{
    BINARY(multiply_significant, C205_ONE, W(5, MAX), W(5, MAX), 0);
    BINARY(multiply_significant, W(0, MAX), W(0, MAX), W(47, MAX - 1), 0);
    BINARY(multiply_significant, W(0, HALF), W(0, MIN), W(46, MIN), 0);
    BINARY(multiply_significant, W(0, MIN), W(0, MIN), W(48, HALF), 0);
    BINARY(multiply_significant, W(0, 6), W(0, 7), W(3, 5), 0);
    BINARY(multiply_significant, W(0, -6), W(0, 7), W(3, -6), 0);
    BINARY(multiply_significant, W(0, 1), W(0, MAX), W(46, 1), 0);
    /* -1 has no significant bits: one is the least. */
    BINARY(multiply_significant, W(0, -1), W(0, -1), W(0, 1), 0);
    BINARY(multiply_significant, W(0, -1), W(0, 1), W(-1, -2), 0);
    BINARY(multiply_significant, W(0, -1), W(0, MIN), W(47, 1), 0);
    BINARY(multiply_significant, W(3, 0), C205_ONE, MZ, ZERO_FLAG);
    BINARY(multiply_significant, W(TOP, HALF), W(-45, HALF), IND, OVERFLOW_FLAGS);
    BINARY(multiply_significant, W(TOP, HALF), W(-46, HALF), W(TOP, HALF), 0);
    BINARY(multiply_significant, W(BOTTOM, HALF), W(-47, HALF), MZ, ZERO_FLAG);
}

/* ---- Divide ------------------------------------------------------------- */

TEST(divide_special)
{
    BINARY(divide_upper, IND, MZ, IND, INDEFINITE_FLAG);
    BINARY(divide_significant, MZ, IND + 1, IND, INDEFINITE_FLAG);
    BINARY(divide_significant, C205_ONE, MZ, IND, FAULT_FLAGS);
    BINARY(divide_significant, C205_ONE, W(5, 0), IND, FAULT_FLAGS);
    BINARY(divide_upper, MZ, MZ, IND, FAULT_FLAGS);
    BINARY(divide_upper, MZ, C205_ONE, MZ, ZERO_FLAG);
    BINARY(divide_significant, MZ, W(0, 3), MZ, ZERO_FLAG);
}

TEST(divide_upper)
{
    BINARY(divide_upper, W(0, 1), W(0, 3), W(-47, 0x2AAAAAAAAAAA), 0);
    BINARY(divide_upper, W(0, -1), W(0, 3), W(-47, -0x2AAAAAAAAAAA), 0);
    BINARY(divide_upper, W(0, 1), W(0, 1), W(-46, HALF), 0);
    BINARY(divide_upper, W(0, -1), W(0, 1), W(-47, MIN), 0);
    BINARY(divide_upper, W(0, 7), W(0, 3), W(-45, 0x4AAAAAAAAAAA), 0);
    BINARY(divide_upper, W(0, -7), W(0, 3), W(-45, -0x4AAAAAAAAAAB), 0);
    BINARY(divide_upper, W(5, 0), W(2, 3), W(-44, 0), 0);
    BINARY(divide_upper, W(0, 1), W(0, MIN), W(-47, -1), 0);
    BINARY(divide_upper, W(0, MIN), W(0, -1), W(1, HALF), 0);
    BINARY(divide_upper, W(BOTTOM, 1), W(0, MAX), MZ, ZERO_FLAG);
    BINARY(divide_upper, W(TOP, 1), W(-47, MAX), W(TOP, 1), 0);
}

TEST(divide_significant)
{
    BINARY(divide_significant, C205_ONE, C205_ONE, C205_ONE, 0);
    BINARY(divide_significant, C205_ONE, W(-45, HALF / 2 * 3), W(-48, 0x555555555555),
           0);
    /* The quotient is cut to zero, then shifted by floor. */
    BINARY(divide_significant, W(0, -HALF - 1), W(0, MAX), W(-47, -0x400000000001), 0);
    BINARY(divide_significant, W(0, HALF), W(0, MIN), W(-48, MIN), 0);
    BINARY(divide_significant, W(0, MIN), W(0, HALF), W(-46, MIN), 0);
    BINARY(divide_significant, W(0, MIN), W(0, MIN), W(-46, HALF), 0);
    BINARY(divide_significant, W(0, 7), W(0, 3), W(0, 2), 0);
    BINARY(divide_significant, W(0, -7), W(0, 3), W(0, -3), 0);
    BINARY(divide_significant, W(0, 1), W(0, MAX), W(-47, 1), 0);
    BINARY(divide_significant, W(0, 0), W(0, MAX), MZ, ZERO_FLAG);
    BINARY(divide_significant, W(TOP, MAX), W(-47, HALF), IND, OVERFLOW_FLAGS);
    BINARY(divide_significant, W(BOTTOM, HALF), W(-46, HALF + 1), MZ, ZERO_FLAG);
}

/* ---- Square root -------------------------------------------------------- */

TEST(square_root)
{
    UNARY(square_root, C205_ONE, C205_ONE, 0);
    UNARY(square_root, W(-44, HALF), W(-45, HALF), 0);
    UNARY(square_root, W(-45, HALF), W(-46, 0x5A827999FCEF), 0);
    UNARY(square_root, W(0, MAX), W(-23, 0x5A827999FCEE), 0);
    UNARY(square_root, W(1, MAX), W(-23, MAX), 0);
    UNARY(square_root, W(0, 4), W(0, 4) - (UINT64_C(1) << 48), 0);
    UNARY(square_root, W(0, 9), W(-2, 12), 0);
    UNARY(square_root, W(0, 1), W(0, 1), 0);
    UNARY(square_root, W(3, 0), MZ, ZERO_FLAG);
    UNARY(square_root, MZ + 1, MZ, ZERO_FLAG);
    UNARY(square_root, MZ | UINT64_C(0xFFFFFFFFFFFF), MZ, ZERO_FLAG);
    UNARY(square_root, W(0, -1), IND, ROOT_FLAGS);
    UNARY(square_root, IND | UINT64_C(0xFFFFFFFFFFFF), IND, INDEFINITE_FLAG);
    UNARY(square_root, W(BOTTOM, HALF), W(BOTTOM / 2 - 23, HALF), 0);
}

/* ---- Parts of a number, sign -------------------------------------------- */

TEST(integer_parts)
{
    UNARY(truncate, W(-1, 5), W(0, 2), 0);
    UNARY(floor, W(-1, 5), W(0, 2), 0);
    UNARY(truncate, W(-1, -5), W(0, -2), 0);
    UNARY(floor, W(-1, -5), W(0, -3), 0);
    UNARY(truncate, W(-48, MIN), W(0, 0), 0);
    UNARY(floor, W(-48, MIN), W(0, -1), 0);
    UNARY(truncate, W(-47, MIN), W(0, -1), 0);
    UNARY(truncate, W(-9999, MAX), W(0, 0), 0);
    UNARY(truncate, W(-9999, MIN), W(0, 0), 0);
    UNARY(floor, W(-9999, -1), W(0, -1), 0);
    UNARY(floor, W(7, -5), W(7, -5), 0);
    UNARY(truncate, W(-7, 0), W(0, 0), 0);
    UNARY(truncate, MZ | 77, MZ | 77, ZERO_FLAG);
    UNARY(floor, MZ | UINT64_C(0xFFFFFFFFFFFF), MZ | UINT64_C(0xFFFFFFFFFFFF),
          ZERO_FLAG);
    UNARY(floor, IND | 77, IND | 77, INDEFINITE_FLAG);
}

TEST(sign)
{
    UNARY(negate, W(3, 5), W(3, -5), 0);
    UNARY(negate, W(3, 0), W(3, 0), 0);
    UNARY(negate, W(3, MIN), W(4, HALF), 0);
    UNARY(negate, W(3, HALF), W(2, MIN), 0);
    UNARY(negate, W(3, -HALF), W(3, HALF), 0);
    UNARY(negate, W(TOP, MIN), IND, OVERFLOW_FLAGS);
    UNARY(negate, W(BOTTOM, HALF), MZ, ZERO_FLAG);
    UNARY(negate, MZ | 5, MZ, ZERO_FLAG);
    UNARY(negate, UINT64_C(0x8FFF800000000000), MZ, ZERO_FLAG);
    UNARY(negate, IND | 5, IND, INDEFINITE_FLAG);
    UNARY(absolute, W(3, -5), W(3, 5), 0);
    UNARY(absolute, W(3, 5), W(3, 5), 0);
    UNARY(absolute, W(3, MIN), W(4, HALF), 0);
    UNARY(absolute, MZ | 5, MZ | 5, ZERO_FLAG);
    UNARY(absolute, IND | 5, IND | 5, INDEFINITE_FLAG);
    UNARY(absolute, IND | UINT64_C(0xFFFFFFFFFFFF), IND, INDEFINITE_FLAG);
}

TEST(exponent)
{
    UNARY(exponent, C205_ONE, W(0, -46), 0);
    UNARY(exponent, IND, W(0, 0x7000), 0);
    UNARY(exponent, MZ, W(0, -0x8000), 0);
}

/* ---- Compare ------------------------------------------------------------ */

/* Rising values; those of one row are equal. */
static const c205_word ladder[][4] = {
    { W(TOP, MIN), W(TOP, MIN), W(TOP, MIN), W(TOP, MIN) },
    { W(1, MIN), W(1, MIN), W(1, MIN), W(1, MIN) },
    { W(0, MIN), W(1, -HALF), W(47, -1), W(46, -2) },
    { W(0, -2), W(1, -1), W(-46, MIN), W(-45, -HALF) },
    { W(BOTTOM, -1), W(BOTTOM, -1), W(BOTTOM, -1), W(BOTTOM, -1) },
    { MZ, W(TOP, 0), W(BOTTOM, 0), MZ | UINT64_C(0xFFFFFFFFFFFF) },
    { W(BOTTOM, 1), W(BOTTOM, 1), W(BOTTOM, 1), W(BOTTOM, 1) },
    { W(BOTTOM, HALF), W(BOTTOM + 46, 1), W(BOTTOM + 45, 2), W(BOTTOM, HALF) },
    { C205_ONE, W(0, 1), W(-1, 2), W(-45, HALF / 2) },
    { W(-46, HALF + 1), W(-46, HALF + 1), W(-46, HALF + 1), W(-46, HALF + 1) },
    { W(TOP, MAX), W(TOP, MAX), W(TOP, MAX), W(TOP, MAX) },
};

static void compare_steps(size_t i, size_t j)
{
    for (size_t k = 0; k < 16; k++) {
        c205_word a = ladder[i][k / 4], b = ladder[j][k % 4];
        assert_int_equal(arith_equal(a, b), i == j);
        assert_int_equal(arith_not_equal(a, b), i != j);
        assert_int_equal(arith_not_less(a, b), i >= j);
        assert_int_equal(arith_less(a, b), i < j);
    }
}

TEST(compare)
{
    size_t steps = COUNT(ladder);

    for (size_t i = 0; i < steps; i++)
        for (size_t j = 0; j < steps; j++)
            compare_steps(i, j);
}

TEST(compare_indefinite)
{
    const c205_word others[] = { IND, C205_ONE, MZ, W(TOP, MIN) };

    for (size_t i = 0; i < COUNT(others); i++) {
        assert_false(arith_equal(IND, others[i]));
        assert_true(arith_not_equal(others[i], IND));
        assert_false(arith_not_less(IND, others[i]));
        assert_false(arith_less(others[i], IND));
    }
}

/* ---- Shift -------------------------------------------------------------- */

/* By the coefficient of any word. */
static c205_word shifted(c205_word a, int64_t count)
{
    uint64_t flags = 0;
    c205_word result = arith_shift(a, W(0x7123, count), &flags);

    assert_int_equal(flags, 0);
    return result;
}

TEST(shift)
{
    c205_word a = UINT64_C(0x8123456789ABCDEF);

    assert_int_equal(shifted(a, 0), a);
    assert_int_equal(shifted(a, 4), UINT64_C(0x123456789ABCDEF8));
    assert_int_equal(shifted(a, 63), UINT64_C(0xC091A2B3C4D5E6F7));
    assert_int_equal(shifted(a, 68), UINT64_C(0x123456789ABCDEF8));
    assert_int_equal(shifted(a, -4), UINT64_C(0xF8123456789ABCDE));
    assert_int_equal(shifted(a, -64), UINT64_MAX);
    assert_int_equal(shifted(a, MIN), UINT64_MAX);
    assert_int_equal(shifted(a >> 1, -64), 0);
}

/* ---- Laws --------------------------------------------------------------- */

static c205_word any(uint64_t *seed)
{
    return xorshift(seed) & 1 ? xorshift_normalised(seed, -60, 60)
                              : xorshift_unnormalised(seed, -60, 60);
}

TEST(add_and_multiply_commute)
{
    uint64_t seed = RANDOM_SEED, flags = 0;

    for (int i = 0; i < ROUNDS; i++) {
        c205_word a = any(&seed), b = any(&seed);
        assert_int_equal(arith_add_upper(a, b, &flags), arith_add_upper(b, a, &flags));
        assert_int_equal(arith_add_lower(a, b, &flags), arith_add_lower(b, a, &flags));
        assert_int_equal(arith_multiply_significant(a, b, &flags),
                         arith_multiply_significant(b, a, &flags));
    }
}

/* Upper and lower hold all of the register: their sum normalised is the
 * normalised sum. */
TEST(upper_and_lower_make_the_whole)
{
    uint64_t seed = RANDOM_SEED, flags = 0;

    for (int i = 0; i < ROUNDS; i++) {
        c205_word a = any(&seed), b = any(&seed);
        c205_word upper = arith_subtract_upper(a, b, &flags);
        c205_word lower = arith_subtract_lower(a, b, &flags);
        assert_int_equal(arith_add_normalised(upper, lower, &flags),
                         arith_subtract_normalised(a, b, &flags));
    }
}

/* r = root of c: r^2 <= c <= (r + 1)^2, by products of the machine. */
TEST(roots_and_squares)
{
    uint64_t seed = RANDOM_SEED, flags = 0;

    for (int i = 0; i < ROUNDS; i++) {
        c205_word a = arith_absolute(xorshift_normalised(&seed, -99, 99), &flags);
        c205_word r = arith_square_root(a, &flags);
        c205_word square = arith_multiply_significant(r, r, &flags);
        c205_word next = arith_multiply_significant(r + 1, r + 1, &flags);
        assert_true(word_is_normalised(r));
        assert_true(arith_not_less(a, square));
        assert_true(arith_not_less(next, a));
    }
}
