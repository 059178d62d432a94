/* arith.h - scalar arithmetic: the exact rule of the machine.
 *
 * Every result is defined here to the last bit, for every pair of words;
 * lanes.h does the same over whole spans and must agree.  All results are
 * cut, never rounded.  Source: machine notes, section 2 (R); where they are
 * silent the comment at the function says what this project fixed.
 *
 * Each function ORs into *flags the bits of the data flag register that the
 * operation sets.
 */
#ifndef C205_ARITH_H
#define C205_ARITH_H

#include "word.h"

/* Bits of the data flag register, numbered from the left. */
#define FLAG_DIVIDE_FAULT (UINT64_C(1) << (63 - 41))
#define FLAG_EXPONENT_OVERFLOW (UINT64_C(1) << (63 - 42))
#define FLAG_MACHINE_ZERO (UINT64_C(1) << (63 - 43))
#define FLAG_IMAGINARY_ROOT (UINT64_C(1) << (63 - 45))
#define FLAG_INDEFINITE (UINT64_C(1) << (63 - 46))

c205_word arith_add_upper(c205_word a, c205_word b, uint64_t *flags);
c205_word arith_add_lower(c205_word a, c205_word b, uint64_t *flags);
c205_word arith_add_normalised(c205_word a, c205_word b, uint64_t *flags);
c205_word arith_subtract_upper(c205_word a, c205_word b, uint64_t *flags);
c205_word arith_subtract_lower(c205_word a, c205_word b, uint64_t *flags);
c205_word arith_subtract_normalised(c205_word a, c205_word b,
                                    uint64_t *flags);
c205_word arith_multiply_upper(c205_word a, c205_word b, uint64_t *flags);
c205_word arith_multiply_lower(c205_word a, c205_word b, uint64_t *flags);
c205_word arith_multiply_significant(c205_word a, c205_word b,
                                     uint64_t *flags);
c205_word arith_divide_upper(c205_word a, c205_word b, uint64_t *flags);
c205_word arith_divide_significant(c205_word a, c205_word b,
                                   uint64_t *flags);
c205_word arith_square_root(c205_word a, uint64_t *flags);
c205_word arith_truncate(c205_word a, uint64_t *flags);
c205_word arith_floor(c205_word a, uint64_t *flags);
c205_word arith_ceiling(c205_word a, uint64_t *flags);
c205_word arith_absolute(c205_word a, uint64_t *flags);
c205_word arith_negate(c205_word a, uint64_t *flags);
c205_word arith_exponent(c205_word a, uint64_t *flags);
/* The value of a with its coefficient shifted by the integer b, or until its
 * exponent is the integer b; the integers are in the low 48 bits. */
c205_word arith_adjust_significance(c205_word a, c205_word b,
                                    uint64_t *flags);
c205_word arith_adjust_exponent(c205_word a, c205_word b, uint64_t *flags);
/* The low 16 bits of a as exponent, the coefficient of b. */
c205_word arith_pack(c205_word a, c205_word b, uint64_t *flags);
/* normalised(a +- b) with the exponent one less */
c205_word arith_average(c205_word a, c205_word b, uint64_t *flags);
c205_word arith_average_difference(c205_word a, c205_word b,
                                   uint64_t *flags);

/* The comparisons are of values; indefinite equals nothing, so that only
 * "not equal" holds for it. */
bool arith_equal(c205_word a, c205_word b);
bool arith_not_equal(c205_word a, c205_word b);
bool arith_not_less(c205_word a, c205_word b);
bool arith_less(c205_word a, c205_word b);

/* Left circular for 0..63, right with the sign extended for -1..-64; other
 * counts: n mod 64 above, -64 below. */
c205_word arith_shift(c205_word a, int64_t count);

#endif
