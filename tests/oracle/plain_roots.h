/* plain_roots.h - the real roots of a polynomial, slowly and surely.
 *
 * Long doubles and bisection alone: between two neighbours among the roots of
 * the derivative a polynomial is monotone, so that a root lies there when the
 * signs differ, and only one.  Roots are found by signs, 0 counting as above:
 * roots of even order may be left out, or come twice.
 */
#ifndef PLAIN_ROOTS_H
#define PLAIN_ROOTS_H

#include <stddef.h>

enum { HIGHEST_DEGREE = 4 };

/* Of c[0] + c[1] t + .. + c[degree] t^degree; the highest coefficients may be
 * 0.  In no order; returns how many, at most degree. */
size_t plain_roots(const long double *c, int degree, long double roots[HIGHEST_DEGREE]);

#endif
