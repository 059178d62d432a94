/* lanes.h - the arithmetic of arith.h over whole spans, fast.
 *
 * c[i] = a[i] op b[i] for i < n.  c does not overlap a or b.  The result and
 * the flags are those of arith.h, bit for bit, for every word; normalised
 * operands and machine zeros are the fast path.  The loops are plain C that
 * compilers vectorise, cloned for the instruction sets of the host.
 *
 * lanes_NAME takes words, halves_NAME half words, one at the left of each
 * c205_word.
 */
#ifndef C205_LANES_H
#define C205_LANES_H

#include "vm/number/arith.h"

typedef void lanes_binary(c205_word *c, const c205_word *a,
                          const c205_word *b, size_t n, uint64_t *flags);
typedef void lanes_unary(c205_word *c, const c205_word *a, size_t n,
                         uint64_t *flags);
/* bits[i / 64] gets bit i % 64 counted from the left (the machine's order);
 * the unused low bits of the last word are zero. */
typedef void lanes_compare(uint64_t *bits, const c205_word *a,
                           const c205_word *b, size_t n);
/* In element order, from *accumulator on. */
typedef void lanes_reduction(c205_word *accumulator, const c205_word *a,
                             size_t n, uint64_t *flags);

/* The functions of one size; of(name) is what a name is there.  add_index,
 * subtract_index: the coefficient's bits of a + b, a - b, the exponent's from
 * a. */
#define LANES_FUNCTIONS(of) \
    lanes_binary of(add_upper), of(add_lower), of(add_normalised); \
    lanes_binary of(subtract_upper), of(subtract_lower), \
        of(subtract_normalised); \
    lanes_binary of(multiply_upper), of(multiply_lower), \
        of(multiply_significant); \
    lanes_binary of(divide_upper), of(divide_significant); \
    lanes_binary of(average), of(average_difference); \
    lanes_binary of(xor), of(and), of(or), of(nand), of(nor), of(or_not), \
        of(and_not), of(equivalence), of(shift); \
    lanes_binary of(adjust_significance), of(adjust_exponent), of(pack); \
    lanes_binary of(add_index), of(subtract_index); \
    lanes_unary of(square_root), of(truncate), of(floor), of(ceiling), \
        of(absolute), of(negate), of(exponent); \
    lanes_compare of(equal), of(not_equal), of(not_less), of(less); \
    lanes_reduction of(sum), of(product)

#define LANES_OF_WORDS(name) lanes_##name
#define LANES_OF_HALVES(name) halves_##name
LANES_FUNCTIONS(LANES_OF_WORDS);
LANES_FUNCTIONS(LANES_OF_HALVES);

/* From words to half words, and back. */
lanes_unary lanes_contract, lanes_contract_rounded;
lanes_unary lanes_extend;

/* ---- Of any words ------------------------------------------------------- */

lanes_unary lanes_copy;

/* c[i] = word */
void lanes_fill(c205_word *c, c205_word word, size_t n);

/* c[i] = bit i of bits (as above) ? a[i] : c[i] */
void lanes_store_masked(c205_word *c, const c205_word *a,
                        const uint64_t *bits, size_t n);

#endif
