/* test_asm_expression.c - values of expressions are compared with integers and words
 * computed by hand: all operators and their precedence, constants, the ends of the
 * range and the deepest nesting. Messages of wrong expressions are compared with
 * expected messages; test_asm_errors checks their columns. An operator with another
 * precedence or rounding fails here. */
#include "tests/unit/asm_helper.h"

/* Returns the word that .word makes of the expression. */
static c205_word value(const char *expression)
{
    SCOPED(object) *object = good(formatted(" .equ N, 7\n .equ F, 2.5\n .data\n"
                                            "here: .word %s\nthere:\n",
                                            expression));
    return word_of(&object->program, 0x800000);
}

TEST(integers)
{
    static const struct {
        const char *text;
        int64_t value;
    } cases[] = {
        { "10", 10 },      { "0x1F", 31 },    { "1 + 2 * 3", 7 },
        { "-1", -1 },      { "-7 / 2", -3 },  { "(1 + 2) * 3", 9 },
        { "-7 % 4", -3 },  { "-8 >> 1", -4 }, { "7 - 2 - 1", 4 },
        { "1 < 2", 1 },    { "2 <= 1", 0 },   { "1 << 4 + 1", 32 },
        { "!5", 0 },       { "!!5", 1 },      { "3 > 2 == 1", 1 },
        { "- -5", 5 },     { "-~4", 5 },      { "5 & 3 == 3", 1 },
        { "1 && 0", 0 },   { "N * N", 49 },   { "5 & 6 ^ 1 | 8", 13 },
        { ".", 0x800000 }, { "1 >= 1", 1 },   { "~0 & 0xFF", 255 },
        { "1 >= 2", 0 },   { "1 != 2", 1 },   { "0 && 1 / 0", 0 },
        { "2 != 2", 0 },   { "1 <= 0", 0 },   { "1 || 1 / 0", 1 },
        { "2 > 1", 1 },    { "1 == 1", 1 },   { "here", 0x800000 },
        { "!1", 0 },       { "!0", 1 },       { "there - here", 64 },
        { "-(5)", -5 },    { "~5", -6 },      { ". + 64 == there", 1 },
        { "7 % 4", 3 },    { "7 / 2", 3 },    { "X'0F' + 1", 16 },
        { "2 && 3", 1 },   { "0 || 0", 0 },   { "1 << 63 >> 63", -1 },
        { "0 || 5", 1 },   { "1 ^ 3", 2 },    { "2 + 3 * 4", 14 },
        { "3 | 4", 7 },    { "6 & 3", 2 },    { "length(\"abc\")", 3 },
        { "1 << 5", 32 },  { "64 >> 5", 2 },  { "bits(word(77))", 77 },
    };
    for (size_t i = 0; i < COUNT(cases); i++)
        FAIL_IF(value(cases[i].text) != c205_from_integer(cases[i].value),
                "%s is not %lld", cases[i].text, (long long)cases[i].value);
}

TEST(words)
{
    assert_int_equal(value("1.0"), C205_ONE);
    assert_int_equal(value("1e0"), C205_ONE);
    assert_int_equal(value(".5"), 0xFFD1400000000000);
    assert_int_equal(value("-1.5"), 0xFFD2A00000000000);
    assert_int_equal(value("- 1.5"), 0xFFD2A00000000000);
    assert_int_equal(value("F"), c205_from_double(2.5));
    assert_int_equal(value("(2.5)"), c205_from_double(2.5));
    assert_int_equal(value("X'FFD2 4000 0000 0000'"), C205_ONE);
    assert_int_equal(value("x'ff'"), 0xFF);
    assert_int_equal(value("word(3 << 48 | here)"), 0x0003000000800000);
}

/* The first and the last accepted value of each range, and long expressions. */
TEST(edges)
{
    assert_int_equal(value("bits(1.0) >> 48 & 0xFFFF"), 0xFFD2);
    assert_int_equal(value("bits(-1)"), 0xFFFFFFFFFFFF);
    assert_int_equal(value("length(\"a\\nb\\x41\")"), 4);
    assert_int_equal(value("0x7FFFFFFFFFFF + 1"), 0x800000000000);
    assert_int_equal(value("9223372036854775807 == -(-9223372036854775807)"), 1);
    assert_int_equal(value("(1 << 48) - 1"), 0xFFFFFFFFFFFF);
    assert_int_equal(value("-(1 << 47)"), 0x800000000000);
    assert_int_equal(value("9223372036854775807 >> 62"), 1);
    assert_int_equal(value("X'123456789ABCDEF0'"), 0x123456789ABCDEF0);
}

static void expect_failure(const char *expression, const char *message)
{
    const char *text = formatted(" .equ F, 2.5\n .reg x, r5\n .word %s\n", expression);
    assert_asm_errors(&(struct asm_error){ text, 3, 0, message }, 1);
}

TEST(errors)
{
    char deep[500] = "";
    expect_failure("(1 << 63) / -1", "does not fit");
    expect_failure("1 >> -1", "between 0 and 63");
    expect_failure("~F", "requires integers");
    expect_failure("F && 1", "expected an integer");
    expect_failure("log(-1)", "the result is indefinite");
    expect_failure("F / 0", "the result is indefinite");
    expect_failure("1e8000 * 1e8000", "the result is indefinite");
    expect_failure("floor(1e20)", "below 2^47");
    expect_failure("sin(1, 2)", "expected ')'");
    expect_failure("atan2(1)", "expected ','");
    expect_failure("sin()", "expected a number");
    expect_failure("1.5 + (1 << 50)", "48 bits");
    expect_failure("x", "found the register");
    expect_failure("1 +", "found the end of the statement");
    expect_failure("12ab", "expected the end of the number");
    expect_failure("0x", "expected hex digits");
    expect_failure("0x10000000000000000", "does not fit in 64 bits");
    expect_failure("X''", "1 to 16");
    expect_failure("X'123456789ABCDEF01'", "1 to 16");
    expect_failure("1 << 50", "48 bits");
    expect_failure("9223372036854775808", "does not fit in 63 bits");
    expect_failure("1 << 48", "48 bits");
    expect_failure("-(1 << 47) - 1", "48 bits");
    expect_failure("\"text\"", "found '\"text\"'");
    memset(deep, '(', sizeof deep - 1);
    expect_failure(deep, "nested levels");
    memset(deep, '-', sizeof deep - 1);
    expect_failure(deep, "nested levels");
}

static char *times(char *text, const char *part, int count)
{
    for (int i = 0; i < count; i++)
        strcat(text, part);
    return text;
}

/* MAX_EXPRESSION_DEPTH limits the nesting of brackets and of operators. */
TEST(depth)
{
    enum { DEEPEST = 200 };
    char text[1000] = "";
    times(strcat(times(text, "(", DEEPEST - 1), "5"), ")", DEEPEST - 1);
    assert_int_equal(value(text), 5);
    *text = '\0';
    times(strcat(times(text, "(", DEEPEST), "5"), ")", DEEPEST);
    expect_failure(text, "nested levels");
    strcpy(text, "N");
    assert_int_equal(value(times(text, "+N", DEEPEST)), 7 * (DEEPEST + 1));
    strcpy(text, "F");
    expect_failure(times(text, "+F", DEEPEST + 1), "nested levels");
}
