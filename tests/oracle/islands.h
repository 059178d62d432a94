/* islands.h - computes where a polynomial is 0 within the accuracy of 47 bits.
 *
 * On t > 0 the set |f(t)| <= 2^-ISLAND_BITS sum |c_i| t^i consists of a few intervals,
 * the islands.  Every root of f is on one.  An error of 2^-ISLAND_BITS in each
 * coefficient may move a root anywhere on its island, join the roots of an island, or
 * remove them in pairs.  It changes nothing outside.  So the width of an island is the
 * condition of its roots.
 */
#ifndef ISLANDS_H
#define ISLANDS_H

#include "exact_roots.h"

enum { ISLAND_BITS = 43, MAX_ISLANDS = 2 * EXACT_DEGREE };

struct islands {
    size_t count;
    struct island {
        mpfr_t low, high;
    } island[MAX_ISLANDS];
};

void islands_init(struct islands *islands);
void islands_clear(struct islands *islands);
/* Computes the islands of the polynomial with coefficients c[i] of x^i, in ascending
 * order. */
void islands_find(struct islands *islands, mpfr_t *c, int degree);

#endif
