/* exact_roots.c - isolates roots between the roots of the derivative, and refines them.
 * Computes the islands of a polynomial from the roots of neighbouring polynomials. */
#include "exact_roots.h"

enum { MAX_NEWTON = 80, CLOSE_BITS = EXACT_BITS - 40 };

void exact_init(struct exact_roots *roots)
{
    roots->count = 0;
    for (int i = 0; i < EXACT_DEGREE; i++)
        mpfr_init2(roots->x[i], EXACT_BITS);
}

void exact_clear(struct exact_roots *roots)
{
    for (int i = 0; i < EXACT_DEGREE; i++)
        mpfr_clear(roots->x[i]);
}

void exact_value(mpfr_t value, mpfr_t *c, int degree, const mpfr_t x)
{
    mpfr_set(value, c[degree], MPFR_RNDN);
    for (int i = degree - 1; i >= 0; i--)
        mpfr_fma(value, value, x, c[i], MPFR_RNDN);
}

void exact_size(mpfr_t size, mpfr_t *c, int degree, const mpfr_t x)
{
    mpfr_t magnitude;
    mpfr_init2(magnitude, EXACT_BITS);
    mpfr_abs(size, c[degree], MPFR_RNDN);
    for (int i = degree - 1; i >= 0; i--) {
        mpfr_abs(magnitude, c[i], MPFR_RNDN);
        mpfr_fma(size, size, x, magnitude, MPFR_RNDN);
    }
    mpfr_clear(magnitude);
}

static bool is_zero_at(mpfr_t *c, int degree, const mpfr_t x, const mpfr_t value)
{
    mpfr_t size;
    mpfr_init2(size, EXACT_BITS);
    exact_size(size, c, degree, x);
    mpfr_div_2si(size, size, EXACT_ZERO_BITS, MPFR_RNDN);
    bool zero = mpfr_cmpabs(value, size) <= 0;
    mpfr_clear(size);
    return zero;
}

/* Returns the exponent of Cauchy's bounds: all positive roots are between 2^-bound and
 * 2^bound. c[0] and c[degree] must not be 0. */
static long bound_exponent(mpfr_t *c, int degree)
{
    mpfr_exp_t largest = mpfr_get_exp(c[0]);
    mpfr_exp_t least = mpfr_get_exp(c[0]);
    if (mpfr_get_exp(c[degree]) < least)
        least = mpfr_get_exp(c[degree]);
    for (int i = 1; i <= degree; i++)
        if (!mpfr_zero_p(c[i]) && mpfr_get_exp(c[i]) > largest)
            largest = mpfr_get_exp(c[i]);
    return (long)(largest - least) + 2;
}

/* Temporary numbers of one search. */
struct search {
    mpfr_t *c;
    int degree;
    int sign; /* sign of the polynomial at b */
    mpfr_t a, b, x, f, slope, step;
    mpfr_t derivative[EXACT_DEGREE];
};

static int sign_at(struct search *s)
{
    exact_value(s->f, s->c, s->degree, s->x);
    return mpfr_sgn(s->f);
}

static void narrow(struct search *s, int sign)
{
    mpfr_set(sign == s->sign ? s->b : s->a, s->x, MPFR_RNDN);
}

/* Bisects the exponent until b <= 2 a. */
static void halve_wide(struct search *s)
{
    for (;;) {
        mpfr_mul_2ui(s->step, s->a, 1, MPFR_RNDN);
        if (mpfr_lessequal_p(s->b, s->step))
            return;
        mpfr_mul(s->x, s->a, s->b, MPFR_RNDN);
        mpfr_sqrt(s->x, s->x, MPFR_RNDN);
        int sign = sign_at(s);
        if (sign == 0)
            sign = s->sign;
        narrow(s, sign);
    }
}

/* Makes a Newton step from x, or a step to the middle of the bracket. */
static void step_from(struct search *s, int steps)
{
    exact_value(s->slope, s->derivative, s->degree - 1, s->x);
    mpfr_div(s->step, s->f, s->slope, MPFR_RNDN);
    mpfr_sub(s->step, s->x, s->step, MPFR_RNDN);
    if (!mpfr_number_p(s->step) || mpfr_lessequal_p(s->step, s->a)
        || mpfr_greaterequal_p(s->step, s->b) || steps > MAX_NEWTON) {
        mpfr_add(s->step, s->a, s->b, MPFR_RNDN);
        mpfr_div_2ui(s->step, s->step, 1, MPFR_RNDN);
    }
}

/* Sets x to the root in (a, b). The signs at a and b differ. */
static void close_in(struct search *s)
{
    halve_wide(s);
    mpfr_add(s->x, s->a, s->b, MPFR_RNDN);
    mpfr_div_2ui(s->x, s->x, 1, MPFR_RNDN);
    for (int steps = 0;; steps++) {
        int sign = sign_at(s);
        if (sign == 0)
            return;
        narrow(s, sign);
        step_from(s, steps);
        mpfr_sub(s->f, s->step, s->x, MPFR_RNDN);
        mpfr_set(s->x, s->step, MPFR_RNDN);
        if (mpfr_zero_p(s->f) || mpfr_get_exp(s->f) < mpfr_get_exp(s->x) - CLOSE_BITS)
            return;
    }
}

static void search_init(struct search *s, mpfr_t *c, int degree)
{
    s->c = c;
    s->degree = degree;
    mpfr_inits2(EXACT_BITS, s->a, s->b, s->x, s->f, s->slope, s->step, (mpfr_ptr)NULL);
    for (int i = 0; i < EXACT_DEGREE; i++) {
        mpfr_init2(s->derivative[i], EXACT_BITS);
        if (i < degree)
            mpfr_mul_ui(s->derivative[i], c[i + 1], (unsigned long)i + 1, MPFR_RNDN);
    }
}

static void search_clear(struct search *s)
{
    mpfr_clears(s->a, s->b, s->x, s->f, s->slope, s->step, (mpfr_ptr)NULL);
    for (int i = 0; i < EXACT_DEGREE; i++)
        mpfr_clear(s->derivative[i]);
}

static void add_root(struct exact_roots *roots, const mpfr_t x, bool multiple)
{
    mpfr_set(roots->x[roots->count], x, MPFR_RNDN);
    roots->multiple[roots->count++] = multiple;
}

/* Searches for roots between successive knots, up to the bound, from s->a on. */
static void search_between(struct search *s, const struct exact_roots *knots,
                           struct exact_roots *roots, long bound)
{
    int left = mpfr_sgn(s->c[0]);
    mpfr_t knot;
    mpfr_init2(knot, EXACT_BITS);
    mpfr_set_ui_2exp(knot, 1, -bound, MPFR_RNDN);
    for (size_t i = 0; i <= knots->count; i++) {
        mpfr_set(s->a, knot, MPFR_RNDN);
        if (i < knots->count)
            mpfr_set(knot, knots->x[i], MPFR_RNDN);
        else
            mpfr_set_ui_2exp(knot, 1, bound, MPFR_RNDN);
        mpfr_set(s->b, knot, MPFR_RNDN);
        mpfr_set(s->x, knot, MPFR_RNDN);
        int right = s->sign = sign_at(s);
        if (is_zero_at(s->c, s->degree, knot, s->f)) {
            add_root(roots, knot, true);
            right = 0;
        } else if (left != 0 && left != right) {
            close_in(s);
            add_root(roots, s->x, false);
        }
        left = right;
    }
    mpfr_clear(knot);
}

void exact_positive_roots(struct exact_roots *roots, mpfr_t *c, int degree)
{
    struct exact_roots knots;
    struct search s;
    roots->count = 0;
    while (degree > 0 && mpfr_zero_p(c[degree]))
        degree--;
    while (degree > 0 && mpfr_zero_p(c[0])) {
        c++;
        degree--;
    }
    if (degree == 0)
        return;
    exact_init(&knots);
    search_init(&s, c, degree);
    exact_positive_roots(&knots, s.derivative, degree - 1);
    search_between(&s, &knots, roots, bound_exponent(c, degree));
    search_clear(&s);
    exact_clear(&knots);
}

/* ---- Islands ------------------------------------------------------------- */

enum { SHORES = 2 * EXACT_DEGREE };

void islands_init(struct islands *islands)
{
    islands->count = 0;
    for (int i = 0; i < MAX_ISLANDS; i++)
        mpfr_inits2(EXACT_BITS, islands->island[i].low, islands->island[i].high,
                    (mpfr_ptr)NULL);
}

void islands_clear(struct islands *islands)
{
    for (int i = 0; i < MAX_ISLANDS; i++)
        mpfr_clears(islands->island[i].low, islands->island[i].high, (mpfr_ptr)NULL);
}

/* Computes the points where f = +-2^-ISLAND_BITS sum |c_i| x^i. They are roots of a
 * polynomial whose coefficients are changed by this amount. */
static void find_shores(struct exact_roots *shores, mpfr_t *c, int degree, int sign)
{
    mpfr_t moved[EXACT_DEGREE + 1];
    for (int i = 0; i <= degree; i++) {
        mpfr_init2(moved[i], EXACT_BITS);
        mpfr_abs(moved[i], c[i], MPFR_RNDN);
        mpfr_div_2ui(moved[i], moved[i], ISLAND_BITS, MPFR_RNDN);
        mpfr_mul_si(moved[i], moved[i], sign, MPFR_RNDN);
        mpfr_add(moved[i], moved[i], c[i], MPFR_RNDN);
    }
    exact_positive_roots(shores, moved, degree);
    for (int i = 0; i <= degree; i++)
        mpfr_clear(moved[i]);
}

/* Returns true if |f| is within the bound between two shores. */
static bool is_land(mpfr_t *c, int degree, const mpfr_t a, const mpfr_t b)
{
    mpfr_t x, value, size;
    mpfr_inits2(EXACT_BITS, x, value, size, (mpfr_ptr)NULL);
    mpfr_add(x, a, b, MPFR_RNDN);
    mpfr_div_2ui(x, x, 1, MPFR_RNDN);
    exact_value(value, c, degree, x);
    exact_size(size, c, degree, x);
    mpfr_div_2ui(size, size, ISLAND_BITS, MPFR_RNDN);
    bool land = mpfr_cmpabs(value, size) <= 0;
    mpfr_clears(x, value, size, (mpfr_ptr)NULL);
    return land;
}

/* Merges the roots of a and b in ascending order. Returns their number. */
static size_t merge(mpfr_ptr *shores, struct exact_roots *a, struct exact_roots *b)
{
    size_t count = 0, i = 0, j = 0;
    while (i < a->count || j < b->count)
        if (j == b->count || (i < a->count && mpfr_lessequal_p(a->x[i], b->x[j])))
            shores[count++] = a->x[i++];
        else
            shores[count++] = b->x[j++];
    return count;
}

void islands_find(struct islands *islands, mpfr_t *c, int degree)
{
    struct exact_roots above, below;
    mpfr_ptr shores[SHORES];
    exact_init(&above);
    exact_init(&below);
    find_shores(&above, c, degree, 1);
    find_shores(&below, c, degree, -1);
    size_t count = merge(shores, &above, &below);
    islands->count = 0;
    for (size_t i = 0; i + 1 < count; i++) {
        struct island *island = &islands->island[islands->count];
        if (!is_land(c, degree, shores[i], shores[i + 1]))
            continue;
        if (islands->count > 0 && mpfr_equal_p(island[-1].high, shores[i])) {
            mpfr_set(island[-1].high, shores[i + 1], MPFR_RNDU);
            continue;
        }
        mpfr_set(island->low, shores[i], MPFR_RNDD);
        mpfr_set(island->high, shores[i + 1], MPFR_RNDU);
        islands->count++;
    }
    exact_clear(&above);
    exact_clear(&below);
}
