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
typedef c205_word arith_shifted(c205_word a, int64_t count);

/* The functions of one format; of(name) is what a name is there.
 *
 * adjust_significance, adjust_exponent: the value of a with its coefficient
 * shifted by the integer b, or until its exponent is the integer b; the
 * integers are coefficients, whatever their exponents.
 * pack: the low bits of a as exponent, the coefficient of b.
 * average: normalised(a +- b) with the exponent one less.
 * equal .. less: of values; indefinite equals nothing, so that only "not
 * equal" holds for it.
 * shift: left circular for 0 up to the width less one, right with the sign
 * extended for -1 down to the negative width; other counts: modulo the
 * width above, as the negative width below. */
#define ARITH_FUNCTIONS(of) \
    arith_binary of(add_upper), of(add_lower), of(add_normalised); \
    arith_binary of(subtract_upper), of(subtract_lower), \
        of(subtract_normalised); \
    arith_binary of(multiply_upper), of(multiply_lower), \
        of(multiply_significant); \
    arith_binary of(divide_upper), of(divide_significant); \
    arith_binary of(average), of(average_difference); \
    arith_binary of(adjust_significance), of(adjust_exponent), of(pack); \
    arith_unary of(square_root); \
    arith_unary of(truncate), of(floor), of(ceiling); \
    arith_unary of(absolute), of(negate), of(exponent); \
    arith_relation of(equal), of(not_equal), of(not_less), of(less); \
    arith_shifted of(shift)

#define ARITH_OF_WORDS(name) arith_##name
#define ARITH_OF_HALVES(name) half_##name
ARITH_FUNCTIONS(ARITH_OF_WORDS);
ARITH_FUNCTIONS(ARITH_OF_HALVES);

/* A word as half word, its coefficient floored or rounded; it is not
 * normalised. */
arith_unary arith_contract, arith_contract_rounded;
/* A half word as word, exactly. */
arith_unary arith_extend;

#endif
