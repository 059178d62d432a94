/* quartic_rule.h - checks the computed roots of a polynomial, and makes random
 * polynomials.
 *
 * The coefficients are exact as stored, in words of 47 bits. exact_roots.h computes the
 * exact roots. An island is an interval of numbers that rounding errors cannot
 * distinguish from a root (exact_roots.h). The rule:
 *
 *   1. Every computed root is on an island.
 *   2. If an island has n different roots above the bound, 1 to n of them are
 *      computed. One more root is allowed for each pair of complex roots that
 *      cannot be distinguished from a double root. There is such a pair if f'
 *      has more roots on the island than the roots of f require. There is also
 *      such a pair if f'' has a root on the island, and the island is wider
 *      than 1e-5 of the root.
 *   3. On the island that contains the bound, a root may be missing. A root
 *      equal to the bound is not a result.
 *   4. If the island is narrower than 1e-10 of the root, the error is also
 *      below 1e-10 of the root.
 *   5. t = 0 is a result if and only if the last coefficient is 0 and the
 *      bound is below 0.
 *   6. The results are in ascending order, and all are above the bound.
 */
#ifndef QUARTIC_RULE_H
#define QUARTIC_RULE_H

#include "exact_roots.h"
#include "rt/roots/roots.h"

/* Counts of the roots of many polynomials. */
struct tally {
    unsigned long polynomials, wrong;
    unsigned long roots;    /* number of roots above the bounds */
    unsigned long sharp;    /* computed roots on narrow islands (rule 4) */
    unsigned long joined;   /* roots that were merged with others */
    unsigned long touched;  /* additional computed roots, from complex pairs */
    unsigned long at_bound; /* roots that are missing on the island of the bound */
    double error;           /* largest relative error of a sharp root */
};

/* The roots of a polynomial on one side of zero: t = side x with x > 0. */
struct half {
    const struct polynomial *polynomial;
    const struct polynomial_roots *roots;
    int side; /* 1 or -1 */
    mpfr_t c[EXACT_DEGREE + 1], slope[EXACT_DEGREE + 1], curvature[EXACT_DEGREE + 1];
    mpfr_t bound, low, high, found, error;
    struct exact_roots exact, knots, bends; /* roots of f, f' and f'' */
    struct islands islands;
};

void half_init(struct half *half);
void half_clear(struct half *half);

/* Checks the computed roots of a polynomial by the rule. Returns the reason of a
 * failure, or NULL. oracle_begin must be called first. */
const char *quartic_rule(struct half *half, const struct polynomial *polynomial,
                         const struct polynomial_roots *roots, struct tally *tally);

/* The kinds of random polynomials, each difficult for a solver. */
enum quartic_kind {
    QUARTIC_COEFFICIENTS, /* random coefficients */
    QUARTIC_INTEGERS,     /* small integer coefficients */
    QUARTIC_SEPARATED,    /* real roots and complex pairs */
    QUARTIC_CLUSTERED,    /* roots 10^-1 to 10^-9 apart */
    QUARTIC_MULTIPLE,     /* double, triple or quadruple roots, exact or not */
    QUARTIC_SPREAD,       /* roots from 10^-30 to 10^30 */
    QUARTIC_GRAZING,      /* complex pairs near the real axis */
    QUARTIC_LEADING,      /* leading coefficients that are 0 or nearly 0 */
    QUARTIC_BOUND,        /* the bound is a root */
    QUARTIC_SCALED,       /* coefficients far beyond the range of doubles */
    QUARTIC_TORUS,        /* intersections with a torus of rays from its bounding
                           * sphere */
    QUARTIC_KINDS
};
const char *quartic_kind_name(enum quartic_kind kind);

/* Makes a polynomial whose coefficients are truncated to words. Half of the bounds are
 * 0. Call oracle_begin (arithmetic_oracle.h) first. */
void quartic_case(struct polynomial *polynomial, enum quartic_kind kind,
                  uint64_t *state);

#endif
