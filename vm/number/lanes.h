/* lanes.h - fast arithmetic over whole spans, with the results of arith.h.
 *
 * c[i] = a[i] op b[i] for i < n. The result c must not begin above an operand that it
 * overlaps. The bits of a comparison and the destination of lanes_store_masked must not
 * overlap any input. Result and flags equal arith.h, bit for bit, for every word.
 * Normalised operands and machine zeros are the fast path. The loops are plain C that
 * compilers vectorise. Each is compiled for several instruction sets of the host
 * (host.h).
 *
 * lanes_NAME takes words, halves_NAME half words, one at the left of each c205_word.
 */
#ifndef C205_LANES_H
#define C205_LANES_H

#include "vm/number/arith.h"

typedef void lanes_binary(c205_word *c, const c205_word *a, const c205_word *b,
                          size_t n, uint64_t *flags);
typedef void lanes_unary(c205_word *c, const c205_word *a, size_t n, uint64_t *flags);
/* Result i is bit i % 64 of bits[i / 64], counted from the left as in the machine.
 * Unused bits of the last word are zero. */
typedef void lanes_compare(uint64_t *bits, const c205_word *a, const c205_word *b,
                           size_t n);
/* Combines *accumulator with the n words of a, one after another. */
typedef void lanes_reduction(c205_word *accumulator, const c205_word *a, size_t n,
                             uint64_t *flags);

/* lanes_NAME takes words, halves_NAME takes half words. */
#define BINARY(name, ...) lanes_binary lanes_##name, halves_##name;
#define BITWISE(name) lanes_binary lanes_##name, halves_##name;
#define UNARY(name, ...) lanes_unary lanes_##name, halves_##name;
#define RELATION(name) lanes_compare lanes_##name, halves_##name;
#define REDUCTION(name, ...) lanes_reduction lanes_##name, halves_##name;
/* A conversion returns words of the other size. A copy is the same for both sizes. */
#define CONVERSION(name, ...) lanes_unary lanes_##name;
#define COPY(name, ...) lanes_unary lanes_##name;
#include "vm/arith.def"

/* ---- Words of any format ------------------------------------------------ */

/* c[i] = word */
void lanes_fill(c205_word *c, c205_word word, size_t n);

/* c[i] = a[i] for each i whose bit is 1. Bits are numbered as the results of
 * lanes_compare. */
void lanes_store_masked(c205_word *c, const c205_word *a, const uint64_t *bits,
                        size_t n);

#endif
