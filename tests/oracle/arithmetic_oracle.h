/* arithmetic_oracle.h - the arithmetic of the machine, a second time.
 *
 * Written from docs/arithmetic.md alone, with integers of any length (GMP)
 * and, where the rule speaks of real values, MPFR.  It shares nothing with
 * vm/number/arith.c but the names of the flags.  Slow and plain, not thread safe.
 *
 * Every rule has one signature: an operation of one operand ignores b, a
 * comparison gives 1 or 0, a shift takes its count from b as an integer.
 * Words shorter than 64 bits are in the left bits of a c205_word, zeros in
 * the others.
 */
#ifndef ARITHMETIC_ORACLE_H
#define ARITHMETIC_ORACLE_H

#include "vm/number/arith.h"

#include <mpfr.h>

/* A coefficient is `digits` bits and a sign.  The exponent field has what is
 * left of the width; in its top four bits 8 is machine zero and 7
 * indefinite, so the limits are what lies between. */
struct oracle_format {
    long width, digits;
    long exponent_min, exponent_max;
};

/* 16 + 48 bits, 8 + 24 bits; and 6 + 8 bits, few enough to try all pairs of
 * words. */
extern const struct oracle_format oracle_full, oracle_half, oracle_narrow;

/* Before the first rule and after the last. */
void oracle_begin(void);
void oracle_end(void);

typedef c205_word oracle_rule(const struct oracle_format *format, c205_word a,
                              c205_word b, uint64_t *flags);

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

/* Between the sizes: from full words to half words, and from half to full.
 * The format is fixed and the argument not looked at. */
oracle_rule oracle_contract, oracle_contract_rounded, oracle_extend;

/* The value of a word, exactly when value has room for it; machine zero is +0,
 * indefinite a NaN. */
void oracle_value(const struct oracle_format *format, mpfr_t value,
                  c205_word word);

/* The normalised word of a value with no more digits, that is, of one which
 * was cut to them; NaN, infinity and range as docs/arithmetic.md has it. */
c205_word oracle_word(const struct oracle_format *format, const mpfr_t value);

#endif
