/* fast_path.h - fast scalar arithmetic on common words (common_range.h).
 *
 * In scalar code each result depends on the previous result, and a branch that is
 * almost never taken costs nothing. The functions therefore test for common words
 * first. All other words go to the exact rule at once. Code on lanes (lane_parts.h)
 * does the opposite and has no branches. Results equal arith.h, bit for bit, for every
 * word.
 */
#ifndef C205_FAST_PATH_H
#define C205_FAST_PATH_H

#include "vm/number/arith.h"
#include "vm/number/common_range.h"

#include <math.h>

static inline c205_word fast_word(int64_t e, int64_t c)
{
    return (c205_word)e << 48 | ((c205_word)c & WORD_COEFFICIENT_MASK);
}

/* Returns c x 2^e, rounded down to the 47 digits of a word. c has 47 to 49 digits. */
static inline c205_word fast_fitted(int64_t e, int64_t c)
{
    int64_t places = (c ^ c >> 63) >> WORD_DIGITS;
    return fast_word(e + places, c >> places);
}

/* ---- Add, subtract ------------------------------------------------------- */

/* Computes the sum with one guard bit below the coefficients. Let the distance be the
 * difference of the exponents. At distances of 0 and 1 no bit is lost. At larger
 * distances normalisation shifts the sum by at most one place. The double-length
 * register holds the whole smaller operand up to a distance of 46. Returns false if the
 * exact rule must compute the sum. */
static inline bool fast_sum(c205_word a, int64_t ca, c205_word b, int64_t cb,
                            c205_word *c)
{
    int64_t e = (int64_t)a >> 48, eb = (int64_t)b >> 48;
    int64_t distance = e - eb;
    int64_t larger = ca, smaller = cb;
    if (distance < 0) {
        e = eb;
        larger = cb;
        smaller = ca;
        distance = -distance;
    }
    int64_t sum = larger + (smaller >> (distance & 63));
    if (distance > 46 || sum == 0)
        return false;
    int32_t places = WORD_DIGITS + 2 - word_significant_bits(sum);
    *c = fast_word(e + 1 - places, word_shift_left(sum, places) >> 2);
    return true;
}

static inline int64_t fast_twice(c205_word w)
{
    return (int64_t)(w << 16) >> 15;
}

static inline c205_word fast_add_normalised(c205_word a, c205_word b, uint64_t *flags)
{
    c205_word c;
    if (common_pair(a, b) && fast_sum(a, fast_twice(a), b, fast_twice(b), &c))
        return c;
    return arith_add_normalised(a, b, flags);
}

/* Subtracts b from a, with a fast path for machine zero minus a word, which negates the
 * word. */
static inline c205_word fast_subtract_normalised(c205_word a, c205_word b,
                                                 uint64_t *flags)
{
    c205_word c;
    if (common_pair(a, b) && fast_sum(a, fast_twice(a), b, -fast_twice(b), &c))
        return c;
    if (a == C205_MACHINE_ZERO && common_word(b)
        && fast_sum(b, -fast_twice(b), b, 0, &c))
        return c;
    return arith_subtract_normalised(a, b, flags);
}

/* ---- Multiply, divide, square root --------------------------------------- */

/* Multiplies a by b. The product of the coefficients has 93 or 94 digits, or is
 * 2^94. */
static inline c205_word fast_multiply_significant(c205_word a, c205_word b,
                                                  uint64_t *flags)
{
    int64_t a1 = (int64_t)(a << 16) >> 40, a0 = a & 0xFFFFFF;
    int64_t b1 = (int64_t)(b << 16) >> 40, b0 = b & 0xFFFFFF;
    int64_t middle = a1 * b0 + a0 * b1 + (a0 * b0 >> 24);
    int64_t product = a1 * b1 * 4 + (middle >> 22);
    int64_t e = ((int64_t)a >> 48) + ((int64_t)b >> 48);
    if (!common_pair(a, b))
        return arith_multiply_significant(a, b, flags);
    return fast_fitted(e + WORD_DIGITS - 1, product);
}

/* Divides a by b. The quotient in double arithmetic is below 2^49 and its error is
 * below 1, so its integer part is off by at most 1. The remainder modulo 2^64 gives the
 * correction. */
static inline c205_word fast_divide_significant(c205_word a, c205_word b,
                                                uint64_t *flags)
{
    int64_t ca = word_coefficient(a), cb = word_coefficient(b);
    int64_t dividend = ca < 0 ? -ca : ca, divisor = cb < 0 ? -cb : cb;
    int64_t e = ((int64_t)a >> 48) - ((int64_t)b >> 48) - WORD_DIGITS;
    if (!common_pair(a, b))
        return arith_divide_significant(a, b, flags);
    int64_t q = (int64_t)((double)dividend * 0x1p47 / (double)divisor);
    int64_t left = (int64_t)(((uint64_t)dividend << WORD_DIGITS)
                             - (uint64_t)q * (uint64_t)divisor);
    q += (left >= divisor) - (left < 0);
    /* The exact rule computes this quotient, because its negative is not normalised. */
    if (q == INT64_C(1) << 46)
        return arith_divide_significant(a, b, flags);
    return fast_fitted(e, (ca ^ cb) < 0 ? -q : q);
}

/* Returns the square root. The root in double arithmetic is below 2^47 and at most 1
 * too large. The sign of the remainder modulo 2^64 gives the correction. */
static inline c205_word fast_square_root(c205_word a, uint64_t *flags)
{
    int64_t c = word_coefficient(a), e = (int64_t)a >> 48;
    int32_t k = WORD_DIGITS - 1 + (int32_t)(e & 1);
    if (!common_word(a) || c < 0)
        return arith_square_root(a, flags);
    uint64_t root = (uint64_t)(int64_t)sqrt((double)c * (e & 1 ? 0x1p47 : 0x1p46));
    uint64_t left = ((uint64_t)c << k) - root * root;
    return fast_word((e - k) / 2, (int64_t)(root - (left >> 63)));
}

/* ---- Compare ------------------------------------------------------------- */

/* Returns an integer that orders words of one sign as their values. For negative words,
 * a larger exponent is a smaller value. */
static inline int64_t fast_rank(c205_word w, int64_t sign)
{
    return (int64_t)(w ^ ((uint64_t)sign & ~WORD_COEFFICIENT_MASK));
}

/* Sets ranks that compare as the values do. Returns false unless a is common and b is
 * common or machine zero. Machine zero is the most frequent special operand. */
static inline bool fast_ranks(c205_word a, c205_word b, int64_t *rank_a,
                              int64_t *rank_b)
{
    int64_t sign = (int64_t)(a << 16) >> 63;
    *rank_a = sign | 1;
    *rank_b = 0;
    if (b == C205_MACHINE_ZERO && common_word(a))
        return true;
    if (!common_pair(a, b))
        return false;
    if ((int64_t)((a ^ b) << 16) < 0)
        return true;
    *rank_a = fast_rank(a, sign);
    *rank_b = fast_rank(b, sign);
    return true;
}

#define FAST_RELATION(name, relation) \
    static inline bool fast_##name(c205_word a, c205_word b) \
    { \
        int64_t rank_a, rank_b; \
        return fast_ranks(a, b, &rank_a, &rank_b) ? rank_a relation rank_b \
                                                  : arith_##name(a, b); \
    }

FAST_RELATION(equal, ==)
FAST_RELATION(not_equal, !=)
FAST_RELATION(not_less, >=)
FAST_RELATION(less, <)

#endif
