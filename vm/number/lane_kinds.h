/* lane_kinds.h - the kinds of words and their order without branches, for
 * loops that a compiler vectorises; for words of every format.
 *
 * Words are compared as integers with a sign: first come the machine zeros,
 * then the numbers by their exponents, last the indefinite.
 */
#ifndef C205_LANE_KINDS_H
#define C205_LANE_KINDS_H

#include "vm/number/word.h"

#define LEAST_NUMBER UINT64_C(0x9000000000000000)

static inline bool is_zero(c205_word w)
{
    return (int64_t)w < (int64_t)LEAST_NUMBER;
}

/* The operand of the larger exponent is one of those not smaller. */
static inline c205_word larger(c205_word a, c205_word b)
{
    return (int64_t)a < (int64_t)b ? b : a;
}

static inline c205_word smaller(c205_word a, c205_word b)
{
    return (int64_t)a < (int64_t)b ? a : b;
}

/* ---- In the first bit: 1, it is -------------------------------------------
 *
 * Made of arithmetic and not of comparisons, which a compiler would mix with
 * those of the result.
 */

/* 8 in the first four bits: the words of sign 1 that fall below 9 and
 * borrow. */
static inline uint64_t zero(c205_word w)
{
    return w & (w - LEAST_NUMBER);
}

/* 7 there: the words of sign 0 that carry into it. */
static inline uint64_t indefinite(c205_word w)
{
    return ~w & (w + UINT64_C(0x1000000000000000));
}

#endif
