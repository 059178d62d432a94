/* round_down.h - computes sums, differences and products of moderate words with doubles
 * of the host, which must be able to round down. A compiler vectorises the loops.
 *
 * A word is moderate if it is normalised and its exponent lies in -100 .. FF hex. A
 * double holds it exactly, and the sum, difference or product of two is in the range of
 * doubles. A double has 53 digits, a word 47. Rounding down to 53 digits and then to 47
 * equals rounding down once, which is the machine's rule (docs/arithmetic.md). The
 * machine differs in one point. It cuts off the part of a subtrahend below the register
 * before the sign changes. A positive subtrahend that is 94 places down is cut off
 * completely and subtracts nothing.
 */
#ifndef C205_ROUND_DOWN_H
#define C205_ROUND_DOWN_H

#include "vm/number/arith.h"
#include "vm/number/double_bits.h"
#include "vm/number/host.h"
#include "vm/number/lane_kinds.h"
#include "vm/number/common_range.h"

/* The digits of a double after the first digit, and the bias of its stored exponent.
 * ROUND_DOWN_DIGITS are the digits of a word's coefficient after the first digit. */
enum {
    DOUBLE_DIGITS = 52,
    DOUBLE_BIAS = 1023,
    ROUND_DOWN_DIGITS = WORD_DIGITS - 1,
    ROUND_DOWN_PLACE = 48 /* bits to the right of a word's exponent */
};

static inline uint64_t double_exponent(int e)
{
    return (uint64_t)(e + DOUBLE_BIAS) << DOUBLE_DIGITS;
}

/* ---- Moderate words ------------------------------------------------------ */

/* Returns true if each word of a set is machine zero or moderate: a common word whose
 * exponent begins with eight equal bits. all and any are the AND and the OR of the
 * edges of the words (moderate_edges()). */
static inline bool moderate_by_edges(uint64_t all, uint64_t any)
{
    return common_by_edges(all, any) && any >> 57 == 0;
}

static inline uint64_t moderate_edges(c205_word w)
{
    return w == C205_MACHINE_ZERO ? UINT64_C(0x800000000000) : common_edges(w);
}

static inline bool moderate_pair(c205_word a, c205_word b)
{
    uint64_t x = moderate_edges(a), y = moderate_edges(b);
    return moderate_by_edges(x & y, x | y);
}

/* Returns the exact value as a double. `large` is (2^52 + 2^47) x 2^exponent. Its last
 * bits are combined with the coefficient in two's complement, which gives large +
 * value. A negative coefficient clears the bit of 2^47 and does not change the
 * exponent. The difference is the value. */
static inline double moderate_value(c205_word w)
{
    uint64_t exponent = w >> ROUND_DOWN_PLACE << DOUBLE_DIGITS;
    uint64_t large = exponent
                     + (double_exponent(DOUBLE_DIGITS) | UINT64_C(1) << WORD_DIGITS);
    return double_of_bits(large ^ (w & WORD_COEFFICIENT_MASK)) - double_of_bits(large);
}

/* Returns a nonzero double as a normalised word, rounded down. The value is scaled so
 * that its integer part is the coefficient. A large number is then added, and the last
 * digits of the sum are the coefficient. Normalised coefficients include -2^47 but not
 * -2^46, so a negative power of two gets the next lower exponent. */
static inline c205_word round_down_word(double value)
{
    uint64_t bits = bits_of_double(value);
    uint64_t shorter = bits + (uint64_t)((int64_t)bits >> 63);
    uint64_t field = double_exponent(DOUBLE_BIAS + 1);
    uint64_t places = (shorter & field) - double_exponent(ROUND_DOWN_DIGITS);
    uint64_t large = double_exponent(DOUBLE_DIGITS) | UINT64_C(1) << 51;
    double c = double_of_bits(bits - places) + double_of_bits(large);
    uint64_t exponent = (uint64_t)((int64_t)places
                                   >> (DOUBLE_DIGITS - ROUND_DOWN_PLACE));
    return format_with_coefficient(whole_words, exponent, bits_of_double(c));
}

/* Returns a double, rounded down to the 47 digits of a word. */
static inline double round_down_value(double value)
{
    enum { BEYOND = (1 << (DOUBLE_DIGITS - ROUND_DOWN_DIGITS)) - 1 };
    uint64_t bits = bits_of_double(value);
    uint64_t is_negative = (uint64_t)((int64_t)bits >> 63);
    return double_of_bits((bits + (is_negative & BEYOND)) & ~(uint64_t)BEYOND);
}

/* ---- Operations ---------------------------------------------------------- */

/* A result before rounding to a word. If is_odd is set, the exact rule must compute
 * it. */
typedef struct round_down {
    double value;
    bool is_odd;
} round_down;

static inline round_down round_down_add(double x, double y)
{
    const round_down sum = { x + y, false };
    return sum;
}

/* Subtracts. Marks the result as odd, for the exact rule, if a positive subtrahend is
 * below the last digit of x, because the machine cuts off some of these completely. */
static inline round_down round_down_subtract(double x, double y)
{
    const round_down difference = { x - y, (x + y == x) & (y > 0) };
    return difference;
}

static inline round_down round_down_multiply(double x, double y)
{
    const round_down product = { x * y, false };
    return product;
}

/* ---- Blocks -------------------------------------------------------------- */

/* The shortest block for which the speed-up exceeds the cost of changing the rounding
 * mode. */
enum { MIN_ROUND_DOWN = 32 };

/* Properties of a block that are known only after all of its words are computed. */
typedef struct round_down_block {
    uint64_t all, any; /* AND and OR of the edges */
    /* Counts of odd and zero results. They are sums because clang 14 vectorises + but
     * not | here. */
    uint64_t odd, zeros;
} round_down_block;

static const round_down_block round_down_begin = { UINT64_MAX, 0, 0, 0 };

static inline void take_edges(round_down_block *block, c205_word a, c205_word b)
{
    uint64_t x = moderate_edges(a), y = moderate_edges(b);
    block->all &= x & y;
    block->any |= x | y;
}

static inline double take_result(round_down_block *block, round_down result)
{
    block->odd += result.is_odd;
    block->zeros += result.value == 0;
    return result.value;
}

static inline c205_word result_word(double value)
{
    c205_word word = round_down_word(value);
    return value == 0 ? C205_MACHINE_ZERO : word;
}

/* Ends a computed block and sets its flags. Returns false if some word was not moderate
 * or some result is odd; another method must then compute the block. */
static inline bool round_down_end(const round_down_block *block, uint64_t *flags)
{
    if (!moderate_by_edges(block->all, block->any) || block->odd)
        return false;
    if (block->zeros)
        *flags |= FLAG_MACHINE_ZERO;
    return true;
}

/* Computes a block of n words. Returns false if another method must compute it. */
#define ROUND_DOWN_BLOCK(name, operation) \
    LANEWISE bool name BLOCK_PARAMETERS \
    { \
        round_down_block block = round_down_begin; \
        host_rounding before; \
        if (n < MIN_ROUND_DOWN || !moderate_pair(a[0], b[0]) \
            || !host_round_down(&before)) \
            return false; \
        EACH_LANE({ \
            take_edges(&block, a[j], b[j]); \
            to[j] = result_word(take_result(&block, operation(moderate_value(a[j]), \
                                                              moderate_value(b[j])))); \
        }); \
        host_round_as(before); \
        return round_down_end(&block, flags); \
    }

#endif
