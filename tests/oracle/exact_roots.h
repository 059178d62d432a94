/* exact_roots.h - computes the positive roots of polynomials to many digits, and their
 * islands.
 *
 * It uses MPFR. Between two roots of its derivative a polynomial is monotone, so the
 * roots of the derivatives separate its roots. Coefficients are exact. c[i] is the
 * coefficient of x^i.
 */
#ifndef EXACT_ROOTS_H
#define EXACT_ROOTS_H

#include <stdbool.h>
#include <stddef.h>

#include <mpfr.h>

enum {
    EXACT_BITS = 320,      /* precision of all numbers here */
    EXACT_ZERO_BITS = 200, /* |f| < 2^-200 sum |c_i| x^i counts as 0 */
    EXACT_DEGREE = 4
};

struct exact_roots {
    size_t count;
    mpfr_t x[EXACT_DEGREE];      /* distinct, in ascending order */
    bool multiple[EXACT_DEGREE]; /* true if f' is also 0 there */
};

void exact_init(struct exact_roots *roots);
void exact_clear(struct exact_roots *roots);

/* Computes the positive roots of a polynomial. c has degree + 1 elements; leading and
 * trailing zeros are allowed. */
void exact_positive_roots(struct exact_roots *roots, mpfr_t *c, int degree);

/* exact_value computes f(x), exact_size the sum of |c_i| x^i for positive x. */
void exact_value(mpfr_t value, mpfr_t *c, int degree, const mpfr_t x);
void exact_size(mpfr_t size, mpfr_t *c, int degree, const mpfr_t x);

/* Islands: where a polynomial is 0 within the accuracy of 47 bits.
 *
 * For t > 0 the inequality |f(t)| <= 2^-ISLAND_BITS sum |c_i| t^i holds in a few
 * intervals, the islands. Every root of f is on an island. A relative error of
 * 2^-ISLAND_BITS in each coefficient can move a root to any point of its island, join
 * the roots of an island, or remove them in pairs. It cannot add roots outside of the
 * islands. The width of an island is therefore the condition of its roots.
 */
enum { ISLAND_BITS = 43, MAX_ISLANDS = 2 * EXACT_DEGREE };

struct islands {
    size_t count;
    struct island {
        mpfr_t low, high;
    } island[MAX_ISLANDS];
};

void islands_init(struct islands *islands);
void islands_clear(struct islands *islands);
/* Computes the islands of the polynomial with coefficients c[i] of x^i, ascending. */
void islands_find(struct islands *islands, mpfr_t *c, int degree);

#endif
