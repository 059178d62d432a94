/* elementary.c - elementary functions in double-double arithmetic.
 *
 * Every number is a pair of doubles, 106 bits, and the result is rounded once. exp, sin
 * and cos are computed by series, and tan, powers and hyperbolic functions from exp,
 * sin and cos. The inverse functions (log, asin, atan, ..) take the result of the C
 * library and correct it by one Newton step on the function that they invert. An error
 * e of the C library becomes an error of about e^2. The last bits of the C library
 * therefore do not reach the result.
 *
 * Source: T. J. Dekker, A floating-point technique for extending the available
 * precision, Numerische Mathematik 18 (1971): sums and products of two doubles.
 */
#include "rt/scene/elementary.h"

#include <math.h>
#include <stdbool.h>

/* The value is high + low. |low| is at most half a unit in the last place of high. */
struct twofold {
    double high, low;
};

#define MAX_REDUCED 0x1p30 /* radians */
#define MAX_EXP 700.       /* for larger results the C library is used */
enum { HALVINGS = 8 };

static const struct twofold one = { 1, 0 };
static const struct twofold ln2 = { 0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56 };
/* pi / 2 as the sum of three doubles. */
static const double quarter[] = { 0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54,
                                  -0x1.f1976b7ed8fbcp-110 };

/* ---- Sums, products, quotients ------------------------------------------- */

/* Returns a + b. |a| must not be below |b|. */
static struct twofold quick_sum(double a, double b)
{
    double high = a + b;
    return (struct twofold){ high, b - (high - a) };
}

static struct twofold sum(double a, double b)
{
    double high = a + b, part = high - a;
    return (struct twofold){ high, (a - (high - part)) + (b - part) };
}

static struct twofold product(double a, double b)
{
    enum { SPLIT = (1 << 27) + 1 };
    double high = a * b, c = SPLIT * a, d = SPLIT * b;
    double a1 = c - (c - a), a2 = a - a1, b1 = d - (d - b), b2 = b - b1;
    return (struct twofold){ high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2 };
}

static struct twofold minus(struct twofold a)
{
    return (struct twofold){ -a.high, -a.low };
}

static struct twofold add_twofold(struct twofold a, struct twofold b)
{
    struct twofold s = sum(a.high, b.high), t = sum(a.low, b.low);
    s = quick_sum(s.high, s.low + t.high);
    return quick_sum(s.high, s.low + t.low);
}

static struct twofold multiply(struct twofold a, struct twofold b)
{
    struct twofold p = product(a.high, b.high);
    return quick_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

static struct twofold by(struct twofold a, double b)
{
    return multiply(a, (struct twofold){ b, 0 });
}

static struct twofold divide(struct twofold a, struct twofold b)
{
    double first = a.high / b.high, second;
    struct twofold rest = add_twofold(a, minus(by(b, first)));
    second = rest.high / b.high;
    rest = add_twofold(rest, minus(by(b, second)));
    return add_twofold(quick_sum(first, second),
                       (struct twofold){ rest.high / b.high, 0 });
}

static struct twofold square_root(struct twofold a)
{
    double root = sqrt(a.high);
    struct twofold rest = add_twofold(a, minus(product(root, root)));
    return root > 0 ? add_twofold((struct twofold){ root, 0 },
                                  (struct twofold){ rest.high / (2 * root), 0 })
                    : a;
}

/* Returns the nearest double. A value that is nearly halfway between two doubles counts
 * as halfway, because the low part is first rounded to about 2^-41 units in the last
 * place. */
static double rounded(struct twofold a)
{
    double coarse = 1.5 * a.high * 0x1p-41;
    return a.high + ((a.low + coarse) - coarse);
}

/* ---- Series -------------------------------------------------------------- */

static struct twofold reciprocal(double a)
{
    double first = 1 / a;
    struct twofold back = product(first, a);
    return quick_sum(first, (1 - back.high - back.low) * first);
}

/* Returns the sum of `first` and the terms after it. A term is its predecessor times f
 * / n if the step is 1, or times f / (n (n + 1)) if the step is 2. n grows by the step.
 * Terms below 2^-56 of the sum are computed in one double, because only their leading
 * bits matter. */
static struct twofold series(struct twofold first, struct twofold f, int n, int step)
{
    struct twofold all = first, term = first;
    double small, rest = 0;
    for (; fabs(term.high) > 0x1p-56 * fabs(all.high); n += step) {
        term = multiply(multiply(term, f),
                        reciprocal(step == 1 ? n : (double)n * (n + 1)));
        all = add_twofold(all, term);
    }
    small = term.high;
    for (; fabs(small) > 0x1p-112 * fabs(all.high); n += step) {
        small *= f.high / (step == 1 ? n : (double)n * (n + 1));
        rest += small;
    }
    return add_twofold(all, (struct twofold){ rest, 0 });
}

static struct twofold sine_of(struct twofold r)
{
    return series(r, minus(multiply(r, r)), 2, 2);
}

static struct twofold cosine_of(struct twofold r)
{
    return series(one, minus(multiply(r, r)), 1, 2);
}

/* Returns x minus the nearest multiple k pi / 2, and sets the quadrant k mod 4. pi / 2
 * is the sum of three doubles. k times each of them is subtracted in turn, so that
 * cancellation leaves enough accurate bits. */
static struct twofold reduce(double x, int *quadrant)
{
    double k = floor(x / quarter[0] + .5);
    struct twofold first = product(k, quarter[0]);
    struct twofold rest = add_twofold(sum(x, -first.high),
                                      (struct twofold){ -first.low, 0 });
    *quadrant = (int)(k - 4 * floor(k / 4));
    rest = add_twofold(rest, minus(product(k, quarter[1])));
    return add_twofold(rest, minus(product(k, quarter[2])));
}

/* Returns sin(x + quadrants pi / 2). */
static struct twofold sine(double x, int quadrants)
{
    int quadrant;
    struct twofold r = reduce(x, &quadrant);
    struct twofold s;
    quadrant = (quadrant + quadrants) % 4;
    s = quadrant % 2 == 0 ? sine_of(r) : cosine_of(r);
    return quadrant < 2 ? s : minus(s);
}

static struct twofold cosine(double x)
{
    return sine(x, 1);
}

/* Returns e^x - 1 for x between -1/2 and 1/2. The series computes it for r = x /
 * 2^HALVINGS. Then r is doubled HALVINGS times by e^2r - 1 = 2 (e^r - 1) + (e^r - 1)^2,
 * which has no cancellation. */
static struct twofold power_less_one(struct twofold x)
{
    struct twofold r = by(x, 1. / (1 << HALVINGS));
    struct twofold less = series(r, r, 2, 1);
    for (int i = 0; i < HALVINGS; i++)
        less = add_twofold(by(less, 2), multiply(less, less));
    return less;
}

static struct twofold power_of_e(struct twofold x)
{
    double k = floor(x.high / ln2.high + .5);
    struct twofold power = add_twofold(one, power_less_one(
                                                add_twofold(x, minus(by(ln2, k)))));
    return (struct twofold){ ldexp(power.high, (int)k), ldexp(power.low, (int)k) };
}

static struct twofold sinh_of(struct twofold x)
{
    struct twofold e;
    if (fabs(x.high) < .5)
        return series(x, multiply(x, x), 2, 2);
    e = power_of_e(x);
    return by(add_twofold(e, minus(divide(one, e))), .5);
}

static struct twofold cosh_of(struct twofold x)
{
    struct twofold e = power_of_e(x);
    return by(add_twofold(e, divide(one, e)), .5);
}

/* ---- Inverse functions --------------------------------------------------- */

/* Returns log x, where x = m 2^k with m between 3/4 and 3/2. The C library computes y =
 * log m. Then log m = y + log(1 + off), where off = m e^-y - 1 is tiny, and log(1 +
 * off) is off - off^2 / 2. */
static struct twofold log_of(double x)
{
    int k;
    double m = frexp(x, &k), y;
    struct twofold off;
    if (m < .75) {
        m *= 2;
        k--;
    }
    y = log(m);
    off = add_twofold(by(power_less_one((struct twofold){ -y, 0 }), m), sum(m, -1));
    off = add_twofold(off, by(multiply(off, off), -.5));
    return add_twofold(by(ln2, k), add_twofold((struct twofold){ y, 0 }, off));
}

/* Returns the angle of a point other than the origin. The C library computes the angle
 * first. The error of this angle is corrected by its tangent, which is computed from
 * the sine and cosine of the angle and the point. */
static struct twofold angle_of(struct twofold y, struct twofold x)
{
    double angle = atan2(y.high, x.high);
    struct twofold s = sine(angle, 0), c = cosine(angle);
    return add_twofold((struct twofold){ angle, 0 },
                       divide(add_twofold(multiply(y, c), minus(multiply(x, s))),
                              add_twofold(multiply(x, c), multiply(y, s))));
}

/* Returns the other leg of a right triangle with hypotenuse 1 and leg x. */
static struct twofold other_side(double x)
{
    return square_root(multiply(sum(1, -x), sum(1, x)));
}

/* ---- The functions ------------------------------------------------------- */

static bool is_plain(double x)
{
    return isfinite(x) && x != 0;
}

/* Returns true if |x| is so small that the C library returns the correctly rounded
 * result, such as x for sin x and 1 for cos x. */
static bool is_tiny(double x)
{
    return fabs(x) < 0x1p-200;
}

static bool is_angle(double x)
{
    return isfinite(x) && !is_tiny(x) && fabs(x) <= MAX_REDUCED;
}

double elementary_exp(double x)
{
    return is_plain(x) && fabs(x) < MAX_EXP
               ? rounded(power_of_e((struct twofold){ x, 0 }))
               : exp(x);
}

double elementary_log(double x)
{
    return is_plain(x) && x > 0 && x != 1 ? rounded(log_of(x)) : log(x);
}

double elementary_log10(double x)
{
    return is_plain(x) && x > 0 && x != 1 ? rounded(divide(log_of(x), log_of(10)))
                                          : log10(x);
}

double elementary_pow(double x, double y)
{
    struct twofold power;
    if (!is_plain(x) || !is_plain(y) || fabs(x) == 1 || (x < 0 && y != floor(y)))
        return pow(x, y);
    power = by(log_of(fabs(x)), y);
    if (!(fabs(power.high) < MAX_EXP))
        return pow(x, y);
    return (x < 0 && fmod(y, 2) != 0 ? -1 : 1) * rounded(power_of_e(power));
}

double elementary_sin(double x)
{
    return is_angle(x) ? rounded(sine(x, 0)) : sin(x);
}

double elementary_cos(double x)
{
    return is_angle(x) ? rounded(cosine(x)) : cos(x);
}

double elementary_tan(double x)
{
    return is_angle(x) ? rounded(divide(sine(x, 0), cosine(x))) : tan(x);
}

double elementary_asin(double x)
{
    return !is_tiny(x) && fabs(x) <= 1
               ? rounded(angle_of((struct twofold){ x, 0 }, other_side(x)))
               : asin(x);
}

double elementary_acos(double x)
{
    return !is_tiny(x) && fabs(x) < 1
               ? rounded(angle_of(other_side(x), (struct twofold){ x, 0 }))
               : acos(x);
}

double elementary_atan(double x)
{
    return elementary_atan2(x, 1);
}

double elementary_atan2(double y, double x)
{
    double most = fmax(fabs(x), fabs(y)), least = fmin(fabs(x), fabs(y));
    if (!isfinite(x) || !isfinite(y) || least < 0x1p-200 * most || least == 0)
        return atan2(y, x);
    return rounded(angle_of((struct twofold){ y / exp2(ilogb(most)), 0 },
                            (struct twofold){ x / exp2(ilogb(most)), 0 }));
}

double elementary_sinh(double x)
{
    return isfinite(x) && !is_tiny(x) && fabs(x) < MAX_EXP
               ? rounded(sinh_of((struct twofold){ x, 0 }))
               : sinh(x);
}

double elementary_cosh(double x)
{
    return is_plain(x) && fabs(x) < MAX_EXP ? rounded(cosh_of((struct twofold){ x, 0 }))
                                            : cosh(x);
}

double elementary_tanh(double x)
{
    struct twofold at = { x, 0 };
    return !is_tiny(x) && fabs(x) < 30 ? rounded(divide(sinh_of(at), cosh_of(at)))
                                       : tanh(x);
}

double elementary_asinh(double x)
{
    struct twofold y = { asinh(x), 0 }, off;
    if (!isfinite(x) || is_tiny(x) || fabs(y.high) >= MAX_EXP)
        return y.high;
    off = add_twofold((struct twofold){ x, 0 }, minus(sinh_of(y)));
    return rounded(add_twofold(y, divide(off, cosh_of(y))));
}

/* Corrects acosh of the C library by one Newton step on cosh y = x. cosh y - 1 is
 * computed as 2 sinh^2 (y / 2), which has no cancellation. */
double elementary_acosh(double x)
{
    struct twofold y = { acosh(x), 0 }, half, off;
    if (!isfinite(x) || !(x > 1) || y.high >= MAX_EXP)
        return y.high;
    half = sinh_of(by(y, .5));
    off = add_twofold(sum(x, -1), by(multiply(half, half), -2));
    return rounded(add_twofold(y, divide(off, sinh_of(y))));
}

double elementary_atanh(double x)
{
    struct twofold y = { atanh(x), 0 }, s, c, off;
    if (is_tiny(x) || !(fabs(x) < 1))
        return y.high;
    s = sinh_of(y);
    c = cosh_of(y);
    off = add_twofold(by(c, x), minus(s));
    return rounded(add_twofold(y, multiply(off, c)));
}

double elementary_hypot(double x, double y)
{
    double most = fmax(fabs(x), fabs(y));
    double unit;
    struct twofold a, b;
    if (!is_plain(most) || fmin(fabs(x), fabs(y)) < 0x1p-200 * most)
        return hypot(x, y);
    unit = exp2(ilogb(most));
    a = product(x / unit, x / unit);
    b = product(y / unit, y / unit);
    return rounded(square_root(add_twofold(a, b))) * unit;
}
