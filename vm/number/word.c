/* word.c - words from and to doubles, integers and text, all exactly. */
#include "vm/number/word.h"

#include "vm/number/big.h"

#include <math.h>
#include <stdio.h>

/* The magnitude (digits + a fraction, if inexact) x 2^exponent with digits
 * in [2^(d - 1), 2^d), d the digits of the format, and a sign, floored to a
 * normalised word. */
static c205_word cut(word_format f, bool negative, int64_t digits,
                     bool inexact, int32_t exponent)
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
    return cut(f, value < 0, digits >> excess,
               (digits & ((INT64_C(1) << excess) - 1)) != 0,
               exponent - f.digits);
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
    return ldexp((double)format_coefficient(f, word),
                 format_exponent(f, word));
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
    snprintf(text, C205_TEXT_SIZE, "%04X %04X %04X %04X",
             (unsigned)(word >> 48), (unsigned)(word >> 32 & 0xFFFF),
             (unsigned)(word >> 16 & 0xFFFF), (unsigned)(word & 0xFFFF));
}

/* ---- From decimal text ---------------------------------------------------
 *
 * Every word is a multiple of 2^-28672, below 2^28718: it has no more than
 * 20,100 digits, and its first stands within 8,700 places of the point.  So
 * whatever follows the first 20,100 digits of a text cannot reach the next
 * word: it is enough to know whether it is zero.
 */
enum {
    DIGITS_MAX = 20100,
    PLACES_MAX = 8700,
    EXPONENT_LIMIT = 100000000 /* more is as good as this */
};

typedef struct decimal {
    bool negative, inexact; /* inexact: digits other than 0 left out */
    size_t length;          /* digits in number, from the first that is not
                               0 */
    int64_t exponent;       /* value = number x 10^exponent */
    big number;
} decimal;

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static void take_digit(decimal *d, uint32_t digit, bool after_point)
{
    if (d->length == DIGITS_MAX) {
        d->inexact |= digit != 0;
        d->exponent += !after_point;
        return;
    }
    big_multiply(&d->number, 10, digit);
    d->length += d->length > 0 || digit > 0;
    d->exponent -= after_point;
}

/* Digits with a point among them or not; NULL: there are none. */
static const char *take_digits(decimal *d, const char *text)
{
    bool after_point = false, any = false;

    for (;; text++) {
        if (is_digit(*text)) {
            take_digit(d, (uint32_t)(*text - '0'), after_point);
            any = true;
        } else if (*text == '.' && !after_point) {
            after_point = true;
        } else {
            return any ? text : NULL;
        }
    }
}

/* "e-12"; what does not read so is left alone. */
static const char *take_exponent(decimal *d, const char *text)
{
    const char *p = text + 1;
    int64_t exponent = 0;

    if (*text != 'e' && *text != 'E')
        return text;
    bool negative = *p == '-';
    if (*p == '-' || *p == '+')
        p++;
    if (!is_digit(*p))
        return text;
    for (; is_digit(*p); p++)
        if (exponent < EXPONENT_LIMIT)
            exponent = exponent * 10 + (*p - '0');
    d->exponent += negative ? -exponent : exponent;
    return p;
}

/* number x 10^power as floor(number' x 2^*exponent), of 64 bits or more. */
static bool scale(big *number, int32_t power, int32_t *exponent)
{
    bool inexact = false;

    *exponent = power;
    if (power >= 0) {
        big_multiply_power_of_5(number, power);
    } else {
        /* 5^p < 2^(7p/3), and so the quotient keeps over 64 bits */
        int32_t room = 64 + -power / 3 * 7 + 7 - big_bit_length(number);
        int32_t places = room > 0 ? room : 0;
        big_shift_left(number, places);
        *exponent -= places;
        inexact = big_divide_power_of_5(number, -power);
    }
    return inexact;
}

static c205_word word_of_decimal(word_format f, decimal *d)
{
    int32_t exponent;

    if (d->length == 0)
        return C205_MACHINE_ZERO;
    int64_t places = (int64_t)d->length + d->exponent;
    if (places < -PLACES_MAX)
        return C205_MACHINE_ZERO;
    if (places > PLACES_MAX)
        return C205_INDEFINITE;
    d->inexact |= scale(&d->number, (int32_t)d->exponent, &exponent);
    int32_t excess = big_bit_length(&d->number) - f.digits;
    if (excess > 0)
        d->inexact |= big_shift_right(&d->number, excess);
    else
        big_shift_left(&d->number, -excess);
    return cut(f, d->negative, (int64_t)big_low(&d->number), d->inexact,
               exponent + excess);
}

static c205_word from_text(word_format f, const char *text, const char **end)
{
    decimal d = { .negative = *text == '-' };
    const char *p = take_digits(&d, *text == '-' || *text == '+' ? text + 1
                                                                 : text);
    if (!p) {
        *end = text;
        return C205_MACHINE_ZERO;
    }
    *end = take_exponent(&d, p);
    return word_of_decimal(f, &d);
}

c205_word c205_from_text(const char *text, const char **end)
{
    return from_text(whole_words, text, end);
}

c205_word c205_half_from_text(const char *text, const char **end)
{
    return from_text(half_words, text, end);
}

/* ---- To decimal text -----------------------------------------------------
 *
 * All reals from c x 2^e up to, but not including, (c + 1) x 2^e read back as
 * the normalised word (e, c).  Their magnitudes are counted in units of a
 * small power of ten, then of ever greater ones, as long as a whole number
 * of units lies among them; of those the one nearest to the word is taken.
 */

/* floor(c x 2^exponent / 10^power), or the ceiling. */
static uint64_t count_units(int64_t c, int32_t exponent, int32_t power,
                            bool ceiling)
{
    int32_t twos = exponent - power;
    bool lost = false;
    big number;

    big_set(&number, (uint64_t)c);
    if (twos > 0)
        big_shift_left(&number, twos);
    if (power < 0)
        big_multiply_power_of_5(&number, -power);
    else
        lost = big_divide_power_of_5(&number, power);
    if (twos < 0)
        lost |= big_shift_right(&number, -twos);
    return big_low(&number) + (ceiling && lost);
}

typedef struct digits {
    uint64_t number;
    int32_t power; /* of ten */
} digits;

/* A number of units lies among them if the least not below the one end lies
 * below the other; of magnitudes of negative words, if the greatest not
 * above the one lies above the other. */
static digits shortest(word_format f, int64_t c, int32_t exponent)
{
    bool negative = c < 0;
    int64_t near = negative ? -c : c;
    int64_t far = negative ? near - 1 : near + 1;
    /* 18 or 19 digits: log10(2) is 0.30103 */
    int32_t twos = exponent + f.digits - 1;
    int32_t log10 = (int32_t)floor(twos * 0.30103);
    digits d = { 0, log10 - 17 };
    uint64_t from = count_units(near, exponent, d.power, !negative);
    uint64_t to = count_units(far, exponent, d.power, !negative);

    do {
        d.number = from;
        d.power++;
        from = from / 10 + (!negative && from % 10 != 0);
        to = to / 10 + (!negative && to % 10 != 0);
    } while (from != to);
    d.power--;
    return d;
}

/* Plainly, when the point is near to the digits; or with an exponent. */
static void write_decimal(char *text, bool negative, digits d)
{
    enum { LEAST = -4, GREATEST = 16 };
    char number[24];
    int length = snprintf(number, sizeof number, "%llu",
                          (unsigned long long)d.number);
    int places = length + d.power; /* before the point */
    const char *sign = negative ? "-" : "";
    const char *point = length > 1 ? "." : "";

    if (places < LEAST || places > GREATEST)
        snprintf(text, C205_TEXT_SIZE, "%s%.1s%s%se%d", sign, number, point,
                 number + 1, places - 1);
    else if (places <= 0)
        snprintf(text, C205_TEXT_SIZE, "%s0.%.*s%s", sign, -places, "0000",
                 number);
    else if (places < length)
        snprintf(text, C205_TEXT_SIZE, "%s%.*s.%s", sign, places, number,
                 number + places);
    else
        snprintf(text, C205_TEXT_SIZE, "%s%s%.*s", sign, number, d.power,
                 "000000000000000");
}

static void to_text(word_format f, c205_word word, char text[C205_TEXT_SIZE])
{
    int64_t c = format_value_coefficient(f, word);
    int32_t places = f.digits - word_significant_bits(c);

    if (word_is_indefinite(word))
        snprintf(text, C205_TEXT_SIZE, "indefinite");
    else if (c == 0)
        snprintf(text, C205_TEXT_SIZE, "0");
    else
        write_decimal(text, c < 0,
                      shortest(f, word_shift_left(c, places),
                               format_exponent(f, word) - places));
}

void c205_to_text(c205_word word, char text[C205_TEXT_SIZE])
{
    to_text(whole_words, word, text);
}

void c205_half_to_text(c205_word half, char text[C205_TEXT_SIZE])
{
    to_text(half_words, half, text);
}
