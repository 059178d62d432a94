/* test_word.c - conversions of words and half words from and to text, at the limits,
 * are compared with words computed by hand: known words, texts that end early, numbers
 * at both ends of the range, and distant digits. check-arithmetic compares random
 * conversions, also from and to doubles and integers, with MPFR. A text that is read
 * beyond its end, or a number that is rounded up at the largest word, fails here. */
#include "tests/unit/unit.h"
#include "vm/number/word.h"

#include <math.h>

static const struct size {
    c205_word (*from_text)(const char *text, const char **end);
    void (*to_text)(c205_word word, char text[C205_TEXT_SIZE]);
    c205_word (*from_double)(double value);
} words = { c205_from_text, c205_to_text, c205_from_double },
  halves = { c205_half_from_text, c205_half_to_text, c205_half_from_double };

static c205_word read_as(const struct size *size, const char *text)
{
    const char *end;
    c205_word word = size->from_text(text, &end);
    assert_true(end != text);
    assert_int_equal(*end, '\0');
    return word;
}

static c205_word read_all(const char *text)
{
    return read_as(&words, text);
}

static void check_text(const struct size *size, c205_word word, const char *expected)
{
    char text[C205_TEXT_SIZE];
    size->to_text(word, text);
    assert_string_equal(text, expected);
}

/* Words of the machine notes, section 1. Fractions that are not binary are floored. */
TEST(known_words)
{
    static const struct {
        const char *text;
        c205_word word, half;
    } known[] = {
        { "1", C205_ONE, C205_HALF_ONE },
        { "2", UINT64_C(0xFFD3400000000000), UINT64_C(0xEB40000000000000) },
        { "0.5", UINT64_C(0xFFD1400000000000), UINT64_C(0xE940000000000000) },
        { "3", UINT64_C(0xFFD3600000000000), UINT64_C(0xEB60000000000000) },
        { "10", UINT64_C(0xFFD5500000000000), UINT64_C(0xED50000000000000) },
        { "100", UINT64_C(0xFFD8640000000000), UINT64_C(0xF064000000000000) },
        { "0.1", UINT64_C(0xFFCE666666666666), UINT64_C(0xE666666600000000) },
        { "-0.1", UINT64_C(0xFFCE999999999999), UINT64_C(0xE699999900000000) },
        { "-1.5", UINT64_C(0xFFD2A00000000000), UINT64_C(0xEAA0000000000000) },
        { "-1", UINT64_C(0xFFD1800000000000), UINT64_C(0xE980000000000000) },
        { "0", C205_MACHINE_ZERO, C205_MACHINE_ZERO },
    };
    for (size_t i = 0; i < COUNT(known); i++) {
        const char *text = known[i].text;
        double value = strtod(text, NULL);
        assert_int_equal(read_all(text), known[i].word);
        assert_int_equal(read_as(&halves, text), known[i].half);
        assert_int_equal(words.from_double(value), known[i].word);
        assert_int_equal(halves.from_double(value), known[i].half);
        check_text(&words, known[i].word, text);
        check_text(&halves, known[i].half, text);
    }
}

TEST(doubles_at_the_edges)
{
    static const struct {
        double value;
        c205_word word, half;
    } cases[] = {
        { 1 + 0x1p-47, C205_ONE, C205_HALF_ONE },
        { -1 - 0x1p-52, UINT64_C(0xFFD2BFFFFFFFFFFF), UINT64_C(0xEABFFFFF00000000) },
        { -2 + 0x1p-52, UINT64_C(0xFFD2800000000000), UINT64_C(0xEA80000000000000) },
        { 0x1p-1074, UINT64_C(0xFBA0400000000000), C205_MACHINE_ZERO },
        { 0x1p134, UINT64_C(0x0058400000000000), C205_INDEFINITE },
        { 0x1p133, UINT64_C(0x0057400000000000), UINT64_C(0x6F40000000000000) },
        { 0x1p-90, UINT64_C(0xFF78400000000000), UINT64_C(0x9040000000000000) },
        { 0x1p-91, UINT64_C(0xFF77400000000000), C205_MACHINE_ZERO },
        { HUGE_VAL, C205_INDEFINITE, C205_INDEFINITE },
        { -HUGE_VAL, C205_INDEFINITE, C205_INDEFINITE },
        { NAN, C205_INDEFINITE, C205_INDEFINITE },
        { -0.0, C205_MACHINE_ZERO, C205_MACHINE_ZERO },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        assert_int_equal(words.from_double(cases[i].value), cases[i].word);
        assert_int_equal(halves.from_double(cases[i].value), cases[i].half);
    }
    assert_true(isnan(c205_to_double(UINT64_C(0x7ABC000000000001))));
    assert_true(c205_to_double(UINT64_C(0x8FFF7FFFFFFFFFFF)) == 0);
    assert_true(c205_to_double(word_make(20000, -1)) == -HUGE_VAL);
    assert_true(signbit(c205_to_double(word_make(-20000, -1))));
    assert_true(isnan(c205_half_to_double(UINT64_C(0x7ABCDEF000000000))));
    assert_true(c205_half_to_double(UINT64_C(0x8FBCDEF000000000)) == 0);
}

/* The length of the number at a text's start (0: none), and an equal number. */
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
        { "", 0, NULL },           { "-", 0, NULL },    { "+", 0, NULL },
        { ".", 0, NULL },          { "-.", 0, NULL },   { "e5", 0, NULL },
        { " 1", 0, NULL },         { "x", 0, NULL },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        const char *end;
        c205_word word = c205_from_text(cases[i].text, &end);
        assert_int_equal(end - cases[i].text, cases[i].used);
        if (cases[i].same)
            assert_int_equal(word, read_all(cases[i].same));
    }
}

/* The largest word is 9.5370811543187567767e8644, and 2^28718 is too large. 2^134 is
 * 2.1778071482940061661e40. 2^-90 is 8.0779356694631608874e-28. */
TEST(ends_of_the_range)
{
    static const struct {
        const struct size *size;
        const char *text;
        c205_word word;
    } cases[] = {
        { &words, "9.53708115431875677e8644", UINT64_C(0x6FFF7FFFFFFFFFFE) },
        { &words, "9.53708115431875678e8644", UINT64_C(0x6FFF7FFFFFFFFFFF) },
        { &words, "9.53708115431882454e8644", UINT64_C(0x6FFF7FFFFFFFFFFF) },
        { &words, "9.53708115431882455e8644", C205_INDEFINITE },
        { &words, "1e8646", C205_INDEFINITE },
        { &words, "-1e8646", C205_INDEFINITE },
        { &words, "1e-8618", C205_MACHINE_ZERO },
        { &words, "-1e-8618", C205_MACHINE_ZERO },
        { &words, "1e999999999999999999999", C205_INDEFINITE },
        { &words, "1e-999999999999999999999", C205_MACHINE_ZERO },
        { &words, "0e999999999999999999999", C205_MACHINE_ZERO },
        { &halves, "2.17780714829400616e40", UINT64_C(0x6F7FFFFF00000000) },
        { &halves, "2.17780714829400617e40", C205_INDEFINITE },
        { &halves, "8.0779356694631609e-28", UINT64_C(0x9040000000000000) },
        { &halves, "8.0779356694631608e-28", C205_MACHINE_ZERO },
        { &halves, "1e9999", C205_INDEFINITE },
    };
    static const c205_word ends[] = {
        UINT64_C(0x6FFF7FFFFFFFFFFF), UINT64_C(0x6FFF800000000000),
        UINT64_C(0x9000400000000000), UINT64_C(0x9000800000000000),
        UINT64_C(0x9000BFFFFFFFFFFF), UINT64_C(0x6FFF400000000000),
    };
    for (size_t i = 0; i < COUNT(cases); i++)
        assert_int_equal(read_as(cases[i].size, cases[i].text), cases[i].word);
    for (size_t i = 0; i < COUNT(ends); i++) {
        char text[C205_TEXT_SIZE];
        c205_to_text(ends[i], text);
        assert_int_equal(read_all(text), ends[i]);
    }
    assert_false(word_is_machine_zero(read_all("1e-8616")));
}

/* A distant digit decides between two words, whatever the number of digits is. */
TEST(distant_digits)
{
    enum { ZEROS = 30000 };
    FREED char *text = NON_NULL(malloc(ZEROS + 8));
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
}

TEST(layout_of_text)
{
    static const char *const texts[] = { "0.00001", "1e-6",   "123456",
                                         "-0.25",   "1e16",   "1000000000000000",
                                         "1.5e16",  "-1e-20", "12.5" };
    static const struct {
        const struct size *size;
        c205_word word;
        const char *text;
    } odd[] = {
        { &words, UINT64_C(0x7123000000000000), "indefinite" },
        { &words, UINT64_C(0x8FFF123400000000), "0" },
        { &words, UINT64_C(0x0011000000000000), "0" },
        { &words, UINT64_C(0x0000FFFFFFFFFFFF), "-1" },
        { &words, UINT64_C(0x0001000000000003), "6" },
        { &words, UINT64_C(0x9000000000000001), "7.3784361314571e-8632" },
        { &halves, UINT64_C(0x0100000300000000), "6" },
        { &halves, UINT64_C(0x1100000000000000), "0" },
        { &halves, UINT64_C(0x7F12345600000000), "indefinite" },
    };
    for (size_t i = 0; i < COUNT(texts); i++)
        check_text(&words, read_all(texts[i]), texts[i]);
    for (size_t i = 0; i < COUNT(odd); i++)
        check_text(odd[i].size, odd[i].word, odd[i].text);
}

TEST(significant_bits)
{
    static const struct {
        int64_t number;
        int bits;
    } cases[] = { { 0, 0 },
                  { -1, 0 },
                  { -2, 1 },
                  { 1, 1 },
                  { 2, 2 },
                  { WORD_COEFFICIENT_MAX, 47 },
                  { WORD_COEFFICIENT_MIN, 47 } };
    for (size_t i = 0; i < COUNT(cases); i++)
        assert_int_equal(word_significant_bits(cases[i].number), cases[i].bits);
    for (int n = 1; n <= 50; n++) {
        assert_int_equal(word_bit_length(UINT64_C(1) << n), n + 1);
        assert_int_equal(word_bit_length((UINT64_C(1) << n) - 1), n);
    }
}
