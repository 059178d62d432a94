/* plain_roots.h - finds the real roots of a polynomial by a slow, robust method.
 *
 * The method is bisection in long doubles. Between two adjacent roots of its derivative
 * a polynomial is monotone, so it has a root there if the signs at both ends differ. A
 * value of 0 counts as positive. Roots of even order may therefore be missed, or
 * returned twice.
 */
#ifndef PLAIN_ROOTS_H
#define PLAIN_ROOTS_H

#include <stddef.h>

enum { HIGHEST_DEGREE = 4 };

/* Computes the roots of c[0] + c[1] t + ... + c[degree] t^degree in any order, and
 * returns their number, which is at most degree. The highest coefficients may be 0. */
size_t plain_roots(const long double *c, int degree, long double roots[HIGHEST_DEGREE]);

#endif
