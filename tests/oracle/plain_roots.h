/* plain_roots.h - the real roots of a polynomial by a slow, robust method.
 *
 * The method uses bisection in long doubles.  Between two adjacent roots of its
 * derivative a polynomial is monotone: one root is there if the signs at the ends
 * differ.  A value of 0 counts as positive.  So roots of even order may be missed, or
 * be returned twice.
 */
#ifndef PLAIN_ROOTS_H
#define PLAIN_ROOTS_H

#include <stddef.h>

enum { HIGHEST_DEGREE = 4 };

/* Computes the roots of c[0] + c[1] t + ... + c[degree] t^degree, in no order, and
 * returns their number, at most degree.  The highest coefficients may be 0. */
size_t plain_roots(const long double *c, int degree, long double roots[HIGHEST_DEGREE]);

#endif
