/* plain_roots.c - bisection between roots of the derivative (plain_roots.h). */
#include "tests/oracle/plain_roots.h"

#include <math.h>
#include <stdbool.h>

struct polynomial {
    int degree;
    long double c[HIGHEST_DEGREE + 1];
};

static bool is_below(const struct polynomial *f, long double t)
{
    long double value = 0;
    for (int i = f->degree; i >= 0; i--)
        value = value * t + f->c[i];
    return value < 0;
}

static struct polynomial derivative(const struct polynomial *f)
{
    struct polynomial result = { f->degree - 1, { 0 } };
    for (int i = 0; i < f->degree; i++)
        result.c[i] = (long double)(i + 1) * f->c[i + 1];
    return result;
}

/* Bisects an interval whose ends have different signs. */
static long double bisect(const struct polynomial *f, long double low, long double high)
{
    long double close = 1e-24L; /* far below the last bit of a double */
    bool below = is_below(f, low);
    while (high - low > close) {
        long double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            break;
        if (is_below(f, middle) == below)
            low = middle;
        else
            high = middle;
    }
    return low + (high - low) / 2;
}

/* Computes the roots from low to high, in ascending order. */
static size_t roots_between(const struct polynomial *f, long double low,
                            long double high, long double *roots)
{
    long double knots[HIGHEST_DEGREE + 1] = { low };
    size_t inner = 0, count = 0;
    if (f->degree == 0)
        return 0;
    struct polynomial slope = derivative(f);
    inner = roots_between(&slope, low, high, knots + 1);
    knots[inner + 1] = high;
    for (size_t i = 0; i <= inner; i++)
        if (is_below(f, knots[i]) != is_below(f, knots[i + 1]))
            roots[count++] = bisect(f, knots[i], knots[i + 1]);
    return count;
}

/* Roots outside of -1 to 1 are reciprocals of roots of the polynomial with reversed
 * coefficients. So no bound of the roots is needed, and a leading 0 loses no root. */
size_t plain_roots(const long double *c, int degree, long double roots[HIGHEST_DEGREE])
{
    struct polynomial forward = { degree, { 0 } };
    struct polynomial backward = { degree, { 0 } };
    long double inverse[HIGHEST_DEGREE];
    for (int i = 0; i <= degree; i++)
        forward.c[i] = backward.c[degree - i] = c[i];
    size_t count = roots_between(&forward, -1, 1, roots);
    size_t beyond = roots_between(&backward, -1, 1, inverse);
    for (size_t i = 0; i < beyond; i++)
        if (isfinite((double)(1 / inverse[i])) && count < (size_t)degree)
            roots[count++] = 1 / inverse[i];
    return count;
}
