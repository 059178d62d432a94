/* arithmetic_oracle.h - a second implementation of the machine's arithmetic.
 *
 * Its only source is docs/arithmetic.md. It uses integers of any length (GMP) and, for
 * rules about real values, MPFR. It shares only the names of the flags with
 * vm/number/arith.c. It is slow and simple, and not thread safe.
 *
 * All rules have the same signature. An operation of one operand ignores b. A
 * comparison returns 1 or 0. A shift takes its count from b as an integer. Words
 * shorter than 64 bits are in the left bits of a c205_word; the other bits are zeros.
 */
#ifndef ARITHMETIC_ORACLE_H
#define ARITHMETIC_ORACLE_H

#include "vm/number/arith.h"

#include <mpfr.h>

/* A word consists of an exponent field and a coefficient with a sign and `digits` bits.
 * If the top four bits of the exponent field are 8, the word is machine zero; if they
 * are 7, it is indefinite. The other exponents are valid. */
struct oracle_format {
    long width, digits;
    long exponent_min, exponent_max;
};

/* Words of 16 + 48, 8 + 24 and 6 + 8 bits. All pairs of the last can be tested. */
extern const struct oracle_format oracle_full, oracle_half, oracle_narrow;

/* Call oracle_begin before the first rule, and oracle_end after the last rule. */
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

/* A rule for each elementwise operation of vm/arith.def. Conversions between word sizes
 * have a fixed format and ignore the argument `format`: contract and contract_rounded
 * return half words, extend returns full words. */
#define ELEMENTWISE(name, specials) oracle_rule oracle_##name;
#include "vm/arith.def"

/* Each macro defines call_NAME: a function of arith.h as a rule without a format. */
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

/* Sets value to the value of a word. The result is exact if value has enough digits.
 * Machine zero becomes +0, indefinite NaN. */
void oracle_value(const struct oracle_format *format, mpfr_t value, c205_word word);

/* Returns the normalised word of a value that has been truncated to the digits of the
 * format. docs/arithmetic.md defines NaN, infinity and the ends of the range. */
c205_word oracle_word(const struct oracle_format *format, const mpfr_t value);

#endif
