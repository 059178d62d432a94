/* thermal.h - assigns emissivities and temperatures to a scene's surfaces, and
 * computes their exchange. */
#ifndef RT_THERMAL_H
#define RT_THERMAL_H

#include "rt/heat/exchange.h"
#include "rt/heat/surfaces.h"
#include "rt/scene/named_values.h"

/* A temperature is in kelvins, or is the word "adiabatic". */
extern const struct value_kind emissivity_kind, temperature_kind;
/* The name of the environment. Its temperature may be specified like the temperature of
 * a part. */
extern const char thermal_environment[];

struct thermal {
    size_t count;        /* number of surfaces with a visible part */
    size_t *surface;     /* index of each of these surfaces */
    double *emissivity;  /* emissivity; the default is 1 */
    double *temperature; /* NaN: adiabatic */
    double outside;      /* temperature of the environment; the default is 0 */
    struct exchange exchange;
};

/* Assigns an emissivity and a temperature to each surface, and computes the exchange
 * between the surfaces. Returns false if a surface has no temperature, has parts with
 * different temperatures, or has a primitive without emission; if the exchange has no
 * solution; after a trap; or if out of memory. The error names the surface. */
bool thermal_find(const struct surfaces *surfaces, const struct named_parts *parts,
                  const struct named_values *emissivities,
                  const struct named_values *temperatures, enum trace_mode mode,
                  const c205_model *model, struct thermal *thermal, c205_error *error);
void thermal_free(struct thermal *thermal);

#endif
