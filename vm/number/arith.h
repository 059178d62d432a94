/* arith.h - the exact rule of the machine for scalar arithmetic.
 *
 * These functions define every result to the last bit, for every pair of words. lanes.h
 * computes the same results over whole spans and must agree bit for bit. All results
 * are rounded down, except in arith_contract_rounded. The rules are reconstructed
 * (docs/arithmetic.md).
 *
 * rule.h implements the rule for words of any format. arith_NAME takes words of 64
 * bits. half_NAME takes half words of 32 bits, in the left half of a c205_word.
 *
 * Each function ORs into *flags the bits of the data flag register that the operation
 * sets.
 */
#ifndef C205_ARITH_H
#define C205_ARITH_H

#include "vm/number/word.h"

/* Bits of the data flag register. Bit 0 is the leftmost bit. */
#define FLAG_DIVIDE_FAULT (UINT64_C(1) << (63 - 41))
#define FLAG_EXPONENT_OVERFLOW (UINT64_C(1) << (63 - 42))
#define FLAG_MACHINE_ZERO (UINT64_C(1) << (63 - 43))
#define FLAG_IMAGINARY_ROOT (UINT64_C(1) << (63 - 45))
#define FLAG_INDEFINITE (UINT64_C(1) << (63 - 46))

typedef c205_word arith_binary(c205_word a, c205_word b, uint64_t *flags);
typedef c205_word arith_unary(c205_word a, uint64_t *flags);
typedef bool arith_relation(c205_word a, c205_word b);

/* arith_NAME takes words, half_NAME takes half words. */
#define BINARY(name, ...) arith_binary arith_##name, half_##name;
#define UNARY(name, ...) arith_unary arith_##name, half_##name;
#define RELATION(name) arith_relation arith_##name, half_##name;
/* A conversion returns a word of the other size. */
#define CONVERSION(name, ...) arith_unary arith_##name;
#include "vm/arith.def"

#endif
