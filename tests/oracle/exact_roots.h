/* exact_roots.h - computes the positive roots of polynomials to many digits.
 *
 * It uses MPFR and the roots of the derivatives: between two of them a polynomial is
 * monotone.  Coefficients are exact; c[i] belongs to x^i.
 */
#ifndef EXACT_ROOTS_H
#define EXACT_ROOTS_H

#include <stdbool.h>
#include <stddef.h>

#include <mpfr.h>

enum {
    EXACT_BITS = 320,      /* of all numbers here */
    EXACT_ZERO_BITS = 200, /* |f| < 2^-200 sum |c_i| x^i counts as 0 */
    EXACT_DEGREE = 4
};

struct exact_roots {
    size_t count;
    mpfr_t x[EXACT_DEGREE];      /* ascending, distinct */
    bool multiple[EXACT_DEGREE]; /* f' is 0 there, too */
};

void exact_init(struct exact_roots *roots);
void exact_clear(struct exact_roots *roots);

/* c has degree + 1 elements; leading and trailing zeros are allowed. */
void exact_positive_roots(struct exact_roots *roots, mpfr_t *c, int degree);

/* Set value to f(x), and size to the sum of |c_i| x^i, for x > 0. */
void exact_value(mpfr_t value, mpfr_t *c, int degree, const mpfr_t x);
void exact_size(mpfr_t size, mpfr_t *c, int degree, const mpfr_t x);

#endif
