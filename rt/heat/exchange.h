/* exchange.h - what grey diffuse surfaces exchange by radiation, found by a machine
 * (rt/kernels/heat/exchange.s has the equations).
 */
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
    const double *emissivity;  /* 0 .. 1; 0: it is adiabatic, or reflects all */
    const double *temperature; /* in kelvins; of what has emissivity 0 it means
                                  nothing */
    const double *factors;     /* [count][count + 1]: of each row the last one is
                                  that to the environment; its sum is 1 */
    double outside;            /* the temperature of the environment, which is black */
    const c205_model *model;
};

/* In watts for a square metre, if areas are in square metres. */
struct exchange {
    size_t count;
    double *radiosity, *irradiation; /* of a unit of area */
    double *flow;                    /* that it loses, of all its area */
    double outside; /* .. the environment; 0 with all flows, but for what
                       factors lack in reciprocity */
    double sum;     /* of all flows */
    struct accounts accounts;
};

/* False: a figure out of range, an exchange without a solution, whose surface the error tells by
 * its number; a trap, no memory. */
bool exchange_find(const struct exchange_given *given, struct exchange *exchange,
                   c205_error *error);
void exchange_free(struct exchange *exchange);

#endif
