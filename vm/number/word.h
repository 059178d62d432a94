/* word.h - extracts the exponent, the coefficient and the class of a word, and composes
 * words.
 *
 * See c205_word.h for the format of 64 bits. A number of another format is in the high
 * bits of a c205_word, followed by zeros:
 *
 *   | exponent | coefficient, sign and digits | zeros |
 *
 * In every format, the first four bits identify a machine zero (8) and an indefinite
 * (7). All functions use shifts only, so loops with them vectorise. The format argument
 * should be one of the constants below, because the compiler folds constants.
 */
#ifndef C205_WORD_H
#define C205_WORD_H

#include "vm/c205.h"
#include "vm/number/double_bits.h"

typedef struct word_format {
    int32_t exponent_bits; /* at least 4 */
    int32_t digits;        /* bits of a coefficient without the sign; odd, at most 47 */
} word_format;

static const word_format whole_words = { 16, 47 }; /* 64 bits */
static const word_format half_words = { 8, 23 };   /* 32 bits */

/* The limits of words of 64 bits, as constants. */
enum {
    WORD_EXPONENT_MAX = 28671,  /* 6FFF */
    WORD_EXPONENT_MIN = -28672, /* 9000 */
    WORD_DIGITS = 47
};
#define WORD_COEFFICIENT_MASK UINT64_C(0xFFFFFFFFFFFF)
#define WORD_COEFFICIENT_MAX ((INT64_C(1) << 47) - 1)
#define WORD_COEFFICIENT_MIN (-(INT64_C(1) << 47))

/* ---- Formats ------------------------------------------------------------ */

static inline int32_t format_width(word_format f)
{
    return f.exponent_bits + f.digits + 1;
}

/* Returns the number of zero bits after a number of this format in a c205_word. */
static inline int32_t format_padding(word_format f)
{
    return 64 - format_width(f);
}

static inline c205_word format_mask(word_format f)
{
    return UINT64_MAX << format_padding(f);
}

static inline c205_word format_coefficient_mask(word_format f)
{
    return UINT64_MAX >> f.exponent_bits & format_mask(f);
}

/* Return the largest and the smallest valid exponent. The first and the last sixteenth
 * of the exponents mark special words. All others are valid: 9000 .. 6FFF for words, 90
 * .. 6F for half words. */
static inline int32_t format_exponent_max(word_format f)
{
    return (7 << (f.exponent_bits - 4)) - 1;
}

static inline int32_t format_exponent_min(word_format f)
{
    return -(7 << (f.exponent_bits - 4));
}

static inline int64_t format_coefficient_min(word_format f)
{
    return -(INT64_C(1) << f.digits);
}

/* ---- Parts -------------------------------------------------------------- */

static inline int32_t format_exponent(word_format f, c205_word w)
{
    return (int32_t)((int64_t)w >> (64 - f.exponent_bits));
}

static inline int64_t format_coefficient(word_format f, c205_word w)
{
    return (int64_t)(w << f.exponent_bits) >> (63 - f.digits);
}

/* Returns the exponent of high with the coefficient of low. */
static inline c205_word format_with_coefficient(word_format f, c205_word high,
                                                c205_word low)
{
    c205_word mask = format_coefficient_mask(f);
    return (high & ~mask) | (low & mask);
}

static inline c205_word format_make(word_format f, int32_t exponent,
                                    int64_t coefficient)
{
    c205_word placed = (c205_word)coefficient << format_padding(f);
    return (c205_word)(int64_t)exponent << (64 - f.exponent_bits)
           | (placed & format_coefficient_mask(f));
}

static inline int32_t word_exponent(c205_word w)
{
    return format_exponent(whole_words, w);
}

static inline int64_t word_coefficient(c205_word w)
{
    return format_coefficient(whole_words, w);
}

static inline c205_word word_make(int32_t exponent, int64_t coefficient)
{
    return format_make(whole_words, exponent, coefficient);
}

/* ---- Classes, for every format ------------------------------------------ */

static inline bool word_is_machine_zero(c205_word w)
{
    return w >> 60 == 8;
}

static inline bool word_is_indefinite(c205_word w)
{
    return w >> 60 == 7;
}

/* Returns true if the first two bits of the coefficient differ and the exponent is
 * valid. */
static inline bool format_is_normalised(word_format f, c205_word w)
{
    return ((w ^ w << 1) >> (63 - f.exponent_bits) & 1) != 0 && !word_is_machine_zero(w)
           && !word_is_indefinite(w);
}

static inline bool word_is_normalised(c205_word w)
{
    return format_is_normalised(whole_words, w);
}

/* ---- Coefficients ------------------------------------------------------- */

/* Returns the number of bits of x < 2^51 without leading zeros. The bits of 2x + 1 are
 * placed below the leading bit of the double 2^52, and 2^52 is subtracted. The exponent
 * of the difference is the length. This takes integer operations and one subtraction,
 * so loops with it vectorise on every host. */
static inline int32_t word_bit_length(uint64_t x)
{
    double d = double_of_bits(UINT64_C(0x4330000000000000) | x << 1 | 1);
    return (int32_t)(bits_of_double(d - 4503599627370496.0) >> 52) - 1023;
}

/* Returns the significant bits of c, -2^51 <= c < 2^51: the smallest n with -2^n <= c <
 * 2^n. */
static inline int32_t word_significant_bits(int64_t c)
{
    return word_bit_length((uint64_t)(c ^ c >> 63));
}

/* Returns c x 2^places, which must fit 64 bits. */
static inline int64_t word_shift_left(int64_t c, int32_t places)
{
    return (int64_t)((uint64_t)c << places);
}

/* Returns the coefficient that arithmetic uses: 0 for a machine zero. */
static inline int64_t format_value_coefficient(word_format f, c205_word w)
{
    return word_is_machine_zero(w) ? 0 : format_coefficient(f, w);
}

static inline int64_t word_value_coefficient(c205_word w)
{
    return format_value_coefficient(whole_words, w);
}

/* Returns an integer with the order of the values. Indefinite words have no rank. The
 * rank of every zero is 0. The rank of a positive value is its normalised exponent,
 * counted from 1, followed by its coefficient. The rank of a negative value is the
 * complement of the same bits of its complement. */
static inline int64_t format_rank(word_format f, c205_word w)
{
    int64_t c = format_value_coefficient(f, w);
    int64_t sign = c >> 63;
    int32_t places = f.digits - word_significant_bits(c);
    int64_t exponent = format_exponent(f, w) - places
                       + (1 - format_exponent_min(f) + f.digits);
    int64_t digits = word_shift_left(c, places) ^ sign;
    return c == 0 ? 0 : (exponent << f.digits | digits) ^ sign;
}

/* Returns (digits + a fraction if inexact) x 2^exponent with the given sign, rounded
 * down to a normalised word. digits must be in [2^(d - 1), 2^d), where d is the number
 * of digits of the format. Values out of range become indefinite or machine zero. */
c205_word word_cut(word_format f, bool negative, int64_t digits, bool inexact,
                   int32_t exponent);

/* ---- Words as bits ------------------------------------------------------ */

/* Returns a word with the low bits of a as its exponent and the coefficient of b. */
static inline c205_word format_pack(word_format f, c205_word a, c205_word b)
{
    return a << (f.digits + 1) | (b & format_coefficient_mask(f));
}

/* Shifts a word. A count >= 0 shifts left circularly, modulo the width. A negative
 * count shifts right and copies the first bit. */
static inline c205_word format_shift(word_format f, c205_word a, int64_t count)
{
    int32_t width = format_width(f);
    uint64_t left = (uint64_t)count % (uint64_t)width;
    c205_word around = a >> (((uint64_t)width - left) & 63);
    c205_word right = (c205_word)((int64_t)a >> (count < -63 ? 63 : -count & 63));
    return (count < 0 ? right : a << left | around) & format_mask(f);
}

#endif
