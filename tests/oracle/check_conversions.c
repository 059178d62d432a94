/* check_conversions.c - compares conversions of random doubles, integers and texts with
 * MPFR. A conversion fails if a word, a text or the end of a number differs. */
#include "operands.h"
#include "operations.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DIGITS = 400, TEXT = DIGITS + 64 };

static const struct converters words = {
    &oracle_full, c205_from_double, c205_to_double, c205_from_text, c205_to_text,
};
static const struct converters halves = {
    &oracle_half,        c205_half_from_double, c205_half_to_double,
    c205_half_from_text, c205_half_to_text,
};

static bool same_word(const char *what, c205_word expected, c205_word got)
{
    if (expected != got)
        printf("%s: expected %016" PRIX64 ", got %016" PRIX64 "\n", what, expected,
               got);
    return expected == got;
}

static bool same_text(c205_word word, const char *expected, const char *got)
{
    if (strcmp(expected, got) == 0)
        return true;
    printf("%016" PRIX64 ": expected \"%s\", got \"%s\"\n", word, expected, got);
    return false;
}

/* An exact value, and a value with the digits of the format. */
static mpfr_t exact, cut;

/* ---- Doubles ------------------------------------------------------------ */

static double double_from_bits(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Returns a power of two in the range that full words and doubles share, or one near
 * 2^134 and 2^-90, the largest and the smallest half word. */
static int64_t usual_power(uint64_t *random)
{
    static const int64_t ends[] = { 134, -90 };
    int64_t end = ends[random_bits(random) % 2];
    return random_bits(random) % 4 == 0 ? end + random_between(random, -3, 3)
                                        : random_between(random, -60, 60);
}

/* Returns a random double. One in two is of common size, one in three has few bits. */
static double random_double(uint64_t *random)
{
    uint64_t choice = random_bits(random);
    uint64_t bits = random_bits(random);
    if (choice % 2 == 0) {
        int64_t exponent = 1023 + usual_power(random);
        bits = bits >> 63 << 63 | bits << 12 >> 12 | (uint64_t)exponent << 52;
    }
    if (choice % 3 == 0)
        bits &= ~UINT64_C(0) << random_between(random, 0, 63);
    return double_from_bits(bits);
}

static bool from_double_agrees(const struct converters *as, uint64_t *random)
{
    double value = random_double(random);
    char what[64];
    mpfr_set_d(cut, value, MPFR_RNDD);
    snprintf(what, sizeof what, "from %a", value);
    return same_word(what, oracle_word(as->format, cut), as->from_double(value));
}

/* Returns a word that is near the range of a double, or far outside of it. */
static c205_word word_near_doubles(const struct oracle_format *format, uint64_t *random)
{
    long bits = format->width - format->digits - 1;
    c205_word digits = random_word(format, random) << bits >> bits;
    int64_t low = format->exponent_min, high = format->exponent_max;
    int64_t exponent = random_between(random, low < -1200 ? -1200 : low,
                                      high > 1100 ? 1100 : high);
    return random_bits(random) % 4 == 0 ? random_word(format, random)
                                        : (c205_word)exponent << (64 - bits) | digits;
}

static bool to_double_agrees(const struct converters *as, uint64_t *random)
{
    c205_word word = word_near_doubles(as->format, random);
    oracle_value(as->format, exact, word);
    double expected = mpfr_get_d(exact, MPFR_RNDN);
    double got = as->to_double(word);
    if (expected != expected ? got != got : !memcmp(&expected, &got, sizeof got))
        return true;
    printf("%016" PRIX64 ": expected %a, got %a\n", word, expected, got);
    return false;
}

/* ---- Integers ----------------------------------------------------------- */

static bool from_integer_agrees(const struct converters *as, uint64_t *random)
{
    int64_t end = INT64_C(1) << random_between(random, 0, 47);
    int64_t value = random_between(random, -end, end - 1);
    char what[64];
    mpfr_set_si(exact, value, MPFR_RNDD);
    c205_word word = c205_from_integer(value);
    oracle_value(as->format, exact, word);
    bool right = mpfr_cmp_si(exact, value) == 0 && word >> 48 == 0;
    snprintf(what, sizeof what, "from %" PRId64, value);
    return right || same_word(what, (c205_word)value << 16 >> 16, word);
}

static bool to_integer_agrees(const struct converters *as, uint64_t *random)
{
    c205_word word = random_word(as->format, random);
    int64_t low = (int64_t)(word % (UINT64_C(1) << 48));
    int64_t expected = low >= INT64_C(1) << 47 ? low - (INT64_C(1) << 48) : low;
    int64_t got = c205_to_integer(word);
    if (got != expected)
        printf("%016" PRIX64 ": expected %" PRId64 ", got %" PRId64 "\n", word,
               expected, got);
    return got == expected;
}

/* ---- Text to words ------------------------------------------------------ */

static const char *chosen(uint64_t *random, const char *const *texts, size_t count)
{
    return texts[random_bits(random) % count];
}

#define CHOSEN(random, texts) chosen(random, texts, sizeof texts / sizeof texts[0])

/* Makes the decimal digits of 0.DDD * 10^*exponent. They are random, or the digits of a
 * random word, rounded down or up. */
static void random_digits(const struct converters *as, uint64_t *random,
                          char digits[DIGITS + 2], long *exponent)
{
    size_t wanted = (size_t)random_between(random, 1,
                                           random_bits(random) % 2 ? 20 : DIGITS);
    mpfr_rnd_t way = random_bits(random) % 2 ? MPFR_RNDU : MPFR_RNDD;
    oracle_value(as->format, exact, word_near_doubles(as->format, random));
    mpfr_abs(exact, exact, MPFR_RNDD);
    mpfr_exp_t point = 0;
    if (mpfr_regular_p(exact))
        mpfr_get_str(digits, &point, 10, wanted, exact, way);
    else
        snprintf(digits, DIGITS, "%" PRIu64, random_bits(random));
    *exponent = point;
}

/* Makes a text of a sign, digits with a point at a random position, an exponent if
 * needed, and characters that do not belong to the number. */
static void random_text(const struct converters *as, uint64_t *random, char text[TEXT])
{
    static const char *const signs[] = { "", "", "+", "-", "-" };
    static const char *const heads[] = { "", "", "", "0", "000" };
    static const char *const marks[] = { "e", "E" };
    static const char *const tails[] = { "", "", ")", ",3", " 1", "e", "E+" };
    char digits[DIGITS + 2], power[32] = "";
    long exponent;
    random_digits(as, random, digits, &exponent);
    long n = (long)strlen(digits);
    long point = random_between(random, 0, n);
    if (exponent >= 0 && exponent <= n && random_bits(random) % 2)
        point = exponent;
    if (point != exponent)
        snprintf(power, sizeof power, "%s%s%ld", CHOSEN(random, marks),
                 exponent > point && random_bits(random) % 2 ? "+" : "",
                 exponent - point);
    snprintf(text, TEXT, "%s%s%.*s%s%s%s%s", CHOSEN(random, signs),
             CHOSEN(random, heads), (int)point, digits,
             point < n || random_bits(random) % 2 ? "." : "", digits + point, power,
             CHOSEN(random, tails));
}

static void odd_text(const struct converters *as, uint64_t *random, char text[TEXT])
{
    static const char *const texts[] = {
        "", "-", "+", ".", "-.", "e5", ".e5", "+-1", "--1", "x", "0", "-0", "0.0",
        "-.0e5", "1e999999999999999999999", "-1e99999999999999999999",
        "1e-99999999999999999999", "-1e-99999999999999999999",
        "0e999999999999999999999", "1.2.3", "5e+", "5e-x", "7.", ".7", "1e9000",
        "-1e9000", "1e-9000", "1e8645", "1e8646", "1e-8617", "1e-8618",
        "140737488355327", "140737488355328", "-140737488355328", "-140737488355329",
        "140737488355328.99999999999999999999999999",
        "-140737488355328.00000000000000000000000000000000000000000000001",
        /* the limits of half words */
        "8388607", "8388608", "-8388608", "-8388609", "8388608.99999999", "21778069e33",
        "21778071e33", "21778072e33", "-21778071e33", "-21778072e33", "8e-28",
        "8077e-31", "8078e-31", "-8e-28"
    };
    (void)as;
    snprintf(text, TEXT, "%s", CHOSEN(random, texts));
}

static bool from_text_agrees(const struct converters *as, uint64_t *random)
{
    char text[TEXT];
    char *expected_end;
    const char *end;
    (random_bits(random) % 16 == 0 ? odd_text : random_text)(as, random, text);
    mpfr_strtofr(cut, text, &expected_end, 10, MPFR_RNDD);
    c205_word expected = oracle_word(as->format, cut);
    c205_word got = as->from_text(text, &end);
    if (end != expected_end)
        printf("\"%s\": ends at \"%s\", not at \"%s\"\n", text, expected_end, end);
    return end == expected_end && (end == text || same_word(text, expected, got));
}

/* ---- Words to text ------------------------------------------------------ */

/* Returns the number of digits without leading and trailing zeros. */
static size_t significant_digits(const char *text)
{
    size_t digits = 0, zeros = 0;
    for (; *text != '\0' && *text != 'e' && *text != 'E'; text++) {
        if (*text == '0')
            zeros += digits > 0;
        else if (*text >= '1' && *text <= '9') {
            digits += zeros + 1;
            zeros = 0;
        }
    }
    return digits;
}

/* Reading truncates, so the texts that read back as `value` are those from `value` up
 * to the next word. The least number of n digits from `value` on suffices. */
static bool fewer_digits_do(const mpfr_t value, size_t digits)
{
    bool negative = mpfr_sgn(value) < 0;
    char shorter[64], text[128];
    mpfr_exp_t point;
    if (digits < 2)
        return false;
    mpfr_get_str(shorter, &point, 10, digits - 1, value, MPFR_RNDU);
    snprintf(text, sizeof text, "%s0.%se%ld", negative ? "-" : "", shorter + negative,
             (long)point);
    mpfr_strtofr(cut, text, NULL, 10, MPFR_RNDD);
    return mpfr_equal_p(cut, value) != 0;
}

/* Reads the text with MPFR, and with the machine if the value is in its range. */
static bool reads_back(const struct converters *as, const mpfr_t value,
                       const char *text)
{
    char *expected_end;
    const char *end;
    mpfr_strtofr(cut, text, &expected_end, 10, MPFR_RNDD);
    bool same = *expected_end == '\0' && mpfr_equal_p(cut, value);
    return same && as->from_text(text, &end) == oracle_word(as->format, value)
           && *end == '\0';
}

static bool text_is_right(const struct converters *as, c205_word word,
                          const mpfr_t value, const char *text)
{
    if (mpfr_nan_p(value))
        return same_text(word, "indefinite", text);
    if (mpfr_zero_p(value))
        return same_text(word, "0", text);
    bool back = reads_back(as, value, text);
    bool fewer = fewer_digits_do(value, significant_digits(text));
    if (!back || fewer)
        printf("%016" PRIX64 ": \"%s\" %s\n", word, text,
               !back ? "does not read back" : "is not the shortest");
    return back && !fewer;
}

static bool to_text_agrees(const struct converters *as, uint64_t *random)
{
    c205_word word = word_near_doubles(as->format, random);
    char text[C205_TEXT_SIZE];
    as->to_text(word, text);
    oracle_value(as->format, exact, word);
    return memchr(text, '\0', sizeof text) && text_is_right(as, word, exact, text);
}

static bool to_hex_agrees(const struct converters *as, uint64_t *random)
{
    c205_word word = random_word(as->format, random);
    char text[C205_TEXT_SIZE], expected[C205_TEXT_SIZE];
    snprintf(expected, sizeof expected, "%04X %04X %04X %04X", (unsigned)(word >> 48),
             (unsigned)(word >> 32 & 0xFFFF), (unsigned)(word >> 16 & 0xFFFF),
             (unsigned)(word & 0xFFFF));
    c205_to_hex(word, text);
    return same_text(word, expected, text);
}

/* ---- The table of conversions ------------------------------------------- */

const struct conversion conversions[] = {
    { "from_double", &words, from_double_agrees },
    { "to_double", &words, to_double_agrees },
    { "from_integer", &words, from_integer_agrees },
    { "to_integer", &words, to_integer_agrees },
    { "from_text", &words, from_text_agrees },
    { "to_text", &words, to_text_agrees },
    { "to_hex", &words, to_hex_agrees },
    { "half_from_double", &halves, from_double_agrees },
    { "half_to_double", &halves, to_double_agrees },
    { "half_from_text", &halves, from_text_agrees },
    { "half_to_text", &halves, to_text_agrees },
};

const size_t conversion_count = sizeof conversions / sizeof conversions[0];

bool check_conversion(const struct conversion *conversion, uint64_t seed, size_t cases)
{
    uint64_t random = seed;
    bool good = true;
    mpfr_init2(exact, 48);
    mpfr_init2(cut, conversion->converters->format->digits);
    for (size_t i = 0; good && i < cases; i++)
        good = conversion->agrees(conversion->converters, &random);
    mpfr_clears(exact, cut, (mpfr_ptr)NULL);
    return good;
}
