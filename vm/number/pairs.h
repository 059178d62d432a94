/* pairs.h - two operations in one pass over spans, as linked instructions do
 * them: the second takes what the first hands over.
 *
 * The result and the flags are those of one after the other (lanes.h), bit for
 * bit, where there is a result: a pair is done for moderate words alone
 * (round_down.h), and only on some hosts.
 */
#ifndef C205_PAIRS_H
#define C205_PAIRS_H

#include "vm/number/lanes.h"

/* A span's operand: word i, or the first for all. */
typedef struct pair_operand {
    const c205_word *words;
    bool is_constant;
} pair_operand;

enum { PAIR_LENGTH = 512 }; /* at most */

/* From a and b by the first operation, with d by the second; n <= PAIR_LENGTH
 * words.  Where c overlaps an operand it begins there or below.  Not *done: it is
 * to be done otherwise; of c, where it overlaps no operand, anything may be
 * stored. */
typedef void lanes_pair(bool *done, c205_word *c, pair_operand a, pair_operand b,
                        const c205_word *d, size_t n, uint64_t *flags);

/* hands_a, hands_b: what the first gives is the second's first operand, its
 * second one.  NULL: there is none for these. */
lanes_pair *lanes_pair_of(lanes_binary *first, lanes_binary *second, bool hands_a,
                          bool hands_b);

#endif
