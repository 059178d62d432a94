/* islands.h - where a polynomial is 0 as far as 47 bits can tell.
 *
 * On t > 0 the set |f(t)| <= 2^-ISLAND_BITS sum |c_i| t^i is a few intervals,
 * the islands.  Every root of f lies in one.  An error of 2^-ISLAND_BITS in
 * each coefficient may move a root anywhere in its island, join the roots of an
 * island or let them vanish in pairs; it can do nothing outside.  So the width
 * of an island is the condition of its roots.
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
/* Of the polynomial with the coefficients c[i] of x^i; ascending. */
void islands_find(struct islands *islands, mpfr_t *c, int degree);

#endif
