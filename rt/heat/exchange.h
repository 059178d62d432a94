/* exchange.h - computes the radiative exchange between grey diffuse surfaces, on a
 * machine (rt/kernels/heat/exchange.s has the equations). */
#ifndef RT_EXCHANGE_H
#define RT_EXCHANGE_H

#include "base/accounts.h"
#include "rt/trace/trace.h"

enum { MAX_EXCHANGE = 4096 }; /* surfaces */

struct exchange_given {
    enum trace_mode mode;
    size_t count;             /* surfaces, 1 .. MAX_EXCHANGE */
    const char *const *names; /* for errors */
    const double *area;
    const double *emissivity;  /* 0 .. 1; 0: the surface is adiabatic, or reflects
                                * everything */
    const double *temperature; /* in kelvins; ignored for emissivity 0 */
    const double *factors;     /* [count][count + 1]; the last one of each row is the
                                * factor to the environment; each row sums to 1 */
    double outside;            /* the temperature of the environment, which is black */
    const c205_model *model;
};

/* The result, in watts per square metre if areas are in square metres. */
struct exchange {
    size_t count;
    double *radiosity, *irradiation; /* per unit of area */
    double *flow;                    /* net loss of the whole area */
    double outside; /* net loss of the environment; it cancels the sum of the other
                     * flows, except for the errors of reciprocity in the factors */
    double sum;     /* of all flows */
    struct accounts accounts;
};

/* Returns false for a number out of range, for an exchange without a solution,
 * whose surface the error names, after a trap, or if out of memory. */
bool exchange_find(const struct exchange_given *given, struct exchange *exchange,
                   c205_error *error);
void exchange_free(struct exchange *exchange);

#endif
