/* lane.h - the arithmetic of arith.h on one lane, without branches, for
 * loops that a compiler vectorises.
 *
 * Each function is right for the usual operands and results (normalised
 * numbers and machine zeros, within the range), and tells when it is not.
 * It keeps to what vector units have for 64-bit integers.  Words are also
 * compared as integers with a sign: first come the machine zeros, then the
 * numbers by their exponents, last the indefinite.
 */
#ifndef C205_LANE_H
#define C205_LANE_H

#include "word.h"

enum {
    EXPONENT_PLACE = 48,
    GUARD = 1 /* bit kept below the coefficient of the larger operand */
};
#define EXPONENT_MASK (~WORD_COEFFICIENT_MASK)
#define LEAST_NUMBER UINT64_C(0x9000000000000000)

/* A result, unless the first bit of odd is 1. */
typedef struct lane {
    c205_word word;
    uint64_t odd;
} lane;

/* ---- The parts of a word ------------------------------------------------ */

static inline bool is_zero(c205_word w)
{
    return (int64_t)w < (int64_t)LEAST_NUMBER;
}

static inline int64_t exponent(c205_word w)
{
    return (int64_t)w >> EXPONENT_PLACE;
}

static inline int64_t coefficient(c205_word w)
{
    return (int64_t)(w << 16) >> 16;
}

/* c x 2^GUARD as it counts in arithmetic */
static inline int64_t guarded(c205_word w)
{
    return is_zero(w) ? 0 : (int64_t)(w << 16) >> (16 - GUARD);
}

/* ---- Kinds of words, in the first bit: 1, it is ---------------------------
 *
 * Made of arithmetic and not of comparisons, which a compiler would mix with
 * those of the result.
 */

/* 8000 to 8FFF: the words of sign 1 that fall below 9000 and borrow. */
static inline uint64_t zero(c205_word w)
{
    return w & (w - LEAST_NUMBER);
}

/* 7000 to 7FFF: the words of sign 0 that carry into it. */
static inline uint64_t indefinite(c205_word w)
{
    return ~w & (w + UINT64_C(0x1000000000000000));
}

/* A coefficient that is not normalised, whatever the exponent. */
static inline uint64_t unnormalised(c205_word w)
{
    const uint64_t digits = w << 16;

    return ~(digits ^ digits << 1);
}

static inline uint64_t out_of_range(int64_t e)
{
    return (uint64_t)((WORD_EXPONENT_MAX - e) | (e - WORD_EXPONENT_MIN));
}

/* ---- Doubles and their bits --------------------------------------------- */

static const uint64_t two_to_52 = UINT64_C(0x4330000000000000);

static inline double double_of_bits(uint64_t bits)
{
    double d;

    memcpy(&d, &bits, sizeof d);
    return d;
}

static inline uint64_t bits_of_double(double d)
{
    uint64_t bits;

    memcpy(&bits, &d, sizeof bits);
    return bits;
}

/* Between natural numbers below 2^51 and doubles, to the nearest number: as
 * the last bits of 2^52 + n. */
static inline double to_double(uint64_t n)
{
    return double_of_bits(two_to_52 | n) - double_of_bits(two_to_52);
}

static inline uint64_t to_nearest(double d)
{
    return bits_of_double(d + double_of_bits(two_to_52))
           & ((UINT64_C(1) << 51) - 1);
}

/* ---- Results ------------------------------------------------------------ */

static inline lane number(int64_t e, int64_t c)
{
    const lane result = {
        (c205_word)e << EXPONENT_PLACE
            | ((c205_word)c & WORD_COEFFICIENT_MASK),
        out_of_range(e)
    };

    return result;
}

/* A machine zero is as good a result as any. */
static inline lane zero_if(bool it_is, lane otherwise)
{
    const lane result = {it_is ? C205_MACHINE_ZERO : otherwise.word,
                         it_is ? 0 : otherwise.odd};

    return result;
}

static inline lane odd_if(uint64_t odd, lane result)
{
    result.odd |= odd;
    return result;
}

/* The number t x 2^e, |t| < 2^51, floored to a normalised word; zero is
 * machine zero.  The length of t is found as in word_bit_length, as the
 * exponent of an odd number, here subtracted while still in its place. */
static inline lane normalised(int64_t e, int64_t t)
{
    enum { LENGTH = 51, ROOM = LENGTH - WORD_DIGITS, BIAS = 1023 };
    const uint64_t bits
        = bits_of_double(to_double((uint64_t)(t ^ t >> 63) << 1 | 1));
    const uint64_t places
        = (((uint64_t)(BIAS + LENGTH + 1) << 52) - 1 - bits) >> 52;
    const int64_t top = (int64_t)((uint64_t)t << places);

    return zero_if(t == 0, number(e + ROOM - (int64_t)places, top >> ROOM));
}

/* t x 2^e with |t| <= 2^48, one place to the right if it must. */
static inline lane fitted(int64_t e, int64_t t)
{
    const bool fits = (uint64_t)(t - WORD_COEFFICIENT_MIN) >> 48 == 0;

    return number(fits ? e : e + 1, fits ? t : t >> 1);
}

/* ---- Add, subtract ------------------------------------------------------ */

/* The operand of the larger exponent is one of those not smaller. */
static inline c205_word larger(c205_word a, c205_word b)
{
    return (int64_t)a < (int64_t)b ? b : a;
}

static inline c205_word smaller(c205_word a, c205_word b)
{
    return (int64_t)a < (int64_t)b ? a : b;
}

static inline uint64_t distance(c205_word a, c205_word b)
{
    return (larger(a, b) & EXPONENT_MASK) - (smaller(a, b) & EXPONENT_MASK);
}

/* c shifted right by a distance of exponents, but limit at the most. */
static inline int64_t shifted(int64_t c, uint64_t places, uint64_t limit)
{
    const uint64_t most = limit << EXPONENT_PLACE;

    return c >> ((places < most ? places : most) >> EXPONENT_PLACE);
}

/* The sum, floored to GUARD bits below the larger operand's coefficient.
 * That is all a normalised result can see if the larger operand is
 * normalised: at distances of 0 and 1 nothing is lost, and beyond them the
 * sum moves by one place at most. */
static inline int64_t sum(c205_word a, c205_word b)
{
    return guarded(larger(a, b))
           + shifted(guarded(smaller(a, b)), distance(a, b), 63);
}

/* The difference likewise.  A subtrahend is cut at the end of the register,
 * 47 bits down, before its sign changes. */
static inline int64_t difference(c205_word a, c205_word b)
{
    enum { REACH = WORD_DIGITS - GUARD };
    const int64_t l = guarded(larger(a, b)), s = guarded(smaller(a, b));
    const uint64_t places = distance(a, b);
    const uint64_t reach = (uint64_t)REACH << EXPONENT_PLACE;
    const uint64_t beyond = places < reach ? 0 : places - reach;
    const int64_t kept = shifted(s, beyond, 63);
    const bool is_subtrahend = (int64_t)b <= (int64_t)a;

    return (is_subtrahend ? l : -l)
           + shifted(is_subtrahend ? -kept : kept, places, REACH);
}

/* The exponent of an indefinite is out of range. */
static inline lane sum_upper(c205_word a, c205_word b, int64_t t)
{
    const c205_word l = larger(a, b);

    return zero_if(is_zero(l), fitted(exponent(l), t >> GUARD));
}

/* Less certain here, where it may fall: the indefinite are the largest
 * words. */
static inline lane sum_normalised(c205_word a, c205_word b, int64_t t)
{
    const c205_word l = larger(a, b);

    return odd_if(indefinite(l) | (unnormalised(l) & ~zero(l)),
                  normalised(exponent(l) - GUARD, t));
}

static inline lane lane_add_upper(c205_word a, c205_word b)
{
    return sum_upper(a, b, sum(a, b));
}

static inline lane lane_subtract_upper(c205_word a, c205_word b)
{
    return sum_upper(a, b, difference(a, b));
}

static inline lane lane_add_normalised(c205_word a, c205_word b)
{
    return sum_normalised(a, b, sum(a, b));
}

static inline lane lane_subtract_normalised(c205_word a, c205_word b)
{
    return sum_normalised(a, b, difference(a, b));
}

static inline lane halved(lane sum)
{
    const uint64_t is_number = ~zero(sum.word) >> 63;

    sum.word -= is_number << EXPONENT_PLACE;
    sum.odd |= zero(sum.word) & (0 - is_number);
    return sum;
}

static inline lane lane_average(c205_word a, c205_word b)
{
    return halved(lane_add_normalised(a, b));
}

static inline lane lane_average_difference(c205_word a, c205_word b)
{
    return halved(lane_subtract_normalised(a, b));
}

/* ---- Multiply ----------------------------------------------------------- */

/* floor(ca x cb / 2^(48 - keep)), by halves of 24 bits. */
static inline int64_t product(c205_word a, c205_word b, int keep)
{
    const int64_t a1 = (int64_t)(a << 16) >> 40, a0 = a & 0xFFFFFF;
    const int64_t b1 = (int64_t)(b << 16) >> 40, b0 = b & 0xFFFFFF;
    const int64_t middle = a1 * b0 + a0 * b1 + (a0 * b0 >> 24);

    return (int64_t)((uint64_t)(a1 * b1) << keep) + (middle >> (24 - keep));
}

/* Machine zeros are the smallest words. */
static inline lane lane_multiply_upper(c205_word a, c205_word b)
{
    const int64_t e = exponent(a) + exponent(b) + WORD_DIGITS;

    return odd_if(indefinite(larger(a, b)),
                  zero_if(is_zero(smaller(a, b)),
                          fitted(e, product(a, b, 1))));
}

/* The product of normalised operands lies in 2^92 .. 2^94, or below -2^92: of
 * its floor / 2^46 one place at most is too many, but for -2^47 x -2^47. */
static inline lane lane_multiply_significant(c205_word a, c205_word b)
{
    const int64_t e = exponent(a) + exponent(b) + (WORD_DIGITS - 1);
    const int64_t p = product(a, b, 2);
    const uint64_t too_long = (uint64_t)((INT64_C(1) << 48) - 1 - p);
    const lane result
        = odd_if(unnormalised(a) | unnormalised(b) | too_long, fitted(e, p));

    return odd_if(indefinite(larger(a, b)),
                  zero_if(is_zero(smaller(a, b)), result));
}

/* ---- Divide, square root ------------------------------------------------ */

static inline uint64_t magnitude(int64_t c)
{
    return (uint64_t)(c < 0 ? -c : c);
}

/* The double quotient, below 2^49, lies within 1/8 of the true one, so that
 * the nearest integer is the floor or one more; the remainder, known modulo
 * 2^64, tells. */
static inline int64_t quotient(int64_t ca, int64_t cb)
{
    const uint64_t dividend = magnitude(ca), divisor = magnitude(cb);
    const double scale = (double)(INT64_C(1) << WORD_DIGITS);
    const uint64_t nearest
        = to_nearest(to_double(dividend) * scale / to_double(divisor));
    const uint64_t remainder
        = (dividend << WORD_DIGITS) - nearest * divisor;
    const int64_t q = (int64_t)(nearest - (remainder >> 63));

    return (ca ^ cb) < 0 ? -q : q;
}

static inline lane lane_divide_significant(c205_word a, c205_word b)
{
    const int64_t e = exponent(a) - exponent(b) - WORD_DIGITS;
    const int64_t q = quotient(coefficient(a), coefficient(b));
    const lane result = odd_if(unnormalised(a), normalised(e, q));

    return odd_if(unnormalised(b) | zero(b) | indefinite(larger(a, b)),
                  zero_if(is_zero(a), result));
}

/* 1 / sqrt(x) to 15 digits: halving the exponent of a double gives the first
 * digit (to 3.5 %), and each step of Newton's doubles the digits. */
static inline double reciprocal_root(double x)
{
    const uint64_t one_and_a_half_exponents = UINT64_C(0x5FE6EB50C7B537A9);
    double y = double_of_bits(one_and_a_half_exponents
                              - (bits_of_double(x) >> 1));

    for (int step = 0; step < 4; step++)
        y *= 1.5 - 0.5 * x * y * y;
    return y;
}

/* floor(sqrt(c x 2^k)) = floor(2^23 sqrt(c x 2^(k - 46))), corrected as a
 * quotient is; the radicand is c x 2^(k - 46). */
static inline int64_t root(uint64_t radicand)
{
    const double x = to_double(radicand);
    const uint64_t nearest = to_nearest(reciprocal_root(x) * x * (1 << 23));
    const uint64_t remainder = (radicand << 46) - nearest * nearest;

    return (int64_t)(nearest - (remainder >> 63));
}

/* k is 46 for even exponents, 47 for odd ones. */
static inline lane lane_square_root(c205_word a)
{
    const uint64_t digits = a & WORD_COEFFICIENT_MASK;
    const bool is_even = (a >> EXPONENT_PLACE & 1) == 0;
    const int64_t r = root(is_even ? digits : digits << 1);
    const lane result = number((exponent(a) >> 1) - 23, r);
    const uint64_t negative = a << 16;

    return zero_if(is_zero(a),
                   odd_if(unnormalised(a) | negative | indefinite(a),
                          result));
}

/* ---- Parts of a number, sign -------------------------------------------- */

/* A negative exponent stands in a word as its distance from 0 does. */
static inline int64_t without_fraction(int64_t c, c205_word a)
{
    return shifted(c, 0 - (a & EXPONENT_MASK), 63);
}

static inline lane integer_part(c205_word a, int64_t part)
{
    const c205_word integer = (c205_word)part & WORD_COEFFICIENT_MASK;
    const lane result = {exponent(a) >= 0 ? a : is_zero(a) ? a : integer,
                         indefinite(a)};

    return result;
}

static inline lane lane_floor(c205_word a)
{
    return integer_part(a, without_fraction(coefficient(a), a));
}

static inline lane lane_ceiling(c205_word a)
{
    return integer_part(a, -without_fraction(-coefficient(a), a));
}

static inline lane lane_truncate(c205_word a)
{
    const int64_t c = coefficient(a);
    const int64_t part = without_fraction((int64_t)magnitude(c), a);

    return integer_part(a, c < 0 ? -part : part);
}

/* Two coefficients change the exponent when their sign changes. */
static inline lane lane_negate(c205_word a)
{
    const int64_t c = coefficient(a), e = exponent(a);
    const int64_t half = INT64_C(1) << (WORD_DIGITS - 1);
    const bool too_long = c == -2 * half, too_short = c == half;
    const int64_t moved = too_short ? e - 1 : e;

    return odd_if(indefinite(a),
                  zero_if(is_zero(a),
                          number(too_long ? e + 1 : moved,
                                 too_long    ? half
                                 : too_short ? -2 * half
                                             : -c)));
}

static inline lane lane_absolute(c205_word a)
{
    const lane same = {a, indefinite(a)}, negated = lane_negate(a);
    const bool is_negative = coefficient(a) < 0;
    const lane result = {is_negative ? negated.word : same.word,
                         is_negative ? negated.odd : same.odd};

    return result;
}

#endif
