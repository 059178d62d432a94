/* exact_roots.h - the positive roots of polynomials, to many digits.
 *
 * With MPFR, by the roots of the derivatives: between two of them a polynomial
 * is monotone.  Coefficients are taken as they are, c[i] of x^i.
 */
#ifndef EXACT_ROOTS_H
#define EXACT_ROOTS_H

#include <stdbool.h>
#include <stddef.h>

#include <mpfr.h>

enum {
    EXACT_BITS = 320,      /* of all numbers here */
    EXACT_ZERO_BITS = 200, /* |f| < 2^-200 sum |c_i| x^i is f = 0 */
    EXACT_DEGREE = 4
};

struct exact_roots {
    size_t count;
    mpfr_t x[EXACT_DEGREE];      /* ascending, each once */
    bool multiple[EXACT_DEGREE]; /* f' is 0 there as well */
};

void exact_init(struct exact_roots *roots);
void exact_clear(struct exact_roots *roots);

/* c has degree + 1 members; leading and trailing zeros do no harm. */
void exact_positive_roots(struct exact_roots *roots, mpfr_t *c, int degree);

/* f(x); and the sum of |c_i| x^i, x > 0. */
void exact_value(mpfr_t value, mpfr_t *c, int degree, const mpfr_t x);
void exact_size(mpfr_t size, mpfr_t *c, int degree, const mpfr_t x);

#endif
