/* lanes.h - the arithmetic of arith.h over whole spans, fast.
 *
 * c[i] = a[i] op b[i] for i < n.  Where c overlaps a or b, it begins there or
 * below; the bits of a comparison and what lanes_store_masked stores overlap
 * nothing that is read.  The result and the flags are those of arith.h, bit
 * for bit, for every word; normalised operands and machine zeros are the fast
 * path.  The loops are plain C that compilers vectorise, compiled for each of
 * the host's instruction sets.
 *
 * lanes_NAME takes words, halves_NAME half words, one at the left of each
 * c205_word.
 */
#ifndef C205_LANES_H
#define C205_LANES_H

#include "vm/number/arith.h"

typedef void lanes_binary(c205_word *c, const c205_word *a, const c205_word *b,
                          size_t n, uint64_t *flags);
typedef void lanes_unary(c205_word *c, const c205_word *a, size_t n, uint64_t *flags);
/* bits[i / 64] gets bit i % 64 counted from the left (the machine's order);
 * the unused low bits of the last word are zero. */
typedef void lanes_compare(uint64_t *bits, const c205_word *a, const c205_word *b,
                           size_t n);
/* In element order, from *accumulator on. */
typedef void lanes_reduction(c205_word *accumulator, const c205_word *a, size_t n,
                             uint64_t *flags);

/* lanes_NAME is of words, halves_NAME of half words. */
#define BINARY(name, ...) lanes_binary lanes_##name, halves_##name;
#define BITWISE(name) lanes_binary lanes_##name, halves_##name;
#define UNARY(name, ...) lanes_unary lanes_##name, halves_##name;
#define RELATION(name) lanes_compare lanes_##name, halves_##name;
#define REDUCTION(name, ...) lanes_reduction lanes_##name, halves_##name;
/* To the other size; of any. */
#define CONVERSION(name, ...) lanes_unary lanes_##name;
#define COPY(name, ...) lanes_unary lanes_##name;
#include "vm/arith.def"

/* ---- Of any words ------------------------------------------------------- */

/* c[i] = word */
void lanes_fill(c205_word *c, c205_word word, size_t n);

/* c[i] = bit i of bits (as above) ? a[i] : c[i] */
void lanes_store_masked(c205_word *c, const c205_word *a, const uint64_t *bits,
                        size_t n);

#endif
