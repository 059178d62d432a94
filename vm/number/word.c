/* word.c - converts words from and to doubles, integers and hexadecimal, exactly. */
#include "vm/number/word.h"

#include <math.h>
#include <stdio.h>

c205_word word_cut(word_format f, bool negative, int64_t digits, bool inexact,
                   int32_t exponent)
{
    int64_t c = negative ? -digits - inexact : digits;
    if (c == format_coefficient_min(f) / 2) {
        c = format_coefficient_min(f);
        exponent--;
    }
    if (exponent > format_exponent_max(f))
        return C205_INDEFINITE;
    if (exponent < format_exponent_min(f))
        return C205_MACHINE_ZERO;
    return format_make(f, exponent, c);
}

/* ---- Integers, doubles, hexadecimal ------------------------------------- */

c205_word c205_from_integer(int64_t value)
{
    return word_make(0, value);
}

int64_t c205_to_integer(c205_word word)
{
    return word_coefficient(word);
}

static c205_word from_double(word_format f, double value)
{
    enum { DOUBLE_DIGITS = 53 };
    int32_t excess = DOUBLE_DIGITS - f.digits;
    int exponent;
    if (!isfinite(value))
        return C205_INDEFINITE;
    if (value == 0)
        return C205_MACHINE_ZERO;
    double fraction = frexp(fabs(value), &exponent);
    int64_t digits = (int64_t)ldexp(fraction, DOUBLE_DIGITS);
    return word_cut(f, value < 0, digits >> excess,
                    (digits & ((INT64_C(1) << excess) - 1)) != 0, exponent - f.digits);
}

c205_word c205_from_double(double value)
{
    return from_double(whole_words, value);
}

c205_word c205_half_from_double(double value)
{
    return from_double(half_words, value);
}

static double to_double(word_format f, c205_word word)
{
    if (word_is_indefinite(word))
        return NAN;
    if (word_is_machine_zero(word))
        return 0;
    return ldexp((double)format_coefficient(f, word), format_exponent(f, word));
}

double c205_to_double(c205_word word)
{
    return to_double(whole_words, word);
}

double c205_half_to_double(c205_word half)
{
    return to_double(half_words, half);
}

void c205_to_hex(c205_word word, char text[C205_TEXT_SIZE])
{
    snprintf(text, C205_TEXT_SIZE, "%04X %04X %04X %04X", (unsigned)(word >> 48),
             (unsigned)(word >> 32 & 0xFFFF), (unsigned)(word >> 16 & 0xFFFF),
             (unsigned)(word & 0xFFFF));
}
