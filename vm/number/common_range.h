/* common_range.h - the words that arithmetic mostly meets: normalised numbers whose
 * exponents are far from the ends of the range, in -2000 .. 1FFF hex.
 *
 * The two first bits of such a word's coefficient differ, the three first ones of
 * its exponent do not.  Sums, products and quotients of two are in the range.
 */
#ifndef C205_COMMON_RANGE_H
#define C205_COMMON_RANGE_H

#include "vm/number/word.h"

/* Where a bit differs from the one to its right. */
static inline uint64_t common_edges(c205_word w)
{
    return w ^ w << 1;
}

/* Whether all words are usual, of edges that all of them have and that any of
 * them has. */
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
