/* exchange.h - computes the radiative exchange between grey diffuse surfaces on a
 * machine. rt/kernels/heat/exchange.s contains the equations. */
#ifndef RT_EXCHANGE_H
#define RT_EXCHANGE_H

#include "base/accounts.h"
#include "rt/trace/trace.h"

enum { MAX_EXCHANGE = 4096 }; /* largest number of surfaces */

struct exchange_given {
    enum trace_mode mode;
    size_t count;             /* number of surfaces, 1 .. MAX_EXCHANGE */
    const char *const *names; /* names of the surfaces, for error messages */
    const double *area;
    const double *emissivity;  /* 0 .. 1; a surface with 0 is adiabatic, or reflects
                                * everything */
    const double *temperature; /* in kelvins; ignored for emissivity 0 */
    const double *factors;     /* [count][count + 1]; the last element of a row is the
                                * factor to the environment; the sum of a row is 1 */
    double outside;            /* temperature of the environment, which is black */
    const c205_model *model;
};

/* The result, in watts per square metre if areas are in square metres. */
struct exchange {
    size_t count;
    double *radiosity, *irradiation; /* for each surface, per unit of area */
    double *flow;                    /* net loss of the whole surface */
    double outside; /* net loss of the environment; it cancels the sum of the other
                     * flows, except for errors of reciprocity in the factors */
    double sum;     /* sum of all flows */
    struct accounts accounts;
};

/* Computes the exchange. Returns false if a number is out of range, if the exchange has
 * no solution (the error then names the surface), after a trap, or if out of memory. */
bool exchange_find(const struct exchange_given *given, struct exchange *exchange,
                   c205_error *error);
void exchange_free(struct exchange *exchange);

#endif
