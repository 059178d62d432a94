/* quartic_rule.h - are these the roots of a polynomial?
 *
 * The polynomial is taken as it is stored, in words of 47 bits; its exact roots
 * come from exact_roots.h.  The rule, with islands as islands.h has them:
 *
 *   1. every root found lies on an island
 *   2. on an island with n different roots above the bound, 1 to n are found;
 *      so where there is one, one.  It may be one more for each pair of
 *      complex roots too near to be told from a double root: where f' has more
 *      roots there than lie between and at those of f, or where f'' has one and
 *      the island is wider than 1e-5 of the root.
 *   3. on the island of the bound a root may be missed; a root that is the
 *      bound itself is not found
 *   4. where the island is narrower than 1e-10 of the root, the error is too
 *   5. t = 0 is found if and only if the last coefficient is 0 and the bound
 *      below 0
 *   6. the roots ascend from above the bound
 */
#ifndef QUARTIC_RULE_H
#define QUARTIC_RULE_H

#include "islands.h"
#include "rt/roots/roots.h"

/* Results of many polynomials. */
struct tally {
    unsigned long polynomials, wrong;
    unsigned long roots;    /* above the bounds */
    unsigned long sharp;    /* of these, found on islands as in 4 */
    unsigned long joined;   /* not found for themselves, but with others */
    unsigned long touched;  /* found beyond their number: complex pairs */
    unsigned long at_bound; /* missed on the island of the bound */
    double error;           /* the largest relative one of a sharp root */
};

/* What is looked at: the roots t = side x with x > 0. */
struct half {
    const struct polynomial *polynomial;
    const struct polynomial_roots *roots;
    int side; /* 1, -1 */
    mpfr_t c[EXACT_DEGREE + 1], slope[EXACT_DEGREE];
    mpfr_t curvature[EXACT_DEGREE - 1];
    mpfr_t bound, low, high, found, error;
    struct exact_roots exact, knots, bends; /* of f, f', f'' */
    struct islands islands;
};

void half_init(struct half *half);
void half_clear(struct half *half);

/* What is wrong; NULL: nothing.  oracle_begin (arithmetic_oracle.h) must have
 * been called. */
const char *quartic_rule(struct half *half, const struct polynomial *polynomial,
                         const struct polynomial_roots *roots, struct tally *tally);

#endif
