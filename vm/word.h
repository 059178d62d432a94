/* word.h - a 64-bit word as a number: its parts, its classes.
 *
 * See c205.h for the format.  The parts are taken by shifts alone, so these
 * functions may stand in loops that a compiler vectorises.
 */
#ifndef C205_WORD_H
#define C205_WORD_H

#include "c205.h"

#include <string.h>

enum {
    WORD_EXPONENT_MAX = 28671,  /* 6FFF */
    WORD_EXPONENT_MIN = -28672, /* 9000 */
    WORD_DIGITS = 47            /* bits of a coefficient without its sign */
};
#define WORD_COEFFICIENT_MASK UINT64_C(0xFFFFFFFFFFFF)
#define WORD_COEFFICIENT_MAX ((INT64_C(1) << 47) - 1)
#define WORD_COEFFICIENT_MIN (-(INT64_C(1) << 47))

static inline int32_t word_exponent(c205_word w)
{
    return (int32_t)((int64_t)w >> 48);
}

static inline int64_t word_coefficient(c205_word w)
{
    return (int64_t)(w << 16) >> 16;
}

static inline c205_word word_make(int32_t exponent, int64_t coefficient)
{
    return (c205_word)(int64_t)exponent << 48
           | ((c205_word)coefficient & WORD_COEFFICIENT_MASK);
}

static inline bool word_is_machine_zero(c205_word w)
{
    return w >> 60 == 8;
}

static inline bool word_is_indefinite(c205_word w)
{
    return w >> 60 == 7;
}

/* Bit 16 differs from bit 17, and the exponent is a usable one. */
static inline bool word_is_normalised(c205_word w)
{
    return ((w ^ w << 1) >> 47 & 1) != 0 && !word_is_machine_zero(w)
           && !word_is_indefinite(w);
}


/* The number of bits of x < 2^51 without leading zeros.  2x + 1 is put below
 * the leading bit of a double of 2^52 and that bit subtracted: what is left
 * has its length as its exponent.  Plain integers and one subtraction, so
 * that loops with it vectorise everywhere. */
static inline int32_t word_bit_length(uint64_t x)
{
    uint64_t bits = UINT64_C(0x4330000000000000) | x << 1 | 1;
    double d;

    memcpy(&d, &bits, sizeof d);
    d -= 4503599627370496.0;
    memcpy(&bits, &d, sizeof d);
    return (int32_t)(bits >> 52) - 1023;
}

/* Significant bits of -2^51 <= c < 2^51: the least n with -2^n <= c < 2^n. */
static inline int32_t word_significant_bits(int64_t c)
{
    return word_bit_length((uint64_t)(c ^ c >> 63));
}

/* c x 2^places, where that is a number of 64 bits. */
static inline int64_t word_shift_left(int64_t c, int32_t places)
{
    return (int64_t)((uint64_t)c << places);
}

/* The coefficient as it counts in arithmetic: that of machine zero is 0. */
static inline int64_t word_value_coefficient(c205_word w)
{
    return word_is_machine_zero(w) ? 0 : word_coefficient(w);
}

/* Integers that are ordered as the values of the words, indefinite left out:
 * every zero is 0, a positive value its normalised exponent, counted from 1,
 * before its coefficient, a negative one the same of its complement. */
static inline int64_t word_rank(c205_word w)
{
    const int64_t c = word_value_coefficient(w);
    const int64_t sign = c >> 63;
    const int32_t places = WORD_DIGITS - word_significant_bits(c);
    const int64_t exponent = word_exponent(w) - places
                             + (1 - WORD_EXPONENT_MIN + WORD_DIGITS);
    const int64_t digits = word_shift_left(c, places) ^ sign;

    return c == 0 ? 0 : (exponent << 47 | digits) ^ sign;
}

#endif
