/* lane.h - arithmetic of words of 64 bits on one lane (lane_parts.h). */
#ifndef C205_LANE_H
#define C205_LANE_H

#define LANE_FORMAT whole_words
#define LANE_GUARD 1
#include "vm/number/lane_parts.h"
#include "vm/number/common_range.h"

/* ---- Multiply ----------------------------------------------------------- */

/* Returns floor(ca x cb / 2^(48 - keep)), computed from halves of 24 bits. */
static inline int64_t product(c205_word a, c205_word b, int keep)
{
    int64_t a1 = (int64_t)(a << 16) >> 40, a0 = a & 0xFFFFFF;
    int64_t b1 = (int64_t)(b << 16) >> 40, b0 = b & 0xFFFFFF;
    int64_t middle = a1 * b0 + a0 * b1 + (a0 * b0 >> 24);
    return (int64_t)((uint64_t)(a1 * b1) << keep) + (middle >> (24 - keep));
}

static inline lane lane_multiply_upper(c205_word a, c205_word b)
{
    int64_t e = exponent(a) + exponent(b) + WORD_DIGITS;
    return special_product(a, b, fitted(e, product(a, b, 1)));
}

/* Returns a word whose first bit is 1 if at least one of the two coefficients is not
 * normalised. */
static inline uint64_t either_unnormalised(c205_word a, c205_word b)
{
    return ~((a ^ a << 1) & (b ^ b << 1)) << (63 - WORD_DIGITS);
}

/* Return a word whose first bit is 1 if the exponent is 2000 hex or more (is_large), or
 * less than -2000 hex (is_small). If neither holds for two exponents, their sum is in
 * the range. */
static inline uint64_t is_large(c205_word w)
{
    return ~w & (w + UINT64_C(0x6000000000000000));
}

static inline uint64_t is_small(c205_word w)
{
    return w + UINT64_C(0x2000000000000000);
}

/* Multiplies a by b. The product of normalised coefficients is in 2^92 .. 2^94, or
 * below -2^92. */
static inline lane lane_multiply_significant(c205_word a, c205_word b)
{
    c205_word l = max_word(a, b), s = min_word(a, b);
    int64_t e = exponent(a) + exponent(b) + (WORD_DIGITS - 1);
    int64_t p = product(a, b, 2);
    uint64_t places = excess(p, DIGITS);
    c205_word high = (c205_word)(e + (int64_t)places) << EXPONENT_PLACE;
    const lane result = { high | integer((int64_t)((uint64_t)p >> places)),
                          either_unnormalised(a, b) | is_small(s) };
    return odd_if(is_large(l), zero_if(is_zero(s), result));
}

/* ---- Divide, square root ------------------------------------------------ */

/* Returns trunc(ca x 2^47 / cb). The quotient in double arithmetic is below 2^49, and
 * its error is below 1/8. The nearest integer may therefore be 1 too large; the sign of
 * the remainder modulo 2^64 shows this. */
static inline int64_t quotient(int64_t ca, int64_t cb)
{
    uint64_t dividend = magnitude(ca), divisor = magnitude(cb);
    double scale = (double)(INT64_C(1) << WORD_DIGITS);
    uint64_t nearest = to_nearest(to_double(dividend) * scale / to_double(divisor));
    uint64_t remainder = (dividend << WORD_DIGITS) - nearest * divisor;
    int64_t q = (int64_t)(nearest - (remainder >> 63));
    return (ca ^ cb) < 0 ? -q : q;
}

static inline lane lane_divide_significant(c205_word a, c205_word b)
{
    int64_t e = exponent(a) - exponent(b) - WORD_DIGITS;
    int64_t q = quotient(coefficient(a), coefficient(b));
    lane result = odd_if(unnormalised(a), normalised(e, q));
    return odd_if(unnormalised(b) | zero(b) | indefinite(max_word(a, b)),
                  zero_if(is_zero(a), result));
}

/* Returns floor(2^23 sqrt(radicand / 2^46)). The nearest integer may be 1 too large;
 * the sign of the remainder modulo 2^64 shows this. */
static inline int64_t root(uint64_t radicand)
{
    uint64_t nearest = to_nearest(sqrt(to_double(radicand)) * (1 << 23));
    uint64_t remainder = (radicand << 46) - nearest * nearest;
    return (int64_t)(nearest - (remainder >> 63));
}

/* Returns floor(sqrt(c x 2^k)) for the coefficient c of a, with k = 46 for even
 * exponents and k = 47 for odd exponents. */
static inline lane lane_square_root(c205_word a)
{
    uint64_t digits = a & WORD_COEFFICIENT_MASK;
    bool is_even = (a >> EXPONENT_PLACE & 1) == 0;
    int64_t r = root(is_even ? digits : digits << 1);
    lane result = number((exponent(a) >> 1) - 23, r);
    uint64_t negative = a << 16;
    return zero_if(is_zero(a),
                   odd_if(unnormalised(a) | negative | indefinite(a), result));
}

/* ---- Common words ----------------------------------------------------------
 *
 * If both operands are common (common_range.h), no special case can occur and the
 * result is in the range. These functions test nothing.
 */

/* Returns the product. The exponents are added in place, without extracting them. */
static inline c205_word common_multiply_significant(c205_word a, c205_word b)
{
    int64_t p = product(a, b, 2);
    uint64_t places = excess(p, DIGITS);
    c205_word high = a + (b & EXPONENT_MASK)
                     + ((places + (WORD_DIGITS - 1)) << EXPONENT_PLACE);
    return format_with_coefficient(LANE_FORMAT, high, (c205_word)p >> places);
}

static inline c205_word common_divide_significant(c205_word a, c205_word b)
{
    int64_t e = exponent(a) - exponent(b) - WORD_DIGITS;
    return significant(e, quotient(coefficient(a), coefficient(b)), DIGITS).word;
}

#endif
