/* round_down.h - sums, differences and products of moderate words by the host's
 * doubles, where it can round them down; for loops that a compiler vectorises.
 *
 * A word is moderate if it is normalised and its exponent lies in -100 .. FF
 * hex.  A double holds it exactly, and the sum, difference or product of two
 * is in the range of doubles.  It has 53 digits, a word 47: what is rounded down
 * to the one and then to the other is rounded down, which is what the machine does
 * (docs/arithmetic.md).  One thing it does otherwise: what of a subtrahend lies
 * below the register is cut off before its sign changes, so that a positive one that
 * is cut off whole, 94 places down, takes nothing away.
 */
#ifndef C205_ROUND_DOWN_H
#define C205_ROUND_DOWN_H

#include "vm/number/arith.h"
#include "vm/number/host.h"
#include "vm/number/lane_kinds.h"
#include "vm/number/common_range.h"

/* Digits of a double behind the first one, and what its exponent is stored
 * above; those of a word's coefficient likewise. */
enum {
    DOUBLE_DIGITS = 52,
    DOUBLE_BIAS = 1023,
    FLOORED_DIGITS = WORD_DIGITS - 1,
    FLOORED_PLACE = 48 /* of a word's exponent */
};

static inline uint64_t double_exponent(int e)
{
    return (uint64_t)(e + DOUBLE_BIAS) << DOUBLE_DIGITS;
}

static inline double round_down_double(uint64_t bits)
{
    double d;

    memcpy(&d, &bits, sizeof d);
    return d;
}

static inline uint64_t round_down_bits(double d)
{
    uint64_t bits;

    memcpy(&bits, &d, sizeof bits);
    return bits;
}

/* ---- Moderate words ------------------------------------------------------ */

/* Of common_edges() that all words have and that any has: the first eight bits of the
 * exponent are the same. */
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

/* The value, exactly: the last digits of a large number with this exponent,
 * less that number, which has 2^47 more than 2^52 so that a negative
 * coefficient leaves it its length. */
static inline double moderate_value(c205_word w)
{
    uint64_t exponent = w >> FLOORED_PLACE << DOUBLE_DIGITS;
    uint64_t large = exponent
                     + (double_exponent(DOUBLE_DIGITS) | UINT64_C(1) << WORD_DIGITS);

    return round_down_double(large ^ (w & WORD_COEFFICIENT_MASK))
           - round_down_double(large);
}

/* A double to a normalised word, rounded down; not of zero.  -2^46 is no
 * normalised coefficient, -2^47 is one: a negative number counts as one place
 * shorter where the digits behind its first one are 0.  The floor of what has the
 * exponent of a coefficient is in the last digits of its sum with a large
 * number. */
static inline c205_word round_down_word(double value)
{
    uint64_t bits = round_down_bits(value);
    uint64_t shorter = bits + (uint64_t)((int64_t)bits >> 63);
    uint64_t field = double_exponent(DOUBLE_BIAS + 1);
    uint64_t places = (shorter & field) - double_exponent(FLOORED_DIGITS);
    uint64_t large = double_exponent(DOUBLE_DIGITS) | UINT64_C(1) << 51;
    double c = round_down_double(bits - places) + round_down_double(large);
    uint64_t exponent = (uint64_t)((int64_t)places >> (DOUBLE_DIGITS - FLOORED_PLACE));

    return format_with_coefficient(whole_words, exponent, round_down_bits(c));
}

/* A double to 47 digits, rounded down. */
static inline double round_down_value(double value)
{
    enum { BEYOND = (1 << (DOUBLE_DIGITS - FLOORED_DIGITS)) - 1 };
    uint64_t bits = round_down_bits(value);
    uint64_t is_negative = (uint64_t)((int64_t)bits >> 63);

    return round_down_double((bits + (is_negative & BEYOND)) & ~(uint64_t)BEYOND);
}

/* ---- Operations ---------------------------------------------------------- */

/* A result, to be rounded down once more; unless it is odd. */
typedef struct floored {
    double value;
    bool is_odd;
} floored;

static inline floored round_down_add(double x, double y)
{
    const floored sum = { x + y, false };

    return sum;
}

/* Not right are all with a positive subtrahend of less than a double's last digit,
 * some of which are cut off whole. */
static inline floored round_down_subtract(double x, double y)
{
    const floored difference = { x - y, (x + y == x) & (y > 0) };

    return difference;
}

static inline floored round_down_multiply(double x, double y)
{
    const floored product = { x * y, false };

    return product;
}

/* ---- Blocks -------------------------------------------------------------- */

/* The way of rounding is changed for a block, which must pay. */
enum { FLOORED_LEAST = 32 };

/* What is known of a block only when it is done. */
typedef struct round_down_block {
    uint64_t all, any; /* edges */
    /* Counts, which clang 14 vectorises; masks gathered by | it does not. */
    uint64_t odd, zeros;
} round_down_block;

static const round_down_block round_down_begin = { UINT64_MAX, 0, 0, 0 };

static inline void take_edges(round_down_block *block, c205_word a, c205_word b)
{
    uint64_t x = moderate_edges(a), y = moderate_edges(b);

    block->all &= x & y;
    block->any |= x | y;
}

static inline double take_result(round_down_block *block, floored result)
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

/* False: it is to be done otherwise. */
static inline bool round_down_end(const round_down_block *block, uint64_t *flags)
{
    if (!moderate_by_edges(block->all, block->any) || block->odd)
        return false;
    if (block->zeros)
        *flags |= FLAG_MACHINE_ZERO;
    return true;
}

/* A block of n words, or false: it is to be done otherwise. */
#define FLOORED_BLOCK(name, operation) \
    LANEWISE bool name BLOCK_PARAMETERS \
    { \
        round_down_block block = round_down_begin; \
        host_rounding before; \
        if (n < FLOORED_LEAST || !moderate_pair(a[0], b[0]) \
            || !host_round_down(&before)) \
            return false; \
        EACH_LANE(take_edges(&block, a[j], b[j]); \
                  to[j] = result_word( \
                      take_result(&block, operation(moderate_value(a[j]), \
                                                    moderate_value(b[j]))));) \
        host_round_as(before); \
        return round_down_end(&block, flags); \
    }

#endif
