/* lane_kinds.h - tests and orders words of every format without branches, for loops
 * that a compiler vectorises.
 *
 * Compared as signed integers, the machine zeros come first, then the numbers by
 * exponent, then the indefinite words.
 */
#ifndef C205_LANE_KINDS_H
#define C205_LANE_KINDS_H

#include "vm/number/word.h"

#define MIN_NUMBER UINT64_C(0x9000000000000000)

static inline bool is_zero(c205_word w)
{
    return (int64_t)w < (int64_t)MIN_NUMBER;
}

/* Returns the larger of two words, compared as signed integers. Its exponent is not
 * below the exponent of the other word. */
static inline c205_word max_word(c205_word a, c205_word b)
{
    return (int64_t)a < (int64_t)b ? b : a;
}

static inline c205_word min_word(c205_word a, c205_word b)
{
    return (int64_t)a < (int64_t)b ? a : b;
}

/* ---- Tests whose result is the first bit -----------------------------------
 *
 * The first bit of the result is 1 if the test holds. The tests use arithmetic, because
 * a compiler would merge comparisons with later comparisons of the result.
 */

/* Tests for a machine zero. Its first four bits are 8: the sign bit is 1, and
 * subtracting 9 from them borrows. */
static inline uint64_t zero(c205_word w)
{
    return w & (w - MIN_NUMBER);
}

/* Tests for an indefinite word. Its first four bits are 7: the sign bit is 0, and
 * adding 1 to them carries into it. */
static inline uint64_t indefinite(c205_word w)
{
    return ~w & (w + UINT64_C(0x1000000000000000));
}

#endif
