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

/* The head of a rule's definition. */
#define ORACLE_UNUSED __attribute__((unused))
#define ORACLE_RULE(name) \
    c205_word oracle_##name(const struct oracle_format *format ORACLE_UNUSED, \
                            c205_word a, c205_word b ORACLE_UNUSED, \
                            uint64_t *flags ORACLE_UNUSED)

/* Of each operation that stands by itself in vm/arith.def.  Between the sizes
 * (contract, contract_rounded: to half words; extend: to full ones) the format
 * is fixed and the argument not looked at. */
#define ELEMENTWISE(name, specials) oracle_rule oracle_##name;
#include "vm/arith.def"

/* The value of a word, exactly when value has room for it; machine zero is +0,
 * indefinite a NaN. */
void oracle_value(const struct oracle_format *format, mpfr_t value, c205_word word);

/* The normalised word of a value with no more digits, that is, of one which
 * was cut to them; NaN, infinity and range as docs/arithmetic.md has it. */
c205_word oracle_word(const struct oracle_format *format, const mpfr_t value);

#endif
