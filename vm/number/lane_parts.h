/* lane_parts.h - the shared part of lane.h and half_lane.h: arithmetic on one lane for
 * words of a given format. It has no branches, so a compiler vectorises the loops.
 *
 * A file defines two macros before it includes this file:
 *
 *   LANE_FORMAT   a constant word_format
 *   LANE_GUARD    guard bits that sums keep below the coefficient of the larger
 *                 operand; digits plus guard bits are at most 49
 *
 * Each function is correct if operands and results are normalised numbers in the range
 * or machine zeros. Otherwise it marks its result as odd. All operations exist in
 * vector units for 64-bit integers.
 */
#ifndef C205_LANE_PARTS_H
#define C205_LANE_PARTS_H

#include "vm/number/double_bits.h"
#include "vm/number/lane_kinds.h"

#include <math.h>

#define DIGITS (LANE_FORMAT.digits)
#define EXPONENT_PLACE (64 - LANE_FORMAT.exponent_bits)
#define EXPONENT_MASK (UINT64_MAX << EXPONENT_PLACE)

/* A result. If the first bit of odd is 1, it is invalid, and the exact rule must
 * compute it. */
typedef struct lane {
    c205_word word;
    uint64_t odd;
} lane;

static const uint64_t first_bit = UINT64_C(1) << 63;

/* ---- The parts of a word ------------------------------------------------ */

static inline int64_t exponent(c205_word w)
{
    return (int64_t)w >> EXPONENT_PLACE;
}

static inline int64_t coefficient(c205_word w)
{
    return format_coefficient(LANE_FORMAT, w);
}

/* Returns the coefficient x 2^LANE_GUARD. For a machine zero, guarded() returns its
 * digits and guarded_value() returns 0, as arithmetic does. */
static inline int64_t guarded(c205_word w)
{
    int64_t digits = (int64_t)(w << LANE_FORMAT.exponent_bits);
    return digits >> (63 - DIGITS - LANE_GUARD);
}

static inline int64_t guarded_value(c205_word w)
{
    return is_zero(w) ? 0 : guarded(w);
}

static inline uint64_t magnitude(int64_t c)
{
    return (uint64_t)(c < 0 ? -c : c);
}

/* Returns a word whose first bit is 1 if the coefficient is not normalised. The
 * exponent does not matter. */
static inline uint64_t unnormalised(c205_word w)
{
    uint64_t digits = w << LANE_FORMAT.exponent_bits;
    return digits ^ digits << 1 ^ first_bit;
}

static inline uint64_t out_of_range(int64_t e)
{
    return (uint64_t)((format_exponent_max(LANE_FORMAT) - e)
                      | (e - format_exponent_min(LANE_FORMAT)));
}

/* ---- Doubles and their bits --------------------------------------------- */

static const uint64_t two_to_52 = UINT64_C(0x4330000000000000);

/* These functions convert between natural numbers below 2^51 and doubles. They round to
 * the nearest number. The double 2^52 + n has the number n in its last bits. */
static inline double to_double(uint64_t n)
{
    return double_of_bits(two_to_52 | n) - double_of_bits(two_to_52);
}

static inline uint64_t to_nearest(double d)
{
    return bits_of_double(d + double_of_bits(two_to_52)) & ((UINT64_C(1) << 51) - 1);
}

enum { LENGTH = 51 };

/* Returns LENGTH minus the bit length of t, |t| < 2^51: the places by which t can be
 * shifted left in LENGTH bits. Let x be t, or its complement if t is negative. The
 * exponent of x + 0.5 as a double is the bit length minus 1, also for x = 0. It is
 * subtracted in place, without extracting it. */
static inline uint64_t room(int64_t t)
{
    enum { BIAS = 1023 };
    double d = double_of_bits(two_to_52 | (uint64_t)(t ^ t >> 63))
               - (double_of_bits(two_to_52) - 0.5);
    return (((uint64_t)(BIAS + LENGTH) << 52) - 1 - bits_of_double(d)) >> 52;
}

/* ---- Results ------------------------------------------------------------ */

/* Returns the word of an integer: the exponent 0 and the coefficient c. */
static inline c205_word integer(int64_t c)
{
    return (c205_word)c << format_padding(LANE_FORMAT)
           & format_coefficient_mask(LANE_FORMAT);
}

static inline lane number(int64_t e, int64_t c)
{
    const lane result = { (c205_word)e << EXPONENT_PLACE | integer(c),
                          out_of_range(e) };
    return result;
}

/* Returns a valid machine zero if it_is is true, and `otherwise` if it is false. */
static inline lane zero_if(bool it_is, lane otherwise)
{
    const lane result = { it_is ? C205_MACHINE_ZERO : otherwise.word,
                          it_is ? 0 : otherwise.odd };
    return result;
}

static inline lane odd_if(uint64_t odd, lane result)
{
    result.odd |= odd;
    return result;
}

/* Returns t x 2^e, |t| < 2^51, rounded down to `bits` significant bits, bits <=
 * DIGITS. */
static inline lane significant(int64_t e, int64_t t, int64_t bits)
{
    uint64_t places = room(t);
    int64_t top = (int64_t)((uint64_t)t << places);
    int64_t excess = LENGTH - bits;
    return number(e + excess - (int64_t)places, top >> excess);
}

/* Returns t x 2^e as a normalised word, or machine zero if t is 0. */
static inline lane normalised(int64_t e, int64_t t)
{
    return zero_if(t == 0, significant(e, t, DIGITS));
}

/* Returns the bits of t above the given number of digits, or 0 if t fits. */
static inline uint64_t excess(int64_t t, int digits)
{
    return (uint64_t)(t ^ t >> 63) >> digits;
}

/* Returns t x 2^e, |t| <= 2^(DIGITS + 1), shifted right until it fits. The shift may be
 * unsigned, because number() drops the bits above the coefficient. */
static inline lane fitted(int64_t e, int64_t t)
{
    uint64_t places = excess(t, DIGITS);
    return number(e + (int64_t)places, (int64_t)((uint64_t)t >> places));
}

/* Applies the rules for special factors. An indefinite factor marks the result as odd,
 * for the exact rule. Otherwise a machine zero makes the result zero. Machine zeros are
 * the smallest words. */
static inline lane special_product(c205_word a, c205_word b, lane result)
{
    return odd_if(indefinite(max_word(a, b)), zero_if(is_zero(min_word(a, b)), result));
}

/* ---- Add, subtract ------------------------------------------------------ */

/* Returns the distance between the exponents of l and s, at most limit, in the position
 * of an exponent. The bits below it are undefined. They prevent a compiler from using a
 * shorter integer. */
static inline uint64_t apart(c205_word l, c205_word s, int64_t limit)
{
    uint64_t distance = l - (s & EXPONENT_MASK);
    uint64_t most = (uint64_t)limit << EXPONENT_PLACE;
    return distance < most ? distance : most;
}

static inline int64_t shifted(int64_t c, uint64_t distance)
{
    return c >> (distance >> EXPONENT_PLACE);
}

/* Returns the sum, rounded down to LANE_GUARD bits below the coefficient of the larger
 * operand. If the larger operand is normalised, a normalised result needs no further
 * bits: no bit is lost if the exponents differ by at most 1, and otherwise
 * normalisation shifts the sum left by at most one place. If the guard holds all
 * digits, the sum is exact. */
static inline int64_t sum_of(c205_word l, int64_t value_l, c205_word s, int64_t value_s)
{
    return value_l + shifted(value_s, apart(l, s, 63));
}

static inline int64_t sum(c205_word a, c205_word b)
{
    c205_word l = max_word(a, b), s = min_word(a, b);
    return sum_of(l, guarded_value(l), s, guarded_value(s));
}

/* Returns the difference, rounded down as in sum_of. The subtrahend is cut at the end
 * of the register (DIGITS places down) before its sign changes. */
static inline int64_t difference_of(c205_word l, int64_t value_l, c205_word s,
                                    int64_t value_s, bool is_subtrahend)
{
    int64_t reach = DIGITS - LANE_GUARD;
    uint64_t distance = apart(l, s, reach);
    int64_t kept = shifted(value_s, apart(l, s, reach + 63) - distance);
    return (is_subtrahend ? value_l : -value_l)
           + shifted(is_subtrahend ? -kept : kept, distance);
}

static inline int64_t difference(c205_word a, c205_word b)
{
    c205_word l = max_word(a, b), s = min_word(a, b);
    return difference_of(l, guarded_value(l), s, guarded_value(s),
                         (int64_t)b <= (int64_t)a);
}

/* Returns the upper sum. If an operand is indefinite, the exponent of the sum is out of
 * range. The returned lane is then invalid (its member odd is set), and the function in
 * arith.h must compute the sum. */
static inline lane sum_upper(c205_word a, c205_word b, int64_t t)
{
    c205_word l = max_word(a, b);
    return zero_if(is_zero(l), fitted(exponent(l), t >> LANE_GUARD));
}

/* Returns a word whose first bit is 1 if the exponent is in the outer half of its
 * field, as for machine zeros. If neither of two exponents is, their sum is in the
 * range. */
static inline uint64_t is_extreme(c205_word w)
{
    return w + UINT64_C(0x4000000000000000);
}

/* Returns t with the exponent of l, normalised. Changing the exponent in place takes
 * fewer steps than extracting it. */
static inline c205_word with_sum(c205_word l, int64_t t)
{
    uint64_t places = room(t) & 63;
    int64_t top = (int64_t)((uint64_t)t << places) >> (LENGTH - DIGITS);
    uint64_t more = (uint64_t)(LENGTH - DIGITS - LANE_GUARD) - places;
    c205_word high = l + (more << EXPONENT_PLACE);
    c205_word low = (c205_word)top << format_padding(LANE_FORMAT);
    return format_with_coefficient(LANE_FORMAT, high, low);
}

static inline lane sum_normalised(c205_word a, c205_word b, int64_t t)
{
    c205_word l = max_word(a, b);
    uint64_t too_short = LANE_GUARD < DIGITS ? unnormalised(l) : 0;
    const lane result = { with_sum(l, t), 0 };
    return odd_if(is_zero(l) ? 0 : is_extreme(l) | too_short, zero_if(t == 0, result));
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
    uint64_t is_number = ~zero(sum.word) >> 63;
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

/* ---- Parts of a number, sign -------------------------------------------- */

/* Returns c shifted right, so that its fraction bits are lost. apart(0, a) is the
 * magnitude of a negative exponent. */
static inline int64_t without_fraction(int64_t c, c205_word a)
{
    return shifted(c, apart(0, a, 63));
}

static inline lane integer_part(c205_word a, int64_t part)
{
    c205_word whole = integer(part);
    const lane result = { exponent(a) >= 0 ? a
                          : is_zero(a)     ? a
                                           : whole,
                          indefinite(a) };
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
    int64_t c = coefficient(a);
    int64_t part = without_fraction((int64_t)magnitude(c), a);
    return integer_part(a, c < 0 ? -part : part);
}

/* Negates a word. The exponent changes for two coefficients: the minimum, and half of
 * it with the sign reversed. */
static inline lane lane_negate(c205_word a)
{
    int64_t c = coefficient(a), e = exponent(a);
    int64_t half = -format_coefficient_min(LANE_FORMAT) / 2;
    bool too_long = c == -2 * half, too_short = c == half;
    int64_t moved = too_short ? e - 1 : e;
    return odd_if(indefinite(a), zero_if(is_zero(a), number(too_long ? e + 1 : moved,
                                                            too_long    ? half
                                                            : too_short ? -2 * half
                                                                        : -c)));
}

/* Returns the magnitude. A machine zero is unchanged unless its digits form a negative
 * number. */
static inline lane lane_absolute(c205_word a)
{
    int64_t c = coefficient(a);
    const lane zero_number = { c < 0 ? C205_MACHINE_ZERO : a, 0 };
    lane result = fitted(exponent(a), (int64_t)magnitude(c));
    return odd_if(indefinite(a), is_zero(a) ? zero_number : result);
}

#endif
