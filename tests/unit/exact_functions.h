/* exact_functions.h - reference values of the routines of asm/lib and their
 * polynomials. MPFR computes them to any number of digits. */
#ifndef EXACT_FUNCTIONS_H
#define EXACT_FUNCTIONS_H

#include <mpfr.h>

/* A function of x, or of x and y. */
typedef void exact_function(mpfr_t value, const mpfr_t x, const mpfr_t y);

exact_function exact_exp, exact_log, exact_sin, exact_cos, exact_atan2, exact_power;

/* A polynomial that interpolates `value` at `count` Chebyshev points of `bounds`. */
struct exact_polynomial {
    const char *label; /* label of the coefficients; the lowest power is the first */
    size_t count;
    void (*bounds)(mpfr_t low, mpfr_t high);
    void (*value)(mpfr_t value, const mpfr_t at);
};

/* Returns the i-th polynomial, or NULL after the last. */
const struct exact_polynomial *exact_polynomial_at(size_t i);

/* Computes the coefficients of a polynomial. They are initialised here, and the caller
 * clears them. */
enum { EXACT_COEFFICIENTS = 16 };
void exact_coefficients(const struct exact_polynomial *polynomial,
                        mpfr_t coefficients[]);

#endif
