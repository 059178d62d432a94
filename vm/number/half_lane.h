/* half_lane.h - the arithmetic of half words on one lane; see lane_parts.h.
 *
 * Exact results of half words fit 64 bits: each function is right for all
 * numbers and machine zeros, also where they are not normalised.
 */
#ifndef C205_HALF_LANE_H
#define C205_HALF_LANE_H

#define LANE_FORMAT half_words
#define LANE_GUARD 23
#include "vm/number/lane_parts.h"

/* As it counts in arithmetic. */
static inline int64_t value(c205_word w)
{
    return is_zero(w) ? 0 : coefficient(w);
}

/* The low part of t x 2^e. */
static inline lane lower(int64_t e, int64_t t)
{
    return number(e, t & ((INT64_C(1) << DIGITS) - 1));
}

/* ---- Add, subtract ------------------------------------------------------ */

/* A sum of more than 47 bits loses the last one. */
static inline lane sum_lower(c205_word a, c205_word b, int64_t t)
{
    c205_word l = larger(a, b);
    int64_t e = exponent(l) - DIGITS;
    uint64_t places = excess(t, 2 * DIGITS);

    return odd_if(indefinite(l),
                  zero_if(is_zero(l), lower(e + (int64_t)places, t >> places)));
}

static inline lane lane_add_lower(c205_word a, c205_word b)
{
    return sum_lower(a, b, sum(a, b));
}

static inline lane lane_subtract_lower(c205_word a, c205_word b)
{
    return sum_lower(a, b, difference(a, b));
}

/* ---- Multiply ----------------------------------------------------------- */

/* Significant bits of the less significant of two coefficients, but at least
 * one. */
static inline int64_t least_significance(int64_t ca, int64_t cb)
{
    int64_t ma = ca ^ ca >> 63, mb = cb ^ cb >> 63;

    return LENGTH - (int64_t)room((ma < mb ? ma : mb) | 1);
}

static inline int64_t product(c205_word a, c205_word b)
{
    return coefficient(a) * coefficient(b);
}

static inline lane lane_multiply_upper(c205_word a, c205_word b)
{
    int64_t e = exponent(a) + exponent(b) + DIGITS;

    return special_product(a, b, fitted(e, product(a, b) >> DIGITS));
}

static inline lane lane_multiply_lower(c205_word a, c205_word b)
{
    return special_product(a, b, lower(exponent(a) + exponent(b), product(a, b)));
}

static inline lane lane_multiply_significant(c205_word a, c205_word b)
{
    int64_t e = exponent(a) + exponent(b), p = product(a, b);
    int64_t bits = least_significance(coefficient(a), coefficient(b));

    return special_product(a, b, zero_if(p == 0, significant(e, p, bits)));
}

/* ---- Divide, square root ------------------------------------------------ */

/* The floor of a positive number that is not an integer. */
static inline int64_t below(double d)
{
    return (int64_t)to_nearest(d + 0.5) - 1;
}

/* trunc(ca x 2^23 / cb).  With half a unit more, the dividend is no multiple
 * of the divisor, and the quotient differs from all integers by the half of
 * 1 / cb or more, which is more than a double errs. */
static inline int64_t quotient(int64_t ca, int64_t cb)
{
    double dividend = to_double(magnitude(ca) << DIGITS) + 0.5;
    int64_t q = below(dividend / to_double(magnitude(cb)));

    return (ca ^ cb) < 0 ? -q : q;
}

static inline int64_t quotient_exponent(c205_word a, c205_word b)
{
    return exponent(a) - exponent(b) - DIGITS;
}

/* The divisor 0, as number or machine zero, is at fault. */
static inline lane special_quotient(c205_word a, c205_word b, lane result)
{
    uint64_t without_digits = magnitude(coefficient(b)) - 1;

    return odd_if(without_digits | zero(b) | indefinite(larger(a, b)),
                  zero_if(is_zero(a), result));
}

/* Shortened where it is too long. */
static inline lane lane_divide_upper(c205_word a, c205_word b)
{
    int64_t q = quotient(coefficient(a), coefficient(b));
    int64_t bits = LENGTH - (int64_t)room(q);

    return special_quotient(a, b,
                            significant(quotient_exponent(a, b), q,
                                        bits < DIGITS ? bits : DIGITS));
}

static inline lane lane_divide_significant(c205_word a, c205_word b)
{
    int64_t ca = coefficient(a), cb = coefficient(b);
    int64_t e = quotient_exponent(a, b), q = quotient(ca, cb);
    int64_t bits = least_significance(ca, cb);

    return special_quotient(a, b, zero_if(q == 0, significant(e, q, bits)));
}

/* floor(sqrt(n)), n < 2^46: with half a unit more, the root differs from all
 * integers by 2^-25 or more. */
static inline int64_t root(uint64_t n)
{
    return below(sqrt(to_double(n) + 0.5));
}

/* The root of the normalised operand, shifted back. */
static inline lane lane_square_root(c205_word a)
{
    int64_t c = value(a);
    int64_t places = (int64_t)room(c) - (LENGTH - DIGITS);
    int64_t e = exponent(a) - places;
    int64_t k = DIGITS - 1 + (e & 1);
    int64_t r = root((uint64_t)c << (places + k));
    lane result = number(((e - k) >> 1) + places, r >> places);

    return odd_if((uint64_t)c | indefinite(a), zero_if(c == 0, result));
}

/* ---- Conversion between the sizes --------------------------------------- */

enum { MORE_DIGITS = 24 };

/* From a sum of the coefficient and what rounds it. */
static inline lane contracted(c205_word a, int64_t rounding)
{
    int64_t e = word_exponent(a) + MORE_DIGITS;
    int64_t c = (word_coefficient(a) + rounding) >> MORE_DIGITS;

    return special_product(a, a, fitted(e, c));
}

static inline lane lane_contract(c205_word a)
{
    return contracted(a, 0);
}

static inline lane lane_contract_rounded(c205_word a)
{
    return contracted(a, INT64_C(1) << (MORE_DIGITS - 1));
}

/* As many bits as the exponent is longer, the digits move to the right. */
static inline lane lane_extend(c205_word a)
{
    c205_word digits = (a & ~EXPONENT_MASK) >> 8;
    const lane result = { (c205_word)(exponent(a) - MORE_DIGITS) << 48 | digits, 0 };

    return special_product(a, a, result);
}

#endif
