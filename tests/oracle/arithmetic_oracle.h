/* arithmetic_oracle.h - a second implementation of the machine's arithmetic.
 *
 * It is written from docs/arithmetic.md alone, with integers of any length (GMP) and,
 * for rules about real values, MPFR.  It shares only the names of the flags with
 * vm/number/arith.c.  It is slow and simple, and not thread safe.
 *
 * Every rule has one signature: an operation of one operand ignores b, a comparison
 * returns 1 or 0, a shift takes its count from b as an integer.  Words shorter than 64
 * bits are in the left bits of a c205_word; the other bits are zeros.
 */
#ifndef ARITHMETIC_ORACLE_H
#define ARITHMETIC_ORACLE_H

#include "vm/number/arith.h"

#include <mpfr.h>

/* A coefficient has `digits` bits and a sign; the exponent field has the rest of the
 * width.  The values 8 and 7 of its top four bits are machine zero and indefinite, and
 * the limits are the exponents between them. */
struct oracle_format {
    long width, digits;
    long exponent_min, exponent_max;
};

/* 16 + 48 bits and 8 + 24 bits; 6 + 8 bits are few enough to test all pairs of
 * words. */
extern const struct oracle_format oracle_full, oracle_half, oracle_narrow;

/* Call oracle_begin before the first rule and oracle_end after the last. */
void oracle_begin(void);
void oracle_end(void);

typedef c205_word oracle_rule(const struct oracle_format *format, c205_word a,
                              c205_word b, uint64_t *flags);

/* The head of the definition of a rule. */
#define ORACLE_UNUSED __attribute__((unused))
#define ORACLE_RULE(name) \
    c205_word oracle_##name(const struct oracle_format *format ORACLE_UNUSED, \
                            c205_word a, c205_word b ORACLE_UNUSED, \
                            uint64_t *flags ORACLE_UNUSED)

/* Declares a rule for each elementwise operation of vm/arith.def.  For conversions
 * between the sizes (contract, contract_rounded: to half words; extend: to full ones)
 * the format is fixed and the argument is ignored. */
#define ELEMENTWISE(name, specials) oracle_rule oracle_##name;
#include "vm/arith.def"

/* Define call_NAME, which calls a function of arith.h, as a rule without a format. */
#define CALL_BINARY(function) \
    static c205_word call_##function(c205_word a, c205_word b, uint64_t *flags) \
    { \
        return function(a, b, flags); \
    }
#define CALL_UNARY(function) \
    static c205_word call_##function(c205_word a, c205_word b, uint64_t *flags) \
    { \
        (void)b; \
        return function(a, flags); \
    }
#define CALL_RELATION(function) \
    static c205_word call_##function(c205_word a, c205_word b, uint64_t *flags) \
    { \
        (void)flags; \
        return function(a, b); \
    }

/* Sets value to the value of a word; it is exact if value has enough digits.  Machine
 * zero is +0, indefinite is NaN. */
void oracle_value(const struct oracle_format *format, mpfr_t value, c205_word word);

/* Returns the normalised word of a value that was cut to the digits of the format.
 * docs/arithmetic.md defines the results for NaN, infinity and the ends of the
 * range. */
c205_word oracle_word(const struct oracle_format *format, const mpfr_t value);

#endif
