/* usual.h - the words that arithmetic mostly meets: normalised numbers whose
 * exponents are far from the ends of the range, in -2000 .. 1FFF hex.
 *
 * The two first bits of such a word's coefficient differ, the three first ones of
 * its exponent do not.  Sums, products and quotients of two are in the range.
 */
#ifndef C205_USUAL_H
#define C205_USUAL_H

#include "vm/number/word.h"

/* Where a bit differs from the one to its right. */
static inline uint64_t usual_edges(c205_word w)
{
    return w ^ w << 1;
}

/* Whether all words are usual, of edges that all of them have and that any of
 * them has. */
static inline bool usual_by_edges(uint64_t all, uint64_t any)
{
    return (all & UINT64_C(0x800000000000)) && any >> 62 == 0;
}

static inline bool usual_word(c205_word w)
{
    return usual_by_edges(usual_edges(w), usual_edges(w));
}

static inline bool usual_pair(c205_word a, c205_word b)
{
    uint64_t x = usual_edges(a), y = usual_edges(b);

    return usual_by_edges(x & y, x | y);
}

#endif
