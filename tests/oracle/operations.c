#include "operations.h"

#include "vm/number/lanes.h"

#include <string.h>

void spread_bits(c205_word *words, const uint64_t *bits, size_t n)
{
    for (size_t i = 0; i < n; i++)
        words[i] = bits[i / 64] >> (63 - i % 64) & 1;
}

static bool rest_is_zero(const uint64_t *bits, size_t n)
{
    return n % 64 == 0 || bits[n / 64] << n % 64 == 0;
}

/* ---- How the functions of the machine are called ------------------------ */

/* By kind, all brought to the signatures of scalar_rule and span_rule.
 * scalar, span: what the names of a size begin with in arith.h and lanes.h:
 * arith and lanes, half and halves. */
#define ADAPT_BINARY(scalar, span, name) \
    static c205_word call_##scalar##_##name(c205_word a, c205_word b, \
                                            uint64_t *flags) \
    { \
        return scalar##_##name(a, b, flags); \
    } \
    ADAPT_SPAN(scalar, span, name)
#define ADAPT_SPAN(scalar, span, name) \
    static void call_##span##_##name(c205_word *c, const c205_word *a, \
                                     const c205_word *b, size_t n, \
                                     uint64_t *flags) \
    { \
        span##_##name(c, a, b, n, flags); \
    }
#define ADAPT_UNARY(scalar, span, name) \
    static c205_word call_##scalar##_##name(c205_word a, c205_word b, \
                                            uint64_t *flags) \
    { \
        (void)b; \
        return scalar##_##name(a, flags); \
    } \
    ADAPT_UNARY_SPAN(scalar, span, name)
#define ADAPT_UNARY_SPAN(scalar, span, name) \
    static void call_##span##_##name(c205_word *c, const c205_word *a, \
                                     const c205_word *b, size_t n, \
                                     uint64_t *flags) \
    { \
        (void)b; \
        span##_##name(c, a, n, flags); \
    }
/* A bitmap with bits past its end spoils the flags, which comparisons do
 * not touch. */
#define ADAPT_COMPARE(scalar, span, name) \
    static c205_word call_##scalar##_##name(c205_word a, c205_word b, \
                                            uint64_t *flags) \
    { \
        (void)flags; \
        return scalar##_##name(a, b); \
    } \
    static void call_##span##_##name(c205_word *c, const c205_word *a, \
                                     const c205_word *b, size_t n, \
                                     uint64_t *flags) \
    { \
        uint64_t bits[BITMAP]; \
\
        memset(bits, 0xA5, sizeof bits); \
        span##_##name(bits, a, b, n); \
        spread_bits(c, bits, n); \
        if (!rest_is_zero(bits, n)) \
            *flags = 0; \
    }

/* ---- The operations ----------------------------------------------------- */

/* SPAN and UNARY_SPAN have no counterpart in arith.h. */
#define OPERATIONS(BINARY, UNARY, COMPARE, SPAN_ONLY, scalar, span) \
    BINARY(scalar, span, add_upper) \
    BINARY(scalar, span, add_lower) \
    BINARY(scalar, span, add_normalised) \
    BINARY(scalar, span, subtract_upper) \
    BINARY(scalar, span, subtract_lower) \
    BINARY(scalar, span, subtract_normalised) \
    BINARY(scalar, span, multiply_upper) \
    BINARY(scalar, span, multiply_lower) \
    BINARY(scalar, span, multiply_significant) \
    BINARY(scalar, span, divide_upper) \
    BINARY(scalar, span, divide_significant) \
    UNARY(scalar, span, square_root) \
    UNARY(scalar, span, truncate) \
    UNARY(scalar, span, floor) \
    UNARY(scalar, span, ceiling) \
    UNARY(scalar, span, absolute) \
    UNARY(scalar, span, negate) \
    UNARY(scalar, span, exponent) \
    BINARY(scalar, span, adjust_significance) \
    BINARY(scalar, span, adjust_exponent) \
    BINARY(scalar, span, pack) \
    BINARY(scalar, span, average) \
    BINARY(scalar, span, average_difference) \
    COMPARE(scalar, span, equal) \
    COMPARE(scalar, span, not_equal) \
    COMPARE(scalar, span, not_less) \
    COMPARE(scalar, span, less) \
    SPAN_ONLY(scalar, span, xor) \
    SPAN_ONLY(scalar, span, and) \
    SPAN_ONLY(scalar, span, or) \
    SPAN_ONLY(scalar, span, nand) \
    SPAN_ONLY(scalar, span, nor) \
    SPAN_ONLY(scalar, span, or_not) \
    SPAN_ONLY(scalar, span, and_not) \
    SPAN_ONLY(scalar, span, equivalence) \
    SPAN_ONLY(scalar, span, add_index) \
    SPAN_ONLY(scalar, span, subtract_index)

OPERATIONS(ADAPT_BINARY, ADAPT_UNARY, ADAPT_COMPARE, ADAPT_SPAN, arith, lanes)
OPERATIONS(ADAPT_BINARY, ADAPT_UNARY, ADAPT_COMPARE, ADAPT_SPAN, half, halves)
ADAPT_UNARY(arith, lanes, contract)
ADAPT_UNARY(arith, lanes, contract_rounded)
ADAPT_UNARY(arith, lanes, extend)
ADAPT_UNARY_SPAN(arith, lanes, copy)
ADAPT_SPAN(arith, lanes, shift)
ADAPT_SPAN(half, halves, shift)

/* The count of a shift: the coefficient of b, taken as an integer. */
static c205_word call_arith_shift(c205_word a, c205_word b, uint64_t *flags)
{
    (void)flags;
    return arith_shift(a, c205_to_integer(b));
}

static c205_word call_half_shift(c205_word a, c205_word b, uint64_t *flags)
{
    const int64_t low = (int64_t)(b << 8 >> 40);

    (void)flags;
    return half_shift(a, low >= 1 << 23 ? low - (1 << 24) : low);
}

#define ROW(scalar, span, name) \
    { #name, &oracle_full, oracle_##name, call_##scalar##_##name, \
      call_##span##_##name },
#define SPAN_ROW(scalar, span, name) \
    { #name, &oracle_full, oracle_##name, NULL, call_##span##_##name },
#define HALF_ROW(scalar, span, name) \
    { "half_" #name, &oracle_half, oracle_##name, call_##scalar##_##name, \
      call_##span##_##name },
#define HALF_SPAN_ROW(scalar, span, name) \
    { "half_" #name, &oracle_half, oracle_##name, NULL, \
      call_##span##_##name },

/* clang-format off */
const struct operation operations[] = {
    OPERATIONS(ROW, ROW, ROW, SPAN_ROW, arith, lanes)
    ROW(arith, lanes, shift)
    SPAN_ROW(arith, lanes, copy)
    ROW(arith, lanes, contract)
    ROW(arith, lanes, contract_rounded)
    { "extend", &oracle_half, oracle_extend, call_arith_extend,
      call_lanes_extend },
    OPERATIONS(HALF_ROW, HALF_ROW, HALF_ROW, HALF_SPAN_ROW, half, halves)
    HALF_ROW(half, halves, shift)
};
/* clang-format on */

const size_t operation_count = sizeof operations / sizeof operations[0];

const struct reduction reductions[] = {
    { "sum", &oracle_full, oracle_add_normalised, lanes_sum },
    { "product", &oracle_full, oracle_multiply_significant, lanes_product },
    { "half_sum", &oracle_half, oracle_add_normalised, halves_sum },
    { "half_product", &oracle_half, oracle_multiply_significant,
      halves_product },
};

const size_t reduction_count = sizeof reductions / sizeof reductions[0];
