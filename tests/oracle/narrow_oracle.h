/* narrow_oracle.h - the arithmetic a third time, for the narrow format.
 *
 * docs/arithmetic.md with 7 for 47, in plain integers that hold every exact
 * result, fast enough for all pairs of words.  Words, and the arguments of
 * the rules, are those of arithmetic_oracle.h with oracle_narrow.
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

/* Before the first rule. */
void small_begin(void);

typedef c205_word small_rule(c205_word a, c205_word b, uint64_t *flags);

small_rule small_add_upper, small_add_lower, small_add_normalised;
small_rule small_subtract_upper, small_subtract_lower,
    small_subtract_normalised;
small_rule small_average, small_average_difference;
small_rule small_multiply_upper, small_multiply_lower,
    small_multiply_significant;
small_rule small_divide_upper, small_divide_significant;
small_rule small_square_root;
small_rule small_truncate, small_floor, small_ceiling, small_absolute,
    small_negate, small_exponent;
small_rule small_adjust_significance, small_adjust_exponent, small_pack;
small_rule small_equal, small_not_equal, small_not_less, small_less;
small_rule small_shift;

/* The word of an exponent and a coefficient, whatever they are. */
c205_word narrow_word(int64_t exponent, int64_t coefficient);
int64_t narrow_exponent_of(c205_word word);
int64_t narrow_coefficient_of(c205_word word);

#endif
