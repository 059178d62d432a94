/* test_elementary.c - the elementary functions of scenes are compared with MPFR, to the
 * last bit, at random arguments of all sizes, and where they are exact. A result that
 * is rounded twice fails here. */
#include "rt/scene/elementary.h"
#include "tests/random.h"
#include "tests/unit/unit.h"

#include <math.h>

#include <mpfr.h>

typedef int of_one(mpfr_t value, const mpfr_t x, mpfr_rnd_t rounding);
typedef int of_two(mpfr_t value, const mpfr_t x, const mpfr_t y, mpfr_rnd_t rounding);

enum { EXP, LOG, LOG10, SIN, COS, TAN, ACOSH = 13 };
static const struct {
    const char *name;
    double (*ours)(double x);
    of_one *exact;
    double least, most; /* range of the magnitude of x, as powers of 2 */
} functions[] = {
    [EXP] = { "exp", elementary_exp, mpfr_exp, -60, 9.4 },
    [LOG] = { "log", elementary_log, mpfr_log, -1000, 1000 },
    [LOG10] = { "log10", elementary_log10, mpfr_log10, -1000, 1000 },
    [SIN] = { "sin", elementary_sin, mpfr_sin, -150, 30 },
    { "cos", elementary_cos, mpfr_cos, -60, 30 },
    [TAN] = { "tan", elementary_tan, mpfr_tan, -150, 30 },
    { "asin", elementary_asin, mpfr_asin, -150, 0 },
    { "acos", elementary_acos, mpfr_acos, -60, 0 },
    { "atan", elementary_atan, mpfr_atan, -150, 150 },
    { "sinh", elementary_sinh, mpfr_sinh, -150, 9.4 },
    { "cosh", elementary_cosh, mpfr_cosh, -60, 9.4 },
    { "tanh", elementary_tanh, mpfr_tanh, -150, 9.4 },
    { "asinh", elementary_asinh, mpfr_asinh, -150, 900 },
    [ACOSH] = { "acosh", elementary_acosh, mpfr_acosh, 0, 900 },
    { "atanh", elementary_atanh, mpfr_atanh, -150, 0 },
};

enum { EXACT = 300 }; /* bits */

static uint64_t state = 205;

/* Returns a random number between two powers of 2 in magnitude, most near 1. */
static double draw(double least, double most)
{
    double share = xorshift_real(&state, 0, 1);
    double from = xorshift(&state) % 4 > 0 && least < -8 ? fmax(least, -8) : least;
    double to = xorshift(&state) % 4 > 0 && most > 5 ? fmin(most, 5) : most;
    double x = exp2(from + share * (to - from));
    if (xorshift(&state) % 8 == 0)
        x = ldexp(floor(ldexp(x, 4)), -4); /* few bits */
    if (xorshift(&state) % 8 == 0)
        x = 1 + (x < 1 ? -1 : 1) * ldexp(1, -(int)(xorshift(&state) % 52));
    return xorshift(&state) % 2 == 0 ? x : -x;
}

/* Returns the exact value, rounded. For a function of x alone, `two` is NULL. */
static double rounded(of_one *one, of_two *two, double x, double y)
{
    mpfr_t value, a, b;
    mpfr_inits2(EXACT, value, a, b, (mpfr_ptr)0);
    mpfr_set_d(a, x, MPFR_RNDN);
    mpfr_set_d(b, y, MPFR_RNDN);
    if (two)
        two(value, a, b, MPFR_RNDN);
    else
        one(value, a, MPFR_RNDN);
    /* A value nearly halfway between doubles is rounded as a tie (elementary.h). */
    mpfr_prec_round(value, 53 + 40, MPFR_RNDN);
    double result = mpfr_get_d(value, MPFR_RNDN);
    mpfr_clears(value, a, b, (mpfr_ptr)0);
    return result;
}

static void assert_same(const char *name, double x, double y, double ours, double exact)
{
    if (ours == exact || (isnan(ours) && isnan(exact)))
        return;
    fail_msg("%s(%a, %a) is %a, should be %a", name, x, y, ours, exact);
}

static void check_function(size_t f, double x)
{
    assert_same(functions[f].name, x, 0, functions[f].ours(x),
                rounded(functions[f].exact, NULL, x, 0));
}

TEST(of_one)
{
    for (size_t f = 0; f < COUNT(functions); f++)
        for (int i = 0; i < 4000; i++)
            check_function(f, draw(functions[f].least, functions[f].most));
}

/* Logarithms near 1 are small, and depend only on the difference from 1. */
TEST(near_one)
{
    for (int i = 0; i < 4000; i++) {
        double off = exp2(xorshift_real(&state, -45, -10));
        check_function(LOG, i % 2 == 0 ? 1 + off : 1 - off);
        check_function(LOG10, i % 2 == 0 ? 1 + off : 1 - off);
        check_function(ACOSH, 1 + off);
    }
}

/* The arguments are whole degrees, as in scenes, and therefore include values near
 * multiples of pi / 2. */
TEST(angles)
{
    for (int degrees = -720; degrees <= 720; degrees++)
        for (size_t f = SIN; f <= TAN; f++)
            check_function(f, degrees * (3.14159265358979323846 / 180));
}

TEST(of_two)
{
    for (int i = 0; i < 8000; i++) {
        double x = draw(-60, 60), y = draw(-60, 60), e = draw(-8, 5);
        assert_same("atan2", x, y, elementary_atan2(x, y),
                    rounded(NULL, mpfr_atan2, x, y));
        assert_same("hypot", x, y, elementary_hypot(x, y),
                    rounded(NULL, mpfr_hypot, x, y));
        if (fabs(log2(fabs(x)) * e) < 1000)
            assert_same("pow", x, e, elementary_pow(x, e),
                        rounded(NULL, mpfr_pow, x, e));
    }
}

/* The square of an integer of 27 bits may be halfway between two doubles. */
TEST(halfway)
{
    for (int i = 0; i < 4000; i++) {
        double x = (double)(xorshift(&state) % (1 << 27) | 1);
        assert_same("pow", x, 2, elementary_pow(x, 2), x * x);
        assert_same("pow", x * x, .5, elementary_pow(x * x, .5), sqrt(x * x));
    }
    for (int k = -20; k <= 20; k++) {
        assert_true(elementary_pow(2, k) == ldexp(1, k));
        assert_true(elementary_log10(elementary_pow(10, abs(k))) == abs(k));
    }
}

/* The result equals the C function's where this is undefined or infinite. */
TEST(ends)
{
    static const double ends[] = { 0,        -0.,       1,      -1,     2,
                                   -2,       1e308,     -1e308, 1e-320, -1e-320,
                                   INFINITY, -INFINITY, NAN };
    for (size_t i = 0; i < COUNT(ends); i++) {
        double x = ends[i];
        for (size_t f = 0; f < COUNT(functions); f++)
            if (fabs(x) <= 2 || !isfinite(x))
                check_function(f, x);
        for (size_t k = 0; k < COUNT(ends); k++) {
            assert_same("atan2", x, ends[k], elementary_atan2(x, ends[k]),
                        atan2(x, ends[k]));
            assert_same("pow", x, ends[k], elementary_pow(x, ends[k]), pow(x, ends[k]));
        }
    }
}
