/* quartic_cases.h - random polynomials of every difficult kind. */
#ifndef QUARTIC_CASES_H
#define QUARTIC_CASES_H

#include "rt/roots/roots.h"

enum quartic_kind {
    QUARTIC_COEFFICIENTS, /* random */
    QUARTIC_INTEGERS,     /* small */
    QUARTIC_SEPARATED,    /* real roots and complex pairs */
    QUARTIC_CLUSTERED,    /* roots 10^-1 to 10^-9 apart */
    QUARTIC_MULTIPLE,     /* double, triple, quadruple; exact or not */
    QUARTIC_SPREAD,       /* sizes of 10^-30 to 10^30 */
    QUARTIC_GRAZING,      /* complex pairs near the real axis */
    QUARTIC_LEADING,      /* leading coefficients that are 0 or nearly 0 */
    QUARTIC_BOUND,        /* the bound is a root */
    QUARTIC_SCALED,       /* coefficients far beyond the range of doubles */
    QUARTIC_TORUS,        /* rays from the bounding sphere of a torus */
    QUARTIC_KINDS
};
const char *quartic_kind_name(enum quartic_kind kind);

/* Makes a polynomial whose coefficients are truncated to words; half of the bounds are
 * 0.  Requires oracle_begin (arithmetic_oracle.h). */
void quartic_case(struct polynomial *polynomial, enum quartic_kind kind,
                  uint64_t *state);

#endif
