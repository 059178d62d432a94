/* common_range.h - tests for common words. A common word is normalised, and its
 * exponent is in -2000 .. 1FFF hex, far from the ends of the range.
 *
 * The first two bits of a common word's coefficient differ, and the first three bits of
 * its exponent are equal. Sums, products and quotients of two common words are in the
 * range. Most operands are common, so fast paths test for this case.
 */
#ifndef C205_COMMON_RANGE_H
#define C205_COMMON_RANGE_H

#include "vm/number/word.h"

/* Returns w with a bit set wherever the bit of w differs from its right neighbour. */
static inline uint64_t common_edges(c205_word w)
{
    return w ^ w << 1;
}

/* Returns true if all words of a set are common. all and any are the AND and the OR of
 * the edges of the words (common_edges()). */
static inline bool common_by_edges(uint64_t all, uint64_t any)
{
    return (all & UINT64_C(0x800000000000)) && any >> 62 == 0;
}

static inline bool common_word(c205_word w)
{
    return common_by_edges(common_edges(w), common_edges(w));
}

static inline bool common_pair(c205_word a, c205_word b)
{
    uint64_t x = common_edges(a), y = common_edges(b);
    return common_by_edges(x & y, x | y);
}

#endif
