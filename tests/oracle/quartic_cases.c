/* quartic_cases.c - random polynomials, most of them from their exact roots. */
#include "quartic_rule.h"

#include <math.h>
#include <string.h>

#include "arithmetic_oracle.h"
#include "tests/random.h"

enum { BITS = 400, DEGREE = 4 };

/* ---- Random numbers -------------------------------------------------- */

static double unit(uint64_t *state) /* in [0, 1) */
{
    return xorshift_real(state, 0, 1);
}

static double signed_unit(uint64_t *state)
{
    return 2 * unit(state) - 1;
}

static double power_of_ten(uint64_t *state, int low, int high)
{
    return pow(10, low + (high - low) * unit(state));
}

static int64_t integer(uint64_t *state, int64_t low, int64_t high)
{
    return xorshift_between(state, low, high);
}

/* ---- Polynomials from their roots --------------------------------------- */

/* c[0] is the leading coefficient. */
struct product {
    int degree;
    mpfr_t c[DEGREE + 1];
};

static void product_begin(struct product *product)
{
    product->degree = 0;
    for (int i = 0; i <= DEGREE; i++)
        mpfr_init2(product->c[i], BITS);
    mpfr_set_ui(product->c[0], 1, MPFR_RNDN);
    for (int i = 1; i <= DEGREE; i++)
        mpfr_set_zero(product->c[i], 1);
}

static void product_end(struct product *product)
{
    for (int i = 0; i <= DEGREE; i++)
        mpfr_clear(product->c[i]);
}

/* Multiplies a polynomial by (t - x), so x becomes a root. */
static void add_root(struct product *product, double x)
{
    mpfr_t term;
    mpfr_init2(term, BITS);
    for (int i = ++product->degree; i > 0; i--) {
        mpfr_mul_d(term, product->c[i - 1], x, MPFR_RNDN);
        mpfr_sub(product->c[i], product->c[i], term, MPFR_RNDN);
    }
    mpfr_clear(term);
}

/* Multiplies a polynomial by (t - x)^2 + y^2, so x + iy and x - iy become roots. */
static void add_pair(struct product *product, double x, double y)
{
    mpfr_t first, term;
    struct product rest;
    mpfr_inits2(BITS, first, term, (mpfr_ptr)NULL);
    product_begin(&rest);
    for (int i = 0; i <= product->degree; i++)
        mpfr_set(rest.c[i], product->c[i], MPFR_RNDN);
    rest.degree = product->degree;
    add_root(product, x);
    add_root(product, x);
    mpfr_set_d(first, y, MPFR_RNDN);
    mpfr_sqr(first, first, MPFR_RNDN);
    for (int i = 0; i <= rest.degree; i++) {
        mpfr_mul(term, rest.c[i], first, MPFR_RNDN);
        mpfr_add(product->c[i + 2], product->c[i + 2], term, MPFR_RNDN);
    }
    product_end(&rest);
    mpfr_clears(first, term, (mpfr_ptr)NULL);
}

/* Multiplies the coefficients by factor * 10^exponent, and truncates them to words. The
 * leading coefficient is the first. */
static void cut(struct polynomial *polynomial, const struct product *product,
                double factor, long exponent)
{
    mpfr_t scale, wide, narrow;
    mpfr_inits2(BITS, scale, wide, (mpfr_ptr)NULL);
    mpfr_init2(narrow, 47);
    mpfr_set_si(scale, 10, MPFR_RNDN);
    mpfr_pow_si(scale, scale, exponent, MPFR_RNDN);
    mpfr_mul_d(scale, scale, factor, MPFR_RNDN);
    for (int i = 0; i <= DEGREE; i++) {
        int from = i - (DEGREE - product->degree);
        if (from < 0) {
            polynomial->c[i] = C205_MACHINE_ZERO;
            continue;
        }
        mpfr_mul(wide, product->c[from], scale, MPFR_RNDN);
        mpfr_set(narrow, wide, MPFR_RNDD);
        polynomial->c[i] = oracle_word(&oracle_full, narrow);
    }
    mpfr_clears(scale, wide, narrow, (mpfr_ptr)NULL);
}

/* ---- The kinds ---------------------------------------------------------- */

typedef void make_product(struct product *product, uint64_t *state);

static void make_separated(struct product *product, uint64_t *state)
{
    int degree = (int)integer(state, 1, DEGREE);
    while (product->degree < degree)
        if (degree - product->degree >= 2 && unit(state) < 0.25)
            add_pair(product, 5 * signed_unit(state), 5 * unit(state));
        else
            add_root(product, 5 * signed_unit(state));
}

static void make_clustered(struct product *product, uint64_t *state)
{
    double apart = power_of_ten(state, -9, -1);
    double x = 5 * signed_unit(state);
    int64_t cluster = integer(state, 2, DEGREE);
    for (int64_t i = 0; i < cluster; i++) {
        add_root(product, x);
        x += apart * (0.5 + unit(state)) * fabs(x);
    }
    while (product->degree < DEGREE)
        add_root(product, 5 * signed_unit(state));
}

static void make_multiple(struct product *product, uint64_t *state)
{
    double fineness = unit(state) < 0.5 ? 1 : unit(state) < 0.5 ? 8 : 0;
    int degree = (int)integer(state, 2, DEGREE);
    int64_t times = integer(state, 2, degree);
    while (product->degree < degree) {
        double x = fineness != 0 ? (double)integer(state, -40, 40) / fineness
                                 : 5 * signed_unit(state);
        for (; times > 0 && product->degree < degree; times--)
            add_root(product, x);
        times = integer(state, 1, 2);
    }
}

static void make_spread(struct product *product, uint64_t *state)
{
    int degree = (int)integer(state, 2, DEGREE);
    while (product->degree < degree)
        add_root(product, (unit(state) < 0.3 ? -1 : 1) * power_of_ten(state, -30, 30));
}

static void make_grazing(struct product *product, uint64_t *state)
{
    double x = 5 * signed_unit(state);
    add_pair(product, x, fabs(x) * power_of_ten(state, -9, -1));
    if (unit(state) < 0.5) {
        add_root(product, 5 * signed_unit(state));
        add_root(product, 5 * signed_unit(state));
    } else if (unit(state) < 0.5) {
        x = 5 * signed_unit(state);
        add_pair(product, x, fabs(x) * power_of_ten(state, -9, -1));
    }
}

static const struct {
    const char *name;
    make_product *make; /* NULL: not made from roots */
} kinds[QUARTIC_KINDS] = {
    [QUARTIC_COEFFICIENTS] = { "coefficients", NULL },
    [QUARTIC_INTEGERS] = { "integers", NULL },
    [QUARTIC_SEPARATED] = { "separated", make_separated },
    [QUARTIC_CLUSTERED] = { "clustered", make_clustered },
    [QUARTIC_MULTIPLE] = { "multiple", make_multiple },
    [QUARTIC_SPREAD] = { "spread", make_spread },
    [QUARTIC_GRAZING] = { "grazing", make_grazing },
    [QUARTIC_LEADING] = { "leading", make_separated },
    [QUARTIC_BOUND] = { "bound", make_separated },
    [QUARTIC_SCALED] = { "scaled", make_spread },
    [QUARTIC_TORUS] = { "torus", NULL },
};

const char *quartic_kind_name(enum quartic_kind kind)
{
    return kinds[kind].name;
}

/* Sets v to a random point on the unit sphere. */
static void direction(double *v, uint64_t *state)
{
    double length;
    do {
        length = 0;
        for (int i = 0; i < 3; i++) {
            v[i] = signed_unit(state);
            length += v[i] * v[i];
        }
    } while (length > 1 || length < 0.01);
    for (int i = 0; i < 3; i++)
        v[i] /= sqrt(length);
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The intersections of a torus and a ray.  The ray starts at p on the bounding sphere,
 * in the direction d of a point inside.  The torus is
 *     (|X|^2 - R^2 - r^2)^2 + 4 R^2 (y^2 - r^2) = 0.
 * Source: POV-Ray's torus.cpp; the project's notes on ray tracing, 1. */
static void make_torus(struct polynomial *polynomial, uint64_t *state)
{
    double major = 1, minor = 0.25;
    double p[3], d[3], k1, k2, length;
    direction(p, state);
    direction(d, state);
    for (int i = 0; i < 3; i++) {
        double inside = (major + minor) * d[i] * cbrt(unit(state));
        p[i] *= major + minor;
        d[i] = inside - p[i];
    }
    length = sqrt(dot(d, d));
    for (int i = 0; i < 3; i++)
        d[i] /= length;
    k1 = dot(p, p) - major * major - minor * minor;
    k2 = dot(p, d);
    const double c[] = { 1, 4 * k2,
                         2 * (k1 + 2 * (k2 * k2 + major * major * d[1] * d[1])),
                         4 * (k2 * k1 + 2 * major * major * p[1] * d[1]),
                         k1 * k1 + 4 * major * major * (p[1] * p[1] - minor * minor) };
    for (int i = 0; i <= DEGREE; i++)
        polynomial->c[i] = c205_from_double(c[i]);
}

static void make_coefficients(struct polynomial *polynomial, enum quartic_kind kind,
                              uint64_t *state)
{
    for (int i = 0; i <= DEGREE; i++)
        polynomial->c[i] = kind == QUARTIC_INTEGERS
                               ? c205_from_double((double)integer(state, -20, 20))
                               : c205_from_double(signed_unit(state));
}

/* Replaces leading zeros by numbers near 0, which add a root far away. */
static void weaken(struct polynomial *polynomial, uint64_t *state)
{
    for (int i = 0; i < 3 && unit(state) < 0.6; i++)
        if (polynomial->c[i] == C205_MACHINE_ZERO)
            polynomial->c[i] = c205_from_double(signed_unit(state)
                                                * power_of_ten(state, -40, -3));
}

void quartic_case(struct polynomial *polynomial, enum quartic_kind kind,
                  uint64_t *state)
{
    struct product product;
    double bound = unit(state) < 0.5 ? 0 : 6 * signed_unit(state);
    product_begin(&product);
    if (kind == QUARTIC_BOUND) {
        bound = (double)integer(state, -30, 30) / 4;
        add_root(&product, bound);
    }
    if (kinds[kind].make) {
        kinds[kind].make(&product, state);
        cut(polynomial, &product, signed_unit(state),
            kind == QUARTIC_SCALED ? (long)integer(state, -4000, 4000) : 0);
    } else if (kind == QUARTIC_TORUS) {
        make_torus(polynomial, state);
        bound = 0;
    } else {
        make_coefficients(polynomial, kind, state);
    }
    if (kind == QUARTIC_LEADING)
        weaken(polynomial, state);
    if (kind == QUARTIC_SPREAD && unit(state) < 0.5)
        bound = -power_of_ten(state, -30, 31);
    polynomial->bound = c205_from_double(bound);
    product_end(&product);
}
