/* pairs.h - executes the two operations of linked instructions in one pass over spans.
 * The second operation takes the result of the first.
 *
 * Result and flags equal two separate operations (lanes.h), bit for bit. A pair runs
 * only for moderate words (round_down.h) and only on some hosts; otherwise the caller
 * runs the two operations separately.
 */
#ifndef C205_PAIRS_H
#define C205_PAIRS_H

#include "vm/number/lanes.h"

/* An operand of n elements: n words, or one word that all elements use. */
typedef struct pair_operand {
    const c205_word *words;
    bool is_constant;
} pair_operand;

enum { PAIR_LENGTH = 512 }; /* largest number of words in a span */

/* Applies the first operation to a and b, and the second operation to its result and d,
 * for n <= PAIR_LENGTH words. Stores the final result in c. The result c must not begin
 * above an operand that it overlaps. If *done is set to false, the caller must run two
 * operations. In this case c is unchanged if it overlaps an operand, and undefined
 * otherwise. */
typedef void lanes_pair(bool *done, c205_word *c, pair_operand a, pair_operand b,
                        const c205_word *d, size_t n, uint64_t *flags);

/* Returns the function that executes two operations in one pass, or NULL if there is
 * none. hands_a: the first result is operand A of the second operation. hands_b: it is
 * operand B. */
lanes_pair *lanes_pair_of(lanes_binary *first, lanes_binary *second, bool hands_a,
                          bool hands_b);

#endif
