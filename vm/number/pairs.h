/* pairs.h - two operations in one pass over spans, as linked instructions execute them:
 * the second operation takes the result of the first.
 *
 * The result and the flags equal those of one operation after the other (lanes.h), bit
 * for bit. A pair runs only for moderate words (round_down.h) and only on some hosts;
 * otherwise the caller runs the two operations separately.
 */
#ifndef C205_PAIRS_H
#define C205_PAIRS_H

#include "vm/number/lanes.h"

/* An operand of a span: word i for lane i, or the first word for all lanes. */
typedef struct pair_operand {
    const c205_word *words;
    bool is_constant;
} pair_operand;

enum { PAIR_LENGTH = 512 }; /* at most */

/* Computes c from a and b by the first operation, then with d by the second, for n <=
 * PAIR_LENGTH words. If c overlaps an operand, it must begin at the same address or
 * below. Sets *done. If it is false, the caller must use two operations; c is then
 * undefined unless it overlaps an operand, in which case it is unchanged. */
typedef void lanes_pair(bool *done, c205_word *c, pair_operand a, pair_operand b,
                        const c205_word *d, size_t n, uint64_t *flags);

/* Returns the function for two operations. hands_a, hands_b: the first result is the
 * first, the second operand of the second operation. NULL: there is no function for
 * this pair. */
lanes_pair *lanes_pair_of(lanes_binary *first, lanes_binary *second, bool hands_a,
                          bool hands_b);

#endif
