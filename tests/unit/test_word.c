/* test_word.c - words and half words from and to doubles, integers and text: known words,
 * random ones and the ends of the range are converted there and back and compared with the
 * exact values of the C library.  A value that is rounded upward, or a text that is not
 * the shortest, fails here.
 */
#include "tests/random.h"
#include "tests/unit/unit.h"
#include "vm/number/word.h"

#include <math.h>

enum { ROUNDS = 20000 };

typedef struct known {
    const char *text;
    c205_word word;
} known;

static c205_word read_all(const char *text)
{
    const char *end;
    c205_word word = c205_from_text(text, &end);

    assert_true(end != text);
    assert_int_equal(*end, '\0');
    return word;
}

/* Machine notes, section 1. */
static const known table[] = {
    { "1", UINT64_C(0xFFD2400000000000) },   { "2", UINT64_C(0xFFD3400000000000) },
    { "0.5", UINT64_C(0xFFD1400000000000) }, { "3", UINT64_C(0xFFD3600000000000) },
    { "10", UINT64_C(0xFFD5500000000000) },  { "100", UINT64_C(0xFFD8640000000000) },
    { "0.1", UINT64_C(0xFFCE666666666666) }, { "-1.5", UINT64_C(0xFFD2A00000000000) },
    { "-1", UINT64_C(0xFFD1800000000000) },  { "0", C205_MACHINE_ZERO },
};

TEST(known_words)
{
    for (size_t i = 0; i < COUNT(table); i++) {
        char text[C205_TEXT_SIZE];
        assert_int_equal(read_all(table[i].text), table[i].word);
        c205_to_text(table[i].word, text);
        assert_string_equal(text, table[i].text);
        assert_int_equal(c205_from_double(strtod(table[i].text, NULL)), table[i].word);
    }
}

/* Floor: towards minus infinity on both sides of zero. */
TEST(doubles_are_cut_down)
{
    assert_int_equal(c205_from_double(0.1), UINT64_C(0xFFCE666666666666));
    assert_int_equal(c205_from_double(-0.1), UINT64_C(0xFFCE999999999999));
    assert_int_equal(c205_from_double(1 + ldexp(1, -47)), C205_ONE);
    assert_int_equal(c205_from_double(-1 - ldexp(1, -47)),
                     UINT64_C(0xFFD2BFFFFFFFFFFF));
    assert_int_equal(c205_from_double(-1 - ldexp(1, -52)),
                     UINT64_C(0xFFD2BFFFFFFFFFFF));
    assert_int_equal(c205_from_double(ldexp(1, -1074)),
                     word_make(-1074 - 46, INT64_C(1) << 46));
    assert_int_equal(c205_from_double(-2 + ldexp(1, -52)),
                     UINT64_C(0xFFD2800000000000));
}

TEST(doubles_without_a_word)
{
    assert_int_equal(c205_from_double(HUGE_VAL), C205_INDEFINITE);
    assert_int_equal(c205_from_double(-HUGE_VAL), C205_INDEFINITE);
    assert_int_equal(c205_from_double(NAN), C205_INDEFINITE);
    assert_int_equal(c205_from_double(0.0), C205_MACHINE_ZERO);
    assert_int_equal(c205_from_double(-0.0), C205_MACHINE_ZERO);
}

TEST(words_beyond_doubles)
{
    assert_true(isnan(c205_to_double(UINT64_C(0x7ABC000000000001))));
    assert_true(c205_to_double(UINT64_C(0x8FFF7FFFFFFFFFFF)) == 0);
    assert_true(c205_to_double(word_make(20000, 1)) == HUGE_VAL);
    assert_true(c205_to_double(word_make(20000, -1)) == -HUGE_VAL);
    assert_true(c205_to_double(word_make(-20000, 1)) == 0);
    assert_true(signbit(c205_to_double(word_make(-20000, -1))));
    assert_true(c205_to_double(word_make(3, -5)) == -40);
}

TEST(doubles_come_back)
{
    uint64_t seed = RANDOM_SEED;

    for (int i = 0; i < ROUNDS; i++) {
        c205_word word = xorshift_normalised(&seed, -1000, 900);
        assert_int_equal(c205_from_double(c205_to_double(word)), word);
    }
}

TEST(integers)
{
    assert_int_equal(c205_from_integer(5), 5);
    assert_int_equal(c205_from_integer(-1), UINT64_C(0x0000FFFFFFFFFFFF));
    assert_int_equal(c205_to_integer(c205_from_integer(WORD_COEFFICIENT_MIN)),
                     WORD_COEFFICIENT_MIN);
    assert_int_equal(c205_to_integer(UINT64_C(0xFFD27FFFFFFFFFFF)),
                     WORD_COEFFICIENT_MAX);
}

TEST(hexadecimal)
{
    char text[C205_TEXT_SIZE];

    c205_to_hex(UINT64_C(0xFFD2400000ABCDEF), text);
    assert_string_equal(text, "FFD2 4000 00AB CDEF");
}

TEST(where_text_ends)
{
    static const struct {
        const char *text;
        int used;
        const char *same;
    } cases[] = {
        { "12.5e-1x", 7, "1.25" }, { "1e", 1, "1" },    { "1e+", 1, "1" },
        { "1.5.5", 3, "1.5" },     { ".5", 2, "0.5" },  { "5.", 2, "5" },
        { "+7,", 2, "7" },         { "-7 8", 2, "-7" }, { "1E2", 3, "100" },
        { "007", 3, "7" },         { "1e-0", 4, "1" },  { "0x10", 1, "0" },
    };

    for (size_t i = 0; i < COUNT(cases); i++) {
        const char *end;
        c205_word word = c205_from_text(cases[i].text, &end);
        assert_int_equal(end - cases[i].text, cases[i].used);
        assert_int_equal(word, read_all(cases[i].same));
    }
}

TEST(no_number)
{
    static const char *const texts[] = { "", "-", "+", ".", "-.", "e5", " 1", "x" };

    for (size_t i = 0; i < COUNT(texts); i++) {
        const char *end;
        c205_from_text(texts[i], &end);
        assert_ptr_equal(end, texts[i]);
    }
}

TEST(ends_of_the_range)
{
    char text[C205_TEXT_SIZE];
    const c205_word ends[] = {
        UINT64_C(0x6FFF7FFFFFFFFFFF), UINT64_C(0x6FFF800000000000),
        UINT64_C(0x9000400000000000), UINT64_C(0x9000800000000000),
        UINT64_C(0x9000BFFFFFFFFFFF), UINT64_C(0x6FFF400000000000),
    };

    for (size_t i = 0; i < COUNT(ends); i++) {
        c205_to_text(ends[i], text);
        assert_int_equal(read_all(text), ends[i]);
    }
    /* The largest is 9.5370811543187567767e8644, and 2^28718 too large. */
    assert_int_equal(read_all("9.53708115431875677e8644"), ends[0] - 1);
    assert_int_equal(read_all("9.53708115431875678e8644"), ends[0]);
    assert_int_equal(read_all("9.53708115431882454e8644"), ends[0]);
    assert_int_equal(read_all("9.53708115431882455e8644"), C205_INDEFINITE);
    assert_int_equal(read_all("1e8646"), C205_INDEFINITE);
    assert_int_equal(read_all("-1e8646"), C205_INDEFINITE);
    assert_int_equal(read_all("1e-8618"), C205_MACHINE_ZERO);
    assert_int_equal(read_all("-1e-8618"), C205_MACHINE_ZERO);
    assert_false(word_is_machine_zero(read_all("1e-8616")));
}

TEST(absurd_exponents)
{
    assert_int_equal(read_all("1e999999999999999999999"), C205_INDEFINITE);
    assert_int_equal(read_all("1e-999999999999999999999"), C205_MACHINE_ZERO);
    assert_int_equal(read_all("0e999999999999999999999"), C205_MACHINE_ZERO);
}

/* A digit far behind the point decides on which side of a word a number
 * lies; as many digits as one likes. */
TEST(distant_digits)
{
    enum { ZEROS = 30000 };
    char *text = malloc(ZEROS + 8);

    assert_non_null(text);
    memset(text, '0', ZEROS + 8);
    memcpy(text, "-1.", 3);
    text[ZEROS] = '1';
    text[ZEROS + 1] = '\0';
    assert_int_equal(read_all(text), UINT64_C(0xFFD2BFFFFFFFFFFF));
    assert_int_equal(read_all(text + 1), C205_ONE);
    text[ZEROS] = '0';
    assert_int_equal(read_all(text), UINT64_C(0xFFD1800000000000));
    text[2] = '0';
    memcpy(text + ZEROS - 7, "e-29991", 8);
    text[ZEROS] = '\0';
    assert_int_equal(read_all(text + 1), read_all("1e0"));
    free(text);
}

/* The C library writes doubles exactly if asked for enough digits. */
TEST(exact_text_of_doubles)
{
    enum { DIGITS = 800, WORDS = 500 };
    uint64_t seed = RANDOM_SEED;

    for (int i = 0; i < WORDS; i++) {
        char text[DIGITS + 20];
        c205_word word = xorshift_normalised(&seed, -1060, 970);
        double value = c205_to_double(word);
        snprintf(text, sizeof text, "%.*e", DIGITS, value);
        assert_int_equal(read_all(text), word);
        snprintf(text, sizeof text, "%.*e", DIGITS, nextafter(value, -HUGE_VAL));
        assert_int_equal(read_all(text), c205_from_double(nextafter(value, -HUGE_VAL)));
    }
}

static void round_trip(c205_word word)
{
    char text[C205_TEXT_SIZE];

    c205_to_text(word, text);
    assert_int_equal(read_all(text), word);
}

TEST(text_comes_back)
{
    uint64_t seed = RANDOM_SEED;

    for (int i = 0; i < ROUNDS; i++)
        round_trip(xorshift_normalised(&seed, -200, 110));
    for (int i = 0; i < 40; i++)
        round_trip(xorshift_normalised(&seed, WORD_EXPONENT_MIN, WORD_EXPONENT_MAX));
    for (int32_t e = -120; e < 60; e++) {
        round_trip(word_make(e, INT64_C(1) << 46));
        round_trip(word_make(e, WORD_COEFFICIENT_MIN));
        round_trip(word_make(e, WORD_COEFFICIENT_MAX));
        round_trip(word_make(e, WORD_COEFFICIENT_MIN / 2 - 1));
    }
}

/* No text with a digit less, rounded to either side, reads back. */
TEST(text_is_shortest)
{
    uint64_t seed = RANDOM_SEED;

    for (int i = 0; i < ROUNDS; i++) {
        char text[C205_TEXT_SIZE], shorter[C205_TEXT_SIZE];
        c205_word word = xorshift_normalised(&seed, 20, 40);
        c205_to_text(word, text);
        char *e = strchr(text, 'e');
        assert_non_null(e);
        int digits = (int)(e - text) - (text[0] == '-') - 1;
        assert_true(digits <= 16);
        *e = '\0';
        for (int up = -1; digits > 2 && up <= 1; up++) {
            double ulp = pow(10, 2 - digits) * up;
            snprintf(shorter, sizeof shorter, "%.*f%s%s", digits - 2,
                     strtod(text, NULL) + ulp, "e", e + 1);
            assert_true(read_all(shorter) != word);
        }
    }
}

TEST(layout_of_text)
{
    static const known cases[] = {
        { "0.00001", 0 }, { "1e-6", 0 },   { "123456", 0 },           { "-0.25", 0 },
        { "1e16", 0 },    { "1.5e16", 0 }, { "1000000000000000", 0 }, { "12.5", 0 },
        { "-1e-20", 0 },
    };

    for (size_t i = 0; i < COUNT(cases); i++) {
        char text[C205_TEXT_SIZE];
        c205_to_text(read_all(cases[i].text), text);
        assert_string_equal(text, cases[i].text);
    }
}

TEST(text_of_odd_words)
{
    char text[C205_TEXT_SIZE];

    c205_to_text(UINT64_C(0x7123000000000000), text);
    assert_string_equal(text, "indefinite");
    c205_to_text(UINT64_C(0x8FFF123400000000), text);
    assert_string_equal(text, "0");
    c205_to_text(word_make(17, 0), text);
    assert_string_equal(text, "0");
    c205_to_text(c205_from_integer(-1), text);
    assert_string_equal(text, "-1");
    c205_to_text(word_make(1, 3), text);
    assert_string_equal(text, "6");
    c205_to_text(word_make(WORD_EXPONENT_MIN, 1), text);
    assert_string_equal(text, "7.3784361314571e-8632");
}

TEST(significant_bits)
{
    assert_int_equal(word_significant_bits(0), 0);
    assert_int_equal(word_significant_bits(-1), 0);
    assert_int_equal(word_significant_bits(-2), 1);
    assert_int_equal(word_significant_bits(1), 1);
    assert_int_equal(word_significant_bits(2), 2);
    assert_int_equal(word_significant_bits(WORD_COEFFICIENT_MAX), 47);
    assert_int_equal(word_significant_bits(WORD_COEFFICIENT_MIN), 47);
    for (int n = 1; n <= 50; n++) {
        assert_int_equal(word_bit_length(UINT64_C(1) << n), n + 1);
        assert_int_equal(word_bit_length((UINT64_C(1) << n) - 1), n);
    }
}

/* ---- Half words --------------------------------------------------------- */

static c205_word read_half(const char *text)
{
    const char *end;
    c205_word half = c205_half_from_text(text, &end);

    assert_true(end != text);
    assert_int_equal(*end, '\0');
    return half;
}

static const known halves[] = {
    { "1", C205_HALF_ONE },
    { "0.5", UINT64_C(0xE940000000000000) },
    { "10", UINT64_C(0xED50000000000000) },
    { "100", UINT64_C(0xF064000000000000) },
    { "0.1", UINT64_C(0xE666666600000000) },
    { "-1.5", UINT64_C(0xEAA0000000000000) },
    { "-1", UINT64_C(0xE980000000000000) },
    { "0", C205_MACHINE_ZERO },
};

TEST(known_halves)
{
    for (size_t i = 0; i < COUNT(halves); i++) {
        char text[C205_TEXT_SIZE];
        assert_int_equal(read_half(halves[i].text), halves[i].word);
        c205_half_to_text(halves[i].word, text);
        assert_string_equal(text, halves[i].text);
        assert_int_equal(c205_half_from_double(strtod(halves[i].text, NULL)),
                         halves[i].word);
    }
}

TEST(half_doubles)
{
    assert_int_equal(c205_half_from_double(-0.1), UINT64_C(0xE699999900000000));
    assert_int_equal(c205_half_from_double(1 + ldexp(1, -23)), C205_HALF_ONE);
    assert_int_equal(c205_half_from_double(-1 - ldexp(1, -52)),
                     UINT64_C(0xEABFFFFF00000000));
    assert_int_equal(c205_half_from_double(ldexp(1, 134)), C205_INDEFINITE);
    assert_int_equal(c205_half_from_double(ldexp(1, 133)),
                     UINT64_C(0x6F40000000000000));
    assert_int_equal(c205_half_from_double(ldexp(1, -90)),
                     UINT64_C(0x9040000000000000));
    assert_int_equal(c205_half_from_double(ldexp(1, -91)), C205_MACHINE_ZERO);
    assert_int_equal(c205_half_from_double(NAN), C205_INDEFINITE);
    assert_true(isnan(c205_half_to_double(UINT64_C(0x7ABCDEF000000000))));
    assert_true(c205_half_to_double(UINT64_C(0x8FBCDEF000000000)) == 0);
    assert_true(c205_half_to_double(UINT64_C(0x03FFFFFB00000000)) == -40);
}

TEST(half_text)
{
    char text[C205_TEXT_SIZE];

    /* 2^134 is 2.1778071482940061661e40, 2^-90 8.0779356694631608874e-28. */
    assert_int_equal(read_half("2.17780714829400616e40"), UINT64_C(0x6F7FFFFF00000000));
    assert_int_equal(read_half("2.17780714829400617e40"), C205_INDEFINITE);
    assert_int_equal(read_half("8.0779356694631609e-28"), UINT64_C(0x9040000000000000));
    assert_int_equal(read_half("8.0779356694631608e-28"), C205_MACHINE_ZERO);
    assert_int_equal(read_half("1e9999"), C205_INDEFINITE);
    c205_half_to_text(UINT64_C(0x0100000300000000), text);
    assert_string_equal(text, "6");
    c205_half_to_text(UINT64_C(0x1100000000000000), text);
    assert_string_equal(text, "0");
    c205_half_to_text(UINT64_C(0x7F12345600000000), text);
    assert_string_equal(text, "indefinite");
}

/* As shortest text, as exact text, as double. */
TEST(halves_come_back)
{
    uint64_t seed = RANDOM_SEED;

    for (int i = 0; i < ROUNDS; i++) {
        char text[C205_TEXT_SIZE], exact[200];
        c205_word half = xorshift_normalised_of(half_words, &seed,
                                                format_exponent_min(half_words),
                                                format_exponent_max(half_words));
        double value = c205_half_to_double(half);
        c205_half_to_text(half, text);
        assert_int_equal(read_half(text), half);
        snprintf(exact, sizeof exact, "%.150e", value);
        assert_int_equal(read_half(exact), half);
        assert_int_equal(c205_half_from_double(value), half);
    }
}
