/* half.c - instantiates the exact rule for half words, and converts between words and
 * half words.
 */
#include "vm/number/arith.h"

#define RULE_FORMAT half_words
#define RULE(name) half_##name
#include "vm/number/rule.h"

/* ---- Conversion between the sizes --------------------------------------- */

/* The number of digits that a word has in addition to those of a half word. */
enum { MORE_DIGITS = 24 };

/* Adds a rounding term to the coefficient of a word, then contracts it to a half
 * word. */
static c205_word contracted(c205_word a, int64_t rounding, uint64_t *flags)
{
    int64_t c = (word_coefficient(a) + rounding) >> MORE_DIGITS;
    bool fits = c <= MAX_COEFFICIENT;
    if (word_is_indefinite(a))
        return indefinite(0, flags);
    if (word_is_machine_zero(a))
        return machine_zero(flags);
    return ranged(word_exponent(a) + MORE_DIGITS + !fits, c >> !fits, flags);
}

c205_word arith_contract(c205_word a, uint64_t *flags)
{
    return contracted(a, 0, flags);
}

c205_word arith_contract_rounded(c205_word a, uint64_t *flags)
{
    return contracted(a, INT64_C(1) << (MORE_DIGITS - 1), flags);
}

c205_word arith_extend(c205_word a, uint64_t *flags)
{
    if (word_is_indefinite(a))
        return indefinite(0, flags);
    if (word_is_machine_zero(a))
        return machine_zero(flags);
    return word_make(exponent_of(a) - MORE_DIGITS,
                     word_shift_left(coefficient_of(a), MORE_DIGITS));
}
