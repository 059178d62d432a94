/* arithmetic_oracle.h - the arithmetic of the machine, a second time.
 *
 * Written from docs/arithmetic.md alone, with integers of any length (GMP)
 * and, where the rule speaks of real values, MPFR.  It shares nothing with
 * vm/arith.c but the names of the flags.  Slow and plain, not thread safe.
 *
 * Every rule has one signature: an operation of one operand ignores b, a
 * comparison gives 1 or 0, a shift takes its count from b as an integer.
 */
#ifndef ARITHMETIC_ORACLE_H
#define ARITHMETIC_ORACLE_H

#include "vm/arith.h"

#include <mpfr.h>

/* Before the first rule and after the last. */
void oracle_begin(void);
void oracle_end(void);

typedef c205_word oracle_rule(c205_word a, c205_word b, uint64_t *flags);

oracle_rule oracle_add_upper, oracle_add_lower, oracle_add_normalised;
oracle_rule oracle_subtract_upper, oracle_subtract_lower,
    oracle_subtract_normalised;
oracle_rule oracle_average, oracle_average_difference;
oracle_rule oracle_multiply_upper, oracle_multiply_lower,
    oracle_multiply_significant;
oracle_rule oracle_divide_upper, oracle_divide_significant;
oracle_rule oracle_square_root;
oracle_rule oracle_truncate, oracle_floor, oracle_ceiling, oracle_absolute,
    oracle_negate, oracle_exponent;
oracle_rule oracle_adjust_significance, oracle_adjust_exponent, oracle_pack;
oracle_rule oracle_equal, oracle_not_equal, oracle_not_less, oracle_less;
oracle_rule oracle_shift;
oracle_rule oracle_xor, oracle_and, oracle_or, oracle_nand, oracle_nor,
    oracle_or_not, oracle_and_not, oracle_equivalence;
oracle_rule oracle_add_index, oracle_subtract_index;
oracle_rule oracle_copy;

/* The value of a word, exactly when value has 48 bits or more; machine zero
 * is +0, indefinite a NaN. */
void oracle_value(mpfr_t value, c205_word word);

/* The normalised word of a value of at most 47 bits, that is, of one which
 * was cut to them; NaN, infinity and range as docs/arithmetic.md has it. */
c205_word oracle_word(const mpfr_t value);

#endif
