/* test_decimal.c - conversions of words to decimal text are compared with MPFR, over
 * random words, notations and numbers of digits. A wrong rounding or exponent fails. */
#include "tests/oracle/arithmetic_oracle.h"
#include "tests/random.h"
#include "tests/unit/machine_fixture.h"
#include "tests/unit/prior_model.h"

enum { TRIES = 40000, DIGITS = 128, LONGEST = 20000 };

static uint64_t state = RANDOM_SEED;

/* Returns 9.99 .. times a power of ten. */
static c205_word draw_below_power(void)
{
    static const char nines[] = "9.999999999999999999";
    const char *end;
    const char *text = formatted("%.*se%d", (int)xorshift_between(&state, 3, 16), nines,
                                 (int)xorshift_between(&state, -8000, 8000));
    return c205_from_text(text, &end);
}

static c205_word draw(void)
{
    switch (xorshift(&state) % 7) {
    case 0: return xorshift(&state);
    case 1: return xorshift_unnormalised(&state, -60, 10);
    case 2: return xorshift_normalised(&state, -28672, 28671);
    case 3: { /* a short decimal expansion, so that ties occur */
        double number = (double)xorshift_between(&state, -100000, 100000);
        return c205_from_double(number
                                / (double)(1 << xorshift_between(&state, 0, 12)));
    }
    case 5: return draw_below_power();
    case 4: { /* near a power of ten */
        double ten = 1;
        for (int64_t i = xorshift_between(&state, 0, 13); i > 0; i--)
            ten *= 10;
        return c205_from_double(ten) + (c205_word)xorshift_between(&state, -2, 2);
    }
    default: return xorshift_normalised(&state, -90, 0);
    }
}

static void check(c205_word word, c205_notation notation, unsigned digits)
{
    static char exact[LONGEST];
    char text[C205_TEXT_SIZE];
    unsigned most = notation == C205_FIXED ? C205_DIGITS - 1 : C205_DIGITS;
    unsigned asked = digits > most                                ? most
                     : notation == C205_SCIENTIFIC && digits == 0 ? 1
                                                                  : digits;
    mpfr_t value;
    mpfr_init2(value, DIGITS);
    oracle_value(&oracle_full, value, word);
    c205_to_decimal(word, notation, digits, text);
    if (mpfr_nan_p(value)) {
        strcpy(exact, "indefinite");
    } else if (notation == C205_SCIENTIFIC || strchr(text, 'e')) {
        unsigned behind = asked - (notation == C205_SCIENTIFIC);
        mpfr_snprintf(exact, sizeof exact, "%.*RNe", (int)behind, value);
        /* MPFR's exponent has a sign, and at least two digits. */
        char *e = strchr(exact, 'e');
        sprintf(e, "e%ld", strtol(e + 1, NULL, 10));
        /* Scientific notation is used only if the fixed notation does not fit. */
        if (notation == C205_FIXED)
            assert_true(mpfr_get_exp(value)
                        > 3.3219 * ((double)C205_DIGITS - asked) - 0.001);
    } else {
        size_t digits_shown = strspn(text, "-0123456789.");
        digits_shown -= *text == '-' ? 1 : 0;
        digits_shown -= strchr(text, '.') ? 1 : 0;
        assert_true(digits_shown <= C205_DIGITS);
        mpfr_snprintf(exact, sizeof exact, "%.*RNf", (int)asked, value);
    }
    mpfr_clear(value);
    /* The machine has only one zero, so the sign of -0 is removed. */
    if (*exact == '-' && !strpbrk(exact, "123456789"))
        memmove(exact, exact + 1, strlen(exact));
    FAIL_IF(strcmp(text, exact) != 0, "%016llx, %u digits: %s should be %s",
            (unsigned long long)word, digits, text, exact);
}

TEST(digits)
{
    for (int i = 0; i < (int)share_of(TRIES); i++)
        check(draw(), xorshift(&state) & 1 ? C205_FIXED : C205_SCIENTIFIC,
              (unsigned)xorshift_between(&state, 0, 20));
}

TEST(ends)
{
    static const uint64_t words[] = {
        0,
        C205_MACHINE_ZERO,
        C205_INDEFINITE,
        UINT64_C(0x6FFF7FFFFFFFFFFF),
        UINT64_C(0x6FFF800000000000),
        UINT64_C(0x9000000000000001),
        UINT64_C(0x9000FFFFFFFFFFFF) /* -1 in units of the last place */
    };
    for (size_t i = 0; i < COUNT(words); i++)
        for (unsigned digits = 0; digits < 20; digits++) {
            check(words[i], C205_FIXED, digits);
            check(words[i], C205_SCIENTIFIC, digits);
        }
}

/* Each exponent's least normalised word detects an estimate that is one too large. */
TEST(each_exponent)
{
    for (int64_t exponent = -28672; exponent < 28672; exponent++)
        check((c205_word)exponent << 48 | UINT64_C(1) << 46, C205_SCIENTIFIC, 5);
}

GROUP(set_up_oracle, tear_down_oracle);
