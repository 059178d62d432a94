/* exact_functions.h - what the routines of asm/lib are to compute, with as many digits as asked
 * for, and the polynomials that they are made of, by MPFR.
 */
#ifndef EXACT_FUNCTIONS_H
#define EXACT_FUNCTIONS_H

#include <mpfr.h>

/* A function of one number, or of two. */
typedef void exact_function(mpfr_t value, const mpfr_t x, const mpfr_t y);

exact_function exact_exp, exact_log, exact_sin, exact_cos, exact_atan2, exact_power;

/* What a polynomial goes through, at count Chebyshev points from low to high. */
struct exact_polynomial {
    const char *label; /* where a routine has its coefficients, the lowest first */
    size_t count;
    void (*bounds)(mpfr_t low, mpfr_t high);
    void (*value)(mpfr_t value, const mpfr_t at);
};

/* NULL behind the last. */
const struct exact_polynomial *exact_polynomial_at(size_t i);

/* The coefficients of it; each is initialised here, and cleared by the caller. */
enum { EXACT_COEFFICIENTS = 16 };
void exact_coefficients(const struct exact_polynomial *polynomial,
                        mpfr_t coefficients[]);

#endif
