/* test_half.c - the edges of each rule for half words, with results worked
 * out by hand, and the way between the sizes. */
#include "tests/random.h"
#include "tests/unit/rule_cases.h"

#define ONE C205_HALF_ONE
#define HALF (INT64_C(1) << 22)

enum { MAX = 0x7FFFFF, MIN = -0x800000, TOP = 111, BOTTOM = -112, ROUNDS = 20000 };

/* A half word. */
#define H(exponent, coefficient) \
    ((c205_word)(int64_t)(exponent) << 56 | ((c205_word)(coefficient)&0xFFFFFF) << 32)
/* A word. */
#define W(exponent, coefficient) word_make(exponent, coefficient)
/* Coefficients in words that are special for their exponents. */
#define ANY H(0, 0x923456)

#define BINARY(op, a, b, expected, flags) BINARY_GIVES(half_##op, a, b, expected, flags)
#define UNARY(op, a, expected, flags) UNARY_GIVES(half_##op, a, expected, flags)

TEST(format)
{
    assert_int_equal(H(-22, HALF), ONE);
    assert_int_equal(format_exponent_max(half_words), TOP);
    assert_int_equal(format_exponent_min(half_words), BOTTOM);
    assert_int_equal(format_exponent_max(whole_words), WORD_EXPONENT_MAX);
    assert_int_equal(format_exponent_min(whole_words), WORD_EXPONENT_MIN);
    assert_true(word_is_machine_zero(H(BOTTOM - 1, 5)));
    assert_true(word_is_indefinite(H(TOP + 1, 5)));
    assert_true(format_is_normalised(half_words, H(TOP, MIN)));
    assert_false(format_is_normalised(half_words, H(TOP, -HALF)));
}

/* ---- Add, subtract ------------------------------------------------------ */

TEST(add_machine_zero)
{
    BINARY(add_upper, MZ | ANY, H(3, 5), H(3, 5), 0);
    BINARY(add_lower, H(3, 5), MZ | ANY, H(-20, 0), 0);
    BINARY(add_lower, H(BOTTOM, 5), MZ, MZ, ZERO_FLAG);
    BINARY(add_normalised, MZ, H(3, 1), H(-19, HALF), 0);
    BINARY(add_normalised, MZ, H(3, 0), MZ, ZERO_FLAG);
    BINARY(subtract_upper, MZ, H(3, MIN), H(4, HALF), 0);
    BINARY(subtract_lower, MZ, H(3, MIN), H(4 - 23, 0), 0);
    BINARY(subtract_normalised, MZ, H(3, HALF), H(2, MIN), 0);
}

TEST(add_aligns)
{
    BINARY(add_upper, H(4, 3), H(0, 0x25), H(4, 5), 0);
    BINARY(add_lower, H(4, 3), H(0, 0x25), H(-19, 5 << 19), 0);
    BINARY(add_lower, H(4, 3), H(0, -1), H(-19, 15 << 19), 0);
    BINARY(add_upper, H(20, 0), H(0, MAX), H(20, 7), 0);
    BINARY(add_normalised, H(46, 0), H(0, MAX), MZ, ZERO_FLAG);
    BINARY(add_normalised, H(45, 0), H(0, MAX), H(0, HALF), 0);
    /* What leaves the register of 47 bits is floored, a subtrahend before
     * its sign changes. */
    BINARY(add_upper, H(0, HALF), H(-47, -1), H(0, HALF - 1), 0);
    BINARY(add_lower, H(0, HALF), H(-47, -1), H(-23, MAX), 0);
    BINARY(add_normalised, H(0, HALF), H(BOTTOM, -1), H(-1, MAX), 0);
    BINARY(subtract_lower, H(0, HALF), H(-47, -1), H(-23, 1), 0);
    BINARY(subtract_normalised, H(0, HALF), H(-24, 1), H(0, HALF), 0);
    BINARY(subtract_normalised, H(0, HALF), H(-23, 1), H(-1, MAX), 0);
    BINARY(subtract_normalised, H(-24, 1), H(0, HALF), H(-1, MIN), 0);
    BINARY(subtract_normalised, H(-24, -1), H(0, HALF), H(0, -HALF - 1), 0);
}

TEST(add_overflows_the_register)
{
    BINARY(add_upper, H(0, MAX), H(0, MAX), H(1, MAX), 0);
    BINARY(add_upper, H(0, MIN), H(0, -1), H(1, -HALF - 1), 0);
    BINARY(add_lower, H(0, MIN), H(0, -1), H(-22, HALF), 0);
    BINARY(subtract_upper, H(0, 0), H(0, MIN), H(1, HALF), 0);
    BINARY(add_upper, H(TOP, MAX), H(TOP, 1), IND, OVERFLOW_FLAGS);
    BINARY(add_lower, H(TOP, MAX), H(TOP, 2), H(89, HALF), 0);
}

TEST(add_normalises)
{
    BINARY(add_normalised, H(0, 1), H(0, 1), H(-21, HALF), 0);
    BINARY(add_normalised, H(0, 0), H(0, -1), H(-23, MIN), 0);
    BINARY(add_normalised, H(9, 5), H(9, -5), MZ, ZERO_FLAG);
    BINARY(subtract_normalised, H(23, 1), H(0, 1), H(0, MAX), 0);
    BINARY(add_normalised, H(BOTTOM, HALF), H(BOTTOM, -HALF - 1), MZ, ZERO_FLAG);
    BINARY(add_normalised, H(TOP, MAX), H(TOP, 1), IND, OVERFLOW_FLAGS);
    BINARY(average, H(0, HALF), H(0, HALF + 1), H(0, HALF), 0);
    BINARY(average, H(BOTTOM, HALF), MZ, MZ, ZERO_FLAG);
    BINARY(average, H(TOP, MAX), H(TOP, MAX), IND, OVERFLOW_FLAGS);
    BINARY(average_difference, H(0, HALF + 2), H(0, HALF), H(-22, HALF), 0);
}

/* ---- Multiply ----------------------------------------------------------- */

TEST(multiply)
{
    BINARY(multiply_upper, IND | ANY, MZ, IND, INDEFINITE_FLAG);
    BINARY(multiply_significant, MZ | ANY, ONE, MZ, ZERO_FLAG);
    BINARY(multiply_lower, H(0, 0), MZ, MZ, ZERO_FLAG);
    BINARY(multiply_lower, H(1, 6), H(2, 7), H(3, 42), 0);
    BINARY(multiply_upper, H(1, 6), H(2, 7), H(26, 0), 0);
    BINARY(multiply_upper, H(1, 6), H(2, -7), H(26, -1), 0);
    BINARY(multiply_lower, H(1, 6), H(2, -7), H(3, MAX - 41), 0);
    BINARY(multiply_upper, H(0, MAX), H(0, MAX), H(23, MAX - 1), 0);
    BINARY(multiply_lower, H(0, MAX), H(0, MAX), H(0, 1), 0);
    BINARY(multiply_upper, H(0, MIN), H(0, MIN), H(24, HALF), 0);
    BINARY(multiply_lower, H(0, MIN), H(0, MIN), H(0, 0), 0);
    BINARY(multiply_upper, H(0, MIN), H(TOP - 23, MIN), IND, OVERFLOW_FLAGS);
    BINARY(multiply_lower, H(BOTTOM, 1), H(-1, 1), MZ, ZERO_FLAG);
    BINARY(multiply_lower, H(BOTTOM, 1), H(0, 1), H(BOTTOM, 1), 0);
}

TEST(multiply_significant)
{
    BINARY(multiply_significant, ONE, H(5, MAX), H(5, MAX), 0);
    BINARY(multiply_significant, H(0, HALF), H(0, MIN), H(22, MIN), 0);
    BINARY(multiply_significant, H(0, MIN), H(0, MIN), H(24, HALF), 0);
    BINARY(multiply_significant, H(0, 6), H(0, 7), H(3, 5), 0);
    BINARY(multiply_significant, H(0, -6), H(0, 7), H(3, -6), 0);
    BINARY(multiply_significant, H(0, 1), H(0, MAX), H(22, 1), 0);
    BINARY(multiply_significant, H(0, -1), H(0, 1), H(-1, -2), 0);
    BINARY(multiply_significant, H(3, 0), ONE, MZ, ZERO_FLAG);
    BINARY(multiply_significant, H(TOP, HALF), H(-21, HALF), IND, OVERFLOW_FLAGS);
    BINARY(multiply_significant, H(TOP, HALF), H(-22, HALF), H(TOP, HALF), 0);
    BINARY(multiply_significant, H(BOTTOM, HALF), H(-23, HALF), MZ, ZERO_FLAG);
}

/* ---- Divide, square root ------------------------------------------------ */

TEST(divide_upper)
{
    BINARY(divide_upper, IND, MZ, IND, INDEFINITE_FLAG);
    BINARY(divide_upper, MZ, MZ, IND, FAULT_FLAGS);
    BINARY(divide_upper, ONE, H(5, 0), IND, FAULT_FLAGS);
    BINARY(divide_upper, MZ, ONE, MZ, ZERO_FLAG);
    BINARY(divide_upper, H(0, 1), H(0, 3), H(-23, 0x2AAAAA), 0);
    BINARY(divide_upper, H(0, -1), H(0, 3), H(-23, -0x2AAAAA), 0);
    BINARY(divide_upper, H(0, 1), H(0, 1), H(-22, HALF), 0);
    BINARY(divide_upper, H(0, -1), H(0, 1), H(-23, MIN), 0);
    BINARY(divide_upper, H(0, 7), H(0, 3), H(-21, 0x4AAAAA), 0);
    BINARY(divide_upper, H(0, -7), H(0, 3), H(-21, -0x4AAAAB), 0);
    BINARY(divide_upper, H(5, 0), H(2, 3), H(-20, 0), 0);
    BINARY(divide_upper, H(0, MIN), H(0, -1), H(1, HALF), 0);
}

TEST(divide_significant)
{
    BINARY(divide_significant, ONE, MZ, IND, FAULT_FLAGS);
    BINARY(divide_significant, ONE, ONE, ONE, 0);
    BINARY(divide_significant, H(0, 7), H(0, 3), H(0, 2), 0);
    BINARY(divide_significant, H(0, -7), H(0, 3), H(0, -3), 0);
    BINARY(divide_significant, H(0, 0), H(0, 3), MZ, ZERO_FLAG);
    BINARY(divide_significant, H(TOP, MAX), H(-23, HALF), IND, OVERFLOW_FLAGS);
    BINARY(divide_significant, H(BOTTOM, HALF), H(-22, HALF + 1), MZ, ZERO_FLAG);
}

TEST(square_root)
{
    UNARY(square_root, ONE, ONE, 0);
    UNARY(square_root, H(-20, HALF), H(-21, HALF), 0);
    UNARY(square_root, H(-21, HALF), H(-22, 0x5A8279), 0);
    UNARY(square_root, H(0, 9), H(-2, 12), 0);
    UNARY(square_root, H(0, 1), H(0, 1), 0);
    UNARY(square_root, H(BOTTOM, HALF), H(BOTTOM / 2 - 11, HALF), 0);
    UNARY(square_root, H(3, 0), MZ, ZERO_FLAG);
    UNARY(square_root, MZ | ANY, MZ, ZERO_FLAG);
    UNARY(square_root, H(0, -1), IND, ROOT_FLAGS);
    UNARY(square_root, IND | ANY, IND, INDEFINITE_FLAG);
}

/* ---- Parts of a number, sign -------------------------------------------- */

TEST(integer_parts)
{
    UNARY(truncate, H(-1, -5), H(0, -2), 0);
    UNARY(floor, H(-1, -5), H(0, -3), 0);
    UNARY(ceiling, H(-1, 5), H(0, 3), 0);
    UNARY(ceiling, H(-24, MIN), H(0, 0), 0);
    UNARY(floor, H(-24, MIN), H(0, -1), 0);
    UNARY(truncate, H(-23, MIN), H(0, -1), 0);
    UNARY(floor, H(-100, -1), H(0, -1), 0);
    UNARY(floor, H(7, -5), H(7, -5), 0);
    UNARY(truncate, MZ | ANY, MZ | ANY, ZERO_FLAG);
    UNARY(ceiling, IND | ANY, IND | ANY, INDEFINITE_FLAG);
}

TEST(sign)
{
    UNARY(negate, H(3, 5), H(3, -5), 0);
    UNARY(negate, H(3, MIN), H(4, HALF), 0);
    UNARY(negate, H(3, HALF), H(2, MIN), 0);
    UNARY(negate, H(TOP, MIN), IND, OVERFLOW_FLAGS);
    UNARY(negate, H(BOTTOM, HALF), MZ, ZERO_FLAG);
    UNARY(negate, MZ | ANY, MZ, ZERO_FLAG);
    UNARY(absolute, H(3, -5), H(3, 5), 0);
    UNARY(absolute, H(3, MIN), H(4, HALF), 0);
    UNARY(absolute, MZ | H(0, 5), MZ | H(0, 5), ZERO_FLAG);
    UNARY(absolute, IND | ANY, IND, INDEFINITE_FLAG);
}

TEST(exponent_and_pack)
{
    UNARY(exponent, ONE, H(0, -22), 0);
    UNARY(exponent, IND, H(0, 0x70), 0);
    UNARY(exponent, MZ, H(0, -0x80), 0);
    BINARY(pack, H(0, -22), H(9, HALF), ONE, 0);
    BINARY(pack, H(5, 0x1234EA), ONE, ONE, 0);
    BINARY(pack, H(0, 0x80), H(0, -1), MZ | H(0, -1), 0);
}

TEST(adjust)
{
    BINARY(adjust_significance, H(0, 5), H(0, 2), H(-2, 20), 0);
    BINARY(adjust_significance, H(0, 5), IND | H(0, -1), H(1, 2), 0);
    BINARY(adjust_significance, H(0, 5), H(0, 99), H(-20, 5 << 20), 0);
    BINARY(adjust_significance, H(0, 0), H(0, 99), H(-23, 0), 0);
    BINARY(adjust_significance, H(BOTTOM, 1), H(0, 1), MZ, ZERO_FLAG);
    BINARY(adjust_significance, H(TOP, 8), H(0, -1), IND, OVERFLOW_FLAGS);
    BINARY(adjust_significance, MZ | ANY, H(0, 1), MZ, ZERO_FLAG);
    BINARY(adjust_exponent, H(4, 3), H(0, 1), H(1, 24), 0);
    BINARY(adjust_exponent, H(4, -3), H(0, 6), H(6, -1), 0);
    BINARY(adjust_exponent, H(4, 3), IND, H(0, 48), 0);
    BINARY(adjust_exponent, H(21, 2), H(0, 0), H(0, HALF), 0);
    BINARY(adjust_exponent, H(22, 2), H(0, 0), IND, OVERFLOW_FLAGS);
    BINARY(adjust_exponent, H(4, 3), H(0, TOP + 1), IND, OVERFLOW_FLAGS);
    BINARY(adjust_exponent, H(4, 0), H(0, MIN), MZ, ZERO_FLAG);
    BINARY(adjust_exponent, IND | ANY, H(0, 1), IND, INDEFINITE_FLAG);
}

/* ---- Compare, shift ----------------------------------------------------- */

/* Rising values; those of one row are equal. */
static const c205_word ladder[][4] = {
    { H(TOP, MIN), H(TOP, MIN), H(TOP, MIN), H(TOP, MIN) },
    { H(0, MIN), H(1, -HALF), H(23, -1), H(22, -2) },
    { H(0, -2), H(1, -1), H(-22, MIN), H(-21, -HALF) },
    { H(BOTTOM, -1), H(BOTTOM, -1), H(BOTTOM, -1), H(BOTTOM, -1) },
    { MZ, H(TOP, 0), H(BOTTOM, 0), H(-113, -1) },
    { H(BOTTOM, 1), H(BOTTOM, 1), H(BOTTOM, 1), H(BOTTOM, 1) },
    { H(BOTTOM, HALF), H(BOTTOM + 22, 1), H(BOTTOM + 21, 2), H(BOTTOM, HALF) },
    { ONE, H(0, 1), H(-1, 2), H(-21, HALF / 2) },
    { H(-22, HALF + 1), H(-22, HALF + 1), H(-22, HALF + 1), H(-22, HALF + 1) },
    { H(TOP, MAX), H(TOP, MAX), H(TOP, MAX), H(TOP, MAX) },
};

static void compare_steps(size_t i, size_t j)
{
    for (size_t k = 0; k < 16; k++) {
        c205_word a = ladder[i][k / 4], b = ladder[j][k % 4];
        assert_int_equal(half_equal(a, b), i == j);
        assert_int_equal(half_not_equal(a, b), i != j);
        assert_int_equal(half_not_less(a, b), i >= j);
        assert_int_equal(half_less(a, b), i < j);
    }
}

TEST(compare)
{
    size_t steps = COUNT(ladder);

    for (size_t i = 0; i < steps; i++)
        for (size_t j = 0; j < steps; j++)
            compare_steps(i, j);
    assert_false(half_equal(IND, IND));
    assert_true(half_not_equal(IND, IND));
    assert_false(half_not_less(IND, ONE));
    assert_false(half_less(MZ, IND));
}

/* By the coefficient of any half word. */
static c205_word shifted(c205_word a, int64_t count)
{
    uint64_t flags = 0;
    c205_word result = half_shift(a, H(0x71, count), &flags);

    assert_int_equal(flags, 0);
    return result;
}

TEST(shift)
{
    c205_word a = UINT64_C(0x8123456700000000);
    c205_word ones = UINT64_C(0xFFFFFFFF00000000);

    assert_int_equal(shifted(a, 0), a);
    assert_int_equal(shifted(a, 4), UINT64_C(0x1234567800000000));
    assert_int_equal(shifted(a, 31), UINT64_C(0xC091A2B300000000));
    assert_int_equal(shifted(a, 32), a);
    assert_int_equal(shifted(a, 36), UINT64_C(0x1234567800000000));
    assert_int_equal(shifted(a, -4), UINT64_C(0xF812345600000000));
    assert_int_equal(shifted(a, -32), ones);
    assert_int_equal(shifted(a, MIN), ones);
    assert_int_equal(shifted(H(0x70, 1), -32), 0);
}

/* ---- Conversion between the sizes --------------------------------------- */

TEST(contract)
{
    UNARY_GIVES(arith_contract, C205_ONE, ONE, 0);
    UNARY_GIVES(arith_contract, W(0, 0xFFFFFF), H(24, 0), 0);
    UNARY_GIVES(arith_contract, W(0, 0x1000000), H(24, 1), 0);
    UNARY_GIVES(arith_contract, W(0, -1), H(24, -1), 0);
    UNARY_GIVES(arith_contract, W(0, WORD_COEFFICIENT_MAX), H(24, MAX), 0);
    UNARY_GIVES(arith_contract, W(TOP - 24, 1), H(TOP, 0), 0);
    UNARY_GIVES(arith_contract, W(TOP - 23, 0), IND, OVERFLOW_FLAGS);
    UNARY_GIVES(arith_contract, W(BOTTOM - 24, -1), H(BOTTOM, -1), 0);
    UNARY_GIVES(arith_contract, W(BOTTOM - 25, -1), MZ, ZERO_FLAG);
    UNARY_GIVES(arith_contract, MZ | 77, MZ, ZERO_FLAG);
    UNARY_GIVES(arith_contract, IND | 77, IND, INDEFINITE_FLAG);
}

TEST(contract_rounded)
{
    UNARY_GIVES(arith_contract_rounded, C205_ONE, ONE, 0);
    UNARY_GIVES(arith_contract_rounded, W(0, 0x7FFFFF), H(24, 0), 0);
    UNARY_GIVES(arith_contract_rounded, W(0, 0x800000), H(24, 1), 0);
    UNARY_GIVES(arith_contract_rounded, W(0, -0x800000), H(24, 0), 0);
    UNARY_GIVES(arith_contract_rounded, W(0, -0x800001), H(24, -1), 0);
    UNARY_GIVES(arith_contract_rounded, W(0, WORD_COEFFICIENT_MAX), H(25, HALF), 0);
    UNARY_GIVES(arith_contract_rounded, W(TOP - 24, WORD_COEFFICIENT_MAX), IND,
                OVERFLOW_FLAGS);
    UNARY_GIVES(arith_contract_rounded, W(BOTTOM - 25, WORD_COEFFICIENT_MAX),
                H(BOTTOM, HALF), 0);
    UNARY_GIVES(arith_contract_rounded, MZ | 77, MZ, ZERO_FLAG);
    UNARY_GIVES(arith_contract_rounded, IND | 77, IND, INDEFINITE_FLAG);
}

TEST(extend)
{
    UNARY_GIVES(arith_extend, ONE, C205_ONE, 0);
    UNARY_GIVES(arith_extend, H(BOTTOM, -1), W(BOTTOM - 24, -0x1000000), 0);
    UNARY_GIVES(arith_extend, H(TOP, 0), W(TOP - 24, 0), 0);
    UNARY_GIVES(arith_extend, MZ | ANY, MZ, ZERO_FLAG);
    UNARY_GIVES(arith_extend, IND | ANY, IND, INDEFINITE_FLAG);
}

/* ---- Laws --------------------------------------------------------------- */

static c205_word extended(c205_word half)
{
    uint64_t flags = 0;

    return arith_extend(half, &flags);
}

TEST(extended_come_back)
{
    uint64_t seed = RANDOM_SEED, flags = 0;

    for (int i = 0; i < ROUNDS; i++) {
        c205_word a = xorshift_unnormalised_of(half_words, &seed, BOTTOM, TOP);
        c205_word word = extended(a);
        assert_int_equal(arith_contract(word, &flags), a);
        assert_int_equal(arith_contract_rounded(word, &flags), a);
        assert_true(c205_to_double(word) == c205_half_to_double(a));
    }
}

/* All results are floors: of normalised operands, the half result is the
 * longer one cut. */
TEST(half_results_are_cut)
{
    uint64_t seed = RANDOM_SEED, flags = 0;

    for (int i = 0; i < ROUNDS; i++) {
        c205_word a = half_absolute(xorshift_normalised_of(half_words, &seed, -40, 30),
                                    &flags);
        c205_word b = xorshift_normalised_of(half_words, &seed, -40, 30);
        c205_word x = extended(a), y = extended(b);
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
