/* lanes.h - the arithmetic of arith.h over whole spans, fast.
 *
 * c[i] = a[i] op b[i] for i < n.  c does not overlap a or b.  The result and
 * the flags are those of arith.h, bit for bit, for every word; normalised
 * operands and machine zeros are the fast path.  The loops are plain C that
 * compilers vectorise, cloned for the instruction sets of the host.
 */
#ifndef C205_LANES_H
#define C205_LANES_H

#include "arith.h"

typedef void lanes_binary(c205_word *c, const c205_word *a,
                          const c205_word *b, size_t n, uint64_t *flags);
typedef void lanes_unary(c205_word *c, const c205_word *a, size_t n,
                         uint64_t *flags);
/* bits[i / 64] gets bit i % 64 counted from the left (the machine's order);
 * the unused low bits of the last word are zero. */
typedef void lanes_compare(uint64_t *bits, const c205_word *a,
                           const c205_word *b, size_t n);

lanes_binary lanes_add_upper, lanes_add_lower, lanes_add_normalised;
lanes_binary lanes_subtract_upper, lanes_subtract_lower,
    lanes_subtract_normalised;
lanes_binary lanes_multiply_upper, lanes_multiply_lower,
    lanes_multiply_significant;
lanes_binary lanes_divide_upper, lanes_divide_significant;
lanes_binary lanes_average, lanes_average_difference;
lanes_binary lanes_xor, lanes_and, lanes_or, lanes_nand, lanes_nor,
    lanes_or_not, lanes_and_not, lanes_equivalence, lanes_shift;
lanes_binary lanes_adjust_significance, lanes_adjust_exponent, lanes_pack;
/* The low 48 bits of a + b, a - b; the high 16 bits from a. */
lanes_binary lanes_add_index, lanes_subtract_index;
lanes_unary lanes_square_root, lanes_truncate, lanes_floor, lanes_ceiling,
    lanes_absolute, lanes_negate, lanes_exponent, lanes_copy;
lanes_compare lanes_equal, lanes_not_equal, lanes_not_less, lanes_less;

/* c[i] = bit i of bits (as above) ? a[i] : c[i] */
void lanes_store_masked(c205_word *c, const c205_word *a,
                        const uint64_t *bits, size_t n);

/* Reductions in element order, from *accumulator on; flags as above. */
void lanes_sum(c205_word *accumulator, const c205_word *a, size_t n,
               uint64_t *flags);
void lanes_product(c205_word *accumulator, const c205_word *a, size_t n,
                   uint64_t *flags);

#endif
