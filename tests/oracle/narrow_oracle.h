/* narrow_oracle.h - a third implementation of the arithmetic, for the narrow format.
 *
 * It follows docs/arithmetic.md with 7 digits instead of 47. It uses plain integers
 * that can hold every exact result, and is fast enough for all pairs of words. Words
 * and arguments have the format of arithmetic_oracle.h with oracle_narrow.
 */
#ifndef NARROW_ORACLE_H
#define NARROW_ORACLE_H

#include "vm/number/arith.h"

enum {
    NARROW_EXPONENT_BITS = 6,
    NARROW_DIGITS = 7,
    NARROW_WIDTH = NARROW_EXPONENT_BITS + NARROW_DIGITS + 1,
    NARROW_EXPONENT_MAX = 27,
    NARROW_EXPONENT_MIN = -28
};

/* Initialises the oracle. Must be called before the first rule. */
void small_begin(void);

typedef c205_word small_rule(c205_word a, c205_word b, uint64_t *flags);

#define BINARY(name, ...) small_rule small_##name;
#define UNARY(name, ...) small_rule small_##name;
#define RELATION(name) small_rule small_##name;
#include "vm/arith.def"

/* The machine's exact rules in this format, named as in arith.h. */
#define BINARY(name, ...) arith_binary narrow_##name;
#define UNARY(name, ...) arith_unary narrow_##name;
#define RELATION(name) arith_relation narrow_##name;
#include "vm/arith.def"

/* Returns the word with this exponent and coefficient, which may be out of range. */
c205_word narrow_word(int64_t exponent, int64_t coefficient);
int64_t narrow_exponent_of(c205_word word);
int64_t narrow_coefficient_of(c205_word word);

#endif
