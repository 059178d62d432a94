/* thermal.h - assigns emissivities and temperatures to a scene's surfaces, and
 * computes their exchange. */
#ifndef RT_THERMAL_H
#define RT_THERMAL_H

#include "rt/heat/exchange.h"
#include "rt/heat/surfaces.h"
#include "rt/scene/named_values.h"

/* Temperatures are in kelvins, or the word "adiabatic". */
extern const struct value_kind emissivity_kind, temperature_kind;
/* The name whose temperature may be given in addition to parts and materials. */
extern const char thermal_environment[];

struct thermal {
    size_t count;        /* surfaces with a visible part */
    size_t *surface;     /* the index of each of them */
    double *emissivity;  /* 1 where none is given */
    double *temperature; /* NaN: adiabatic */
    double outside;      /* temperature of the environment; 0 unless given */
    struct exchange exchange;
};

/* Returns false for a surface without a temperature, or with parts of different
 * temperatures; for one that only receives; for an exchange without a solution;
 * after a trap; or if out of memory. The error names the surface. */
bool thermal_find(const struct surfaces *surfaces, const struct named_parts *parts,
                  const struct named_values *emissivities,
                  const struct named_values *temperatures, enum trace_mode mode,
                  const c205_model *model, struct thermal *thermal, c205_error *error);
void thermal_free(struct thermal *thermal);

#endif
