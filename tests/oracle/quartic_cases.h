/* quartic_cases.h - random polynomials, of every kind that is hard. */
#ifndef QUARTIC_CASES_H
#define QUARTIC_CASES_H

#include "rt/roots/roots.h"

enum quartic_kind {
    QUARTIC_COEFFICIENTS, /* at random */
    QUARTIC_INTEGERS,     /* small ones */
    QUARTIC_SEPARATED,    /* real roots and pairs of complex ones */
    QUARTIC_CLUSTERED,    /* roots 10^-1 .. 10^-9 apart */
    QUARTIC_MULTIPLE,     /* double, triple, quadruple; exact or not */
    QUARTIC_SPREAD,       /* sizes of 10^-30 .. 10^30 */
    QUARTIC_GRAZING,      /* complex pairs near the real axis */
    QUARTIC_LEADING,      /* leading coefficients 0 or nearly so */
    QUARTIC_BOUND,        /* the bound is a root */
    QUARTIC_SCALED,       /* coefficients far beyond those of doubles */
    QUARTIC_TORUS,        /* rays and a torus, from its bounding sphere */
    QUARTIC_KINDS
};
const char *quartic_kind_name(enum quartic_kind kind);

/* A polynomial whose coefficients are cut to words; half of the bounds are 0.
 * oracle_begin (arithmetic_oracle.h) must have been called. */
void quartic_case(struct polynomial *polynomial, enum quartic_kind kind,
                  uint64_t *state);

#endif
