/* islands.c - computes the islands of a polynomial from the roots of its neighbours. */
#include "islands.h"

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

/* Computes the points with f = +-2^-ISLAND_BITS sum |c_i| x^i: roots of a polynomial
 * whose coefficients are changed by that much. */
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

/* Returns whether |f| is within the bound between two shores. */
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

/* Merges both lists in ascending order. */
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
