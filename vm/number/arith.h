/* arith.h - scalar arithmetic: the exact rule of the machine.
 *
 * Every result is defined here to the last bit, for every pair of words;
 * lanes.h does the same over whole spans and must agree.  All results are
 * cut, never rounded.  Source: machine notes, section 2 (R); where they are
 * silent the comment at the function says what this project fixed.
 *
 * The rule is written once, in rule.h, for words of any format: arith_NAME is
 * that for words of 64 bits, half_NAME that for half words of 32, which stand
 * at the left of a c205_word.
 *
 * Each function ORs into *flags the bits of the data flag register that the
 * operation sets.
 */
#ifndef C205_ARITH_H
#define C205_ARITH_H

#include "vm/number/word.h"

/* Bits of the data flag register, numbered from the left. */
#define FLAG_DIVIDE_FAULT (UINT64_C(1) << (63 - 41))
#define FLAG_EXPONENT_OVERFLOW (UINT64_C(1) << (63 - 42))
#define FLAG_MACHINE_ZERO (UINT64_C(1) << (63 - 43))
#define FLAG_IMAGINARY_ROOT (UINT64_C(1) << (63 - 45))
#define FLAG_INDEFINITE (UINT64_C(1) << (63 - 46))

typedef c205_word arith_binary(c205_word a, c205_word b, uint64_t *flags);
typedef c205_word arith_unary(c205_word a, uint64_t *flags);
typedef bool arith_relation(c205_word a, c205_word b);

/* arith_NAME is of words, half_NAME of half words. */
#define BINARY(name, ...) arith_binary arith_##name, half_##name;
#define UNARY(name, ...) arith_unary arith_##name, half_##name;
#define RELATION(name) arith_relation arith_##name, half_##name;
/* To the other size. */
#define CONVERSION(name, ...) arith_unary arith_##name;
#include "vm/arith.def"

#endif
