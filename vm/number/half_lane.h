/* half_lane.h - the arithmetic of half words on one lane; see lane_parts.h.
 *
 * The exact results of half words fit 64 bits. Each function is therefore correct for
 * all numbers and machine zeros, normalised or not.
 */
#ifndef C205_HALF_LANE_H
#define C205_HALF_LANE_H

#define LANE_FORMAT half_words
#define LANE_GUARD 23
#include "vm/number/lane_parts.h"

/* Returns the coefficient that arithmetic uses: 0 for a machine zero. */
static inline int64_t value(c205_word w)
{
    return is_zero(w) ? 0 : coefficient(w);
}

/* Returns the low DIGITS bits of t with exponent e. */
static inline lane lower(int64_t e, int64_t t)
{
    return number(e, t & ((INT64_C(1) << DIGITS) - 1));
}

/* ---- Add, subtract ------------------------------------------------------ */

/* Returns the lower sum of a and b, whose double-length sum is t. A t of more than 47
 * bits loses its last bit. */
static inline lane sum_lower(c205_word a, c205_word b, int64_t t)
{
    c205_word l = max_word(a, b);
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

/* Returns the smaller number of significant bits of two coefficients, but at least
 * 1. */
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

/* Returns the floor of a positive number that is not an integer. */
static inline int64_t below(double d)
{
    return (int64_t)to_nearest(d + 0.5) - 1;
}

/* Returns trunc(ca x 2^23 / cb). The function adds half a unit, so the dividend is not
 * a multiple of the divisor. The quotient then differs from every integer by at least
 * half of 1 / cb, which exceeds the error of a double. */
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

/* Returns `result`, or machine zero if a is machine zero. Marks the quotient as odd,
 * for the exact rule, if an operand is indefinite or the divisor has the value 0, which
 * is a divide fault. */
static inline lane special_quotient(c205_word a, c205_word b, lane result)
{
    uint64_t without_digits = magnitude(coefficient(b)) - 1;
    return odd_if(without_digits | zero(b) | indefinite(max_word(a, b)),
                  zero_if(is_zero(a), result));
}

/* Divides a by b. A quotient of more than DIGITS bits is shortened to DIGITS bits. */
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

/* Returns floor(sqrt(n)) for n < 2^46. The function adds half a unit to n, so the root
 * differs from every integer by at least 2^-25. */
static inline int64_t root(uint64_t n)
{
    return below(sqrt(to_double(n) + 0.5));
}

/* Returns the square root. The coefficient is first shifted left to normalise it, and
 * the root is then shifted back by the same number of places. */
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

/* Adds a rounding term to the coefficient of a word, then contracts it to a half
 * word. */
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

/* Extends a half word. The exponent of a word is 8 bits longer, so the digits move 8
 * places to the right. */
static inline lane lane_extend(c205_word a)
{
    c205_word digits = (a & ~EXPONENT_MASK) >> 8;
    const lane result = { (c205_word)(exponent(a) - MORE_DIGITS) << 48 | digits, 0 };
    return special_product(a, a, result);
}

#endif
