/* exact_functions.c - the functions of asm/lib and their polynomials with MPFR. */
#include "exact_functions.h"

#include <assert.h>

enum { DIGITS = 600 };

/* ---- Functions ----------------------------------------------------------- */

#define EXACT(name, ...) \
    void exact_##name(mpfr_t value, const mpfr_t x, const mpfr_t y) \
    { \
        (void)y; \
        __VA_ARGS__; \
    }

EXACT(exp, mpfr_exp(value, x, MPFR_RNDN))
EXACT(log, mpfr_log(value, x, MPFR_RNDN))
EXACT(sin, mpfr_sin(value, x, MPFR_RNDN))
EXACT(cos, mpfr_cos(value, x, MPFR_RNDN))
EXACT(atan2, mpfr_atan2(value, x, y, MPFR_RNDN))
EXACT(power, mpfr_pow(value, x, y, MPFR_RNDN))

/* ---- Polynomials --------------------------------------------------------- */

static void from_zero(mpfr_t low)
{
    mpfr_set_ui(low, 0, MPFR_RNDN);
}

/* Sets the ends of the interval from -ln 2 / 2 to ln 2 / 2. */
static void half_of_ln2(mpfr_t low, mpfr_t high)
{
    mpfr_const_log2(high, MPFR_RNDN);
    mpfr_div_ui(high, high, 2, MPFR_RNDN);
    mpfr_neg(low, high, MPFR_RNDN);
}

/* Sets the ends of the interval from -1/32 to 1/32. */
static void thirty_seconds(mpfr_t low, mpfr_t high)
{
    mpfr_set_d(low, -0.03125, MPFR_RNDN);
    mpfr_set_d(high, 0.03125, MPFR_RNDN);
}

/* Sets the ends of the interval from 0 to 3 - 2 sqrt 2, the square of tan(pi/8). */
static void squares_of_eighth(mpfr_t low, mpfr_t high)
{
    from_zero(low);
    mpfr_sqrt_ui(high, 8, MPFR_RNDN);
    mpfr_ui_sub(high, 3, high, MPFR_RNDN);
}

/* Sets the ends of the interval from 0 to the square of 3 - 2 sqrt 2, which is (sqrt 2
 * - 1) / (sqrt 2 + 1). */
static void squares_of_artanh(mpfr_t low, mpfr_t high)
{
    squares_of_eighth(low, high);
    mpfr_sqr(high, high, MPFR_RNDN);
}

/* Sets the ends of the interval from 0 to the square of pi/2. */
static void squares_of_half(mpfr_t low, mpfr_t high)
{
    from_zero(low);
    mpfr_const_pi(high, MPFR_RNDN);
    mpfr_div_ui(high, high, 2, MPFR_RNDN);
    mpfr_sqr(high, high, MPFR_RNDN);
}

/* Sets the ends of the interval from 0 to the square of pi/4. */
static void squares_of_quarter(mpfr_t low, mpfr_t high)
{
    from_zero(low);
    mpfr_const_pi(high, MPFR_RNDN);
    mpfr_div_ui(high, high, 4, MPFR_RNDN);
    mpfr_sqr(high, high, MPFR_RNDN);
}

/* Computes (e^r - 1 - r) / r^2, or the limit 1/2 near r = 0, where it cancels. */
static void rest_of_exp(mpfr_t value, const mpfr_t r)
{
    if (mpfr_zero_p(r) || mpfr_get_exp(r) < -DIGITS / 2) {
        mpfr_set_d(value, 0.5, MPFR_RNDN);
        return;
    }
    mpfr_expm1(value, r, MPFR_RNDN);
    mpfr_sub(value, value, r, MPFR_RNDN);
    mpfr_div(value, value, r, MPFR_RNDN);
    mpfr_div(value, value, r, MPFR_RNDN);
}

/* Computes (f(s) - s) / s^3 for an odd function f, as a function of s^2. */
static void rest_of_odd(mpfr_t value, const mpfr_t square,
                        int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t))
{
    mpfr_t s;
    mpfr_init2(s, DIGITS);
    mpfr_sqrt(s, square, MPFR_RNDN);
    f(value, s, MPFR_RNDN);
    mpfr_sub(value, value, s, MPFR_RNDN);
    mpfr_div(value, value, s, MPFR_RNDN);
    mpfr_div(value, value, square, MPFR_RNDN);
    mpfr_clear(s);
}

/* Computes (2 artanh s - 2 s) / s^3. */
static void rest_of_log(mpfr_t value, const mpfr_t square)
{
    rest_of_odd(value, square, mpfr_atanh);
    mpfr_mul_ui(value, value, 2, MPFR_RNDN);
}

static void rest_of_sin(mpfr_t value, const mpfr_t square)
{
    rest_of_odd(value, square, mpfr_sin);
}

static void rest_of_atan(mpfr_t value, const mpfr_t square)
{
    rest_of_odd(value, square, mpfr_atan);
}

/* Computes (cos r - 1 + r^2 / 2) / r^4. */
static void rest_of_cos(mpfr_t value, const mpfr_t square)
{
    mpfr_t half;
    mpfr_init2(half, DIGITS);
    mpfr_sqrt(value, square, MPFR_RNDN);
    mpfr_cos(value, value, MPFR_RNDN);
    mpfr_sub_ui(value, value, 1, MPFR_RNDN);
    mpfr_div_ui(half, square, 2, MPFR_RNDN);
    mpfr_add(value, value, half, MPFR_RNDN);
    mpfr_div(value, value, square, MPFR_RNDN);
    mpfr_div(value, value, square, MPFR_RNDN);
    mpfr_clear(half);
}

/* Computes (log2(1 + q) - q / ln 2) / q^2. */
static void rest_of_log2(mpfr_t value, const mpfr_t q)
{
    mpfr_t ln2;
    mpfr_init2(ln2, DIGITS);
    mpfr_const_log2(ln2, MPFR_RNDN);
    if (mpfr_zero_p(q) || mpfr_get_exp(q) < -DIGITS / 2) {
        mpfr_set_d(value, -0.5, MPFR_RNDN);
    } else {
        mpfr_log1p(value, q, MPFR_RNDN);
        mpfr_sub(value, value, q, MPFR_RNDN);
        mpfr_div(value, value, q, MPFR_RNDN);
        mpfr_div(value, value, q, MPFR_RNDN);
    }
    mpfr_div(value, value, ln2, MPFR_RNDN);
    mpfr_clear(ln2);
}

static const struct exact_polynomial polynomials[] = {
    { "exp.polynomial", 9, half_of_ln2, rest_of_exp },
    { "log.polynomial", 6, squares_of_artanh, rest_of_log },
    { "sin.polynomial", 7, squares_of_half, rest_of_sin },
    { "cos.polynomial", 5, squares_of_quarter, rest_of_cos },
    { "atan2.polynomial", 10, squares_of_eighth, rest_of_atan },
    { "power.polynomial", 7, thirty_seconds, rest_of_log2 },
};

const struct exact_polynomial *exact_polynomial_at(size_t i)
{
    return i < sizeof polynomials / sizeof *polynomials ? &polynomials[i] : NULL;
}

/* Computes Chebyshev point i: midpoint + half width * cos(pi (2 i + 1) / (2 count)). */
static void chebyshev_point(mpfr_t point, size_t i, size_t count, const mpfr_t low,
                            const mpfr_t high)
{
    mpfr_t middle;
    mpfr_init2(middle, DIGITS);
    mpfr_const_pi(point, MPFR_RNDN);
    mpfr_mul_ui(point, point, 2 * i + 1, MPFR_RNDN);
    mpfr_div_ui(point, point, 2 * count, MPFR_RNDN);
    mpfr_cos(point, point, MPFR_RNDN);
    mpfr_sub(middle, high, low, MPFR_RNDN);
    mpfr_mul(point, point, middle, MPFR_RNDN);
    mpfr_add(middle, high, low, MPFR_RNDN);
    mpfr_add(point, point, middle, MPFR_RNDN);
    mpfr_div_ui(point, point, 2, MPFR_RNDN);
    mpfr_clear(middle);
}

/* Replaces the values by divided differences, the coefficients of Newton's form. */
static void divide_differences(mpfr_t values[], mpfr_t points[], size_t count)
{
    mpfr_t width;
    mpfr_init2(width, DIGITS);
    for (size_t k = 1; k < count; k++) {
        for (size_t i = count - 1; i >= k; i--) {
            mpfr_sub(values[i], values[i], values[i - 1], MPFR_RNDN);
            mpfr_sub(width, points[i], points[i - k], MPFR_RNDN);
            mpfr_div(values[i], values[i], width, MPFR_RNDN);
        }
    }
    mpfr_clear(width);
}

/* Computes the coefficients of the powers from Newton's form. */
static void multiply_out(mpfr_t coefficients[], mpfr_t differences[], mpfr_t points[],
                         size_t count)
{
    mpfr_t part;
    mpfr_init2(part, DIGITS);
    for (size_t k = count; k-- > 0;) {
        for (size_t i = count; i-- > 0;) {
            mpfr_mul(part, coefficients[i], points[k], MPFR_RNDN);
            mpfr_neg(coefficients[i], part, MPFR_RNDN);
            if (i > 0) {
                mpfr_add(coefficients[i], coefficients[i], coefficients[i - 1],
                         MPFR_RNDN);
            }
        }
        mpfr_add(coefficients[0], coefficients[0], differences[k], MPFR_RNDN);
    }
    mpfr_clear(part);
}

void exact_coefficients(const struct exact_polynomial *polynomial,
                        mpfr_t coefficients[])
{
    mpfr_t points[EXACT_COEFFICIENTS], values[EXACT_COEFFICIENTS], low, high;
    size_t count = polynomial->count;
    assert(count <= EXACT_COEFFICIENTS);
    mpfr_inits2(DIGITS, low, high, (mpfr_ptr)NULL);
    polynomial->bounds(low, high);
    for (size_t i = 0; i < count; i++) {
        mpfr_inits2(DIGITS, points[i], values[i], coefficients[i], (mpfr_ptr)NULL);
        chebyshev_point(points[i], i, count, low, high);
        polynomial->value(values[i], points[i]);
        mpfr_set_ui(coefficients[i], 0, MPFR_RNDN);
    }
    divide_differences(values, points, count);
    multiply_out(coefficients, values, points, count);
    for (size_t i = 0; i < count; i++)
        mpfr_clears(points[i], values[i], (mpfr_ptr)NULL);
    mpfr_clears(low, high, (mpfr_ptr)NULL);
}
