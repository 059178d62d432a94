/* decimal.c - converts words from and to decimal text exactly. */
#include "vm/number/word.h"

#include "vm/number/big.h"

#include <math.h>
#include <stdio.h>

/* ---- From decimal text -----------------------------------------------------
 *
 * Every word is a multiple of 2^-28672 and below 2^28718. A word therefore has at most
 * 20,100 decimal digits, and its first digit is within 8,700 places of the point.
 * Digits after the first 20,100 cannot change the result, except that it matters
 * whether they are all zero.
 */
enum {
    DIGITS_MAX = 20100,
    PLACES_MAX = 8700,
    EXPONENT_LIMIT = 100000000 /* larger exponents have the same effect */
};

typedef struct decimal {
    bool negative, inexact; /* inexact: nonzero digits were dropped */
    size_t length;          /* number of digits from the first nonzero digit on */
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

/* Reads digits with an optional point. Returns the end, or NULL if there is no
 * digit. */
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

/* Reads an exponent such as "e-12". Returns text unchanged if there is none. */
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

/* Replaces number by number' so that number x 10^power is number' x 2^*exponent,
 * rounded down. Returns true if the result is inexact; number' then has at least 64
 * bits. */
static bool scale(big *number, int32_t power, int32_t *exponent)
{
    bool inexact = false;
    *exponent = power;
    if (power >= 0) {
        big_multiply_power_of_5(number, power);
    } else {
        /* 5^p < 2^(7p/3) for p = -power, so the quotient keeps more than 64 bits. */
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
    return word_cut(f, d->negative, (int64_t)big_low(&d->number), d->inexact,
                    exponent + excess);
}

static c205_word from_text(word_format f, const char *text, const char **end)
{
    decimal d = { .negative = *text == '-' };
    const char *p = take_digits(&d, *text == '-' || *text == '+' ? text + 1 : text);
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

/* ---- To decimal text -------------------------------------------------------
 *
 * All reals from c x 2^e up to, but not including, (c + 1) x 2^e read back as the
 * normalised word (e, c). The shortest text is a multiple of the largest possible power
 * of ten, its unit. The search starts with a small power of ten and multiplies it by
 * ten as long as the interval contains a multiple. If the interval contains several
 * multiples of the last unit, the result is the multiple nearest to the word.
 */

/* Returns floor(c x 2^exponent / 10^power). Sets *lost if the remainder is not 0. */
static uint64_t whole_units(int64_t c, int32_t exponent, int32_t power, bool *lost)
{
    int32_t twos = exponent - power;
    big number;
    *lost = false;
    big_set(&number, (uint64_t)c);
    if (twos > 0)
        big_shift_left(&number, twos);
    if (power < 0)
        big_multiply_power_of_5(&number, -power);
    else
        *lost = big_divide_power_of_5(&number, power);
    if (twos < 0)
        *lost |= big_shift_right(&number, -twos);
    return big_low(&number);
}

/* Returns c x 2^exponent / 10^power, rounded up if ceiling is set and down
 * otherwise. */
static uint64_t count_units(int64_t c, int32_t exponent, int32_t power, bool ceiling)
{
    bool lost;
    uint64_t units = whole_units(c, exponent, power, &lost);
    return units + (ceiling && lost);
}

typedef struct digits {
    uint64_t number;
    int32_t power; /* power of ten */
} digits;

/* Returns the decimal exponent p of the smallest positive normalised word w with the
 * given binary exponent: 10^p <= w < 10^(p + 1). No power of two in this range is
 * within 1e-5 of a power of ten, relative to its value. Ten digits of log10(2)
 * therefore suffice. */
static int32_t power_below(word_format f, int32_t exponent)
{
    return (int32_t)floor((exponent + f.digits - 1) * 0.301029995663981);
}

/* Returns the shortest decimal number that is rounded down to the word c x 2^exponent.
 * Such numbers are between the word and the next word, in the interval from near to
 * far. Both ends are expressed in larger and larger powers of ten as long as the
 * interval contains a multiple of the power. For a negative word the magnitudes
 * decrease from near to far. */
static digits shortest(word_format f, int64_t c, int32_t exponent)
{
    bool negative = c < 0;
    int64_t near = negative ? -c : c;
    int64_t far = negative ? near - 1 : near + 1;
    digits d = { 0, power_below(f, exponent) - 17 };
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

/* Writes fixed notation if the point is near the digits, and an exponent otherwise. */
static void write_decimal(char *text, bool negative, digits d)
{
    enum { MIN_PLACES = -4, MAX_PLACES = 16 };
    char number[24];
    int length = snprintf(number, sizeof number, "%llu", (unsigned long long)d.number);
    int places = length + d.power; /* digits before the point */
    const char *sign = negative ? "-" : "";
    const char *point = length > 1 ? "." : "";
    if (places < MIN_PLACES || places > MAX_PLACES)
        snprintf(text, C205_TEXT_SIZE, "%s%.1s%s%se%d", sign, number, point, number + 1,
                 places - 1);
    else if (places <= 0)
        snprintf(text, C205_TEXT_SIZE, "%s0.%.*s%s", sign, -places, "0000", number);
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

/* ---- To a given number of digits ---------------------------------------- */

/* Returns c x 2^exponent in units of 10^power, rounded to the nearest integer, ties to
 * even. */
static uint64_t nearest_units(int64_t c, int32_t exponent, int32_t power)
{
    bool lost;
    uint64_t halves = whole_units(c, exponent + 1, power, &lost);
    uint64_t units = halves / 2;
    return units + (halves % 2 != 0 && (lost || units % 2 != 0));
}

static uint64_t power_of_10(unsigned power)
{
    uint64_t value = 1;
    while (power-- > 0)
        value *= 10;
    return value;
}

/* Writes units x 10^-places with a decimal point. */
static void write_fixed(char *text, bool negative, uint64_t units, unsigned places)
{
    char number[24];
    int length = snprintf(number, sizeof number, "%0*llu", (int)places + 1,
                          (unsigned long long)units);
    snprintf(text, C205_TEXT_SIZE, "%s%.*s%s%s", negative && units > 0 ? "-" : "",
             length - (int)places, number, places > 0 ? "." : "",
             number + length - places);
}

/* Writes the number in fixed notation. Returns false if it would have more than
 * C205_DIGITS digits. */
static bool try_fixed(char *text, bool negative, uint64_t c, int32_t exponent,
                      unsigned places)
{
    uint64_t units = 0;
    if (c != 0
        && power_below(whole_words, exponent) + 1 + (int32_t)places > C205_DIGITS)
        return false;
    if (c != 0)
        units = nearest_units((int64_t)c, exponent, -(int32_t)places);
    if (units >= power_of_10(C205_DIGITS))
        return false;
    write_fixed(text, negative, units, places);
    return true;
}

static void write_scientific(char *text, bool negative, uint64_t c, int32_t exponent,
                             unsigned count)
{
    int32_t power = power_below(whole_words, exponent) + 1 - (int32_t)count;
    uint64_t units = nearest_units((int64_t)c, exponent, power);
    while (units >= power_of_10(count)) /* rounding changed 9.99 to 10.0 */
        units = nearest_units((int64_t)c, exponent, ++power);
    write_fixed(text, negative, units, count - 1);
    size_t length = strlen(text);
    snprintf(text + length, C205_TEXT_SIZE - length, "e%d",
             c == 0 ? 0 : (int)power + (int)count - 1);
}

void c205_to_decimal(c205_word word, c205_notation notation, unsigned count,
                     char text[C205_TEXT_SIZE])
{
    word_format f = whole_words;
    int64_t c = format_value_coefficient(f, word);
    int32_t places = f.digits - word_significant_bits(c);
    int32_t exponent = c == 0 ? 0 : format_exponent(f, word) - places;
    int64_t normalised = word_shift_left(c, places);
    uint64_t magnitude = (uint64_t)(c < 0 ? -normalised : normalised);
    unsigned most = C205_DIGITS - (notation == C205_FIXED);
    count = count > most ? most : count;
    if (word_is_indefinite(word))
        snprintf(text, C205_TEXT_SIZE, "indefinite");
    else if (notation == C205_SCIENTIFIC
             || !try_fixed(text, c < 0, magnitude, exponent, count))
        write_scientific(text, c < 0, magnitude, exponent,
                         count + (notation == C205_FIXED || count == 0));
}
