/* thermal.h - emissivities and temperatures of a scene's surfaces, and what they exchange. */
#ifndef RT_THERMAL_H
#define RT_THERMAL_H

#include "rt/heat/exchange.h"
#include "rt/heat/surfaces.h"
#include "rt/scene/named_values.h"

/* Temperatures in kelvins, or the word adiabatic. */
extern const struct value_kind emissivity_kind, temperature_kind;
/* Whose temperature may be given besides those of parts and materials. */
extern const char thermal_environment[];

struct thermal {
    size_t count;        /* surfaces that something is seen of */
    size_t *surface;     /* of each, its number */
    double *emissivity;  /* .. 1 where none is given */
    double *temperature; /* NaN: it is adiabatic */
    double outside;      /* of the environment; 0 unless it is given */
    struct exchange exchange;
};

/* False: a surface without temperature, or of parts that have several; one that receives
 * alone; an exchange without solution; a trap, no memory.  The error names what it is about. */
bool thermal_find(const struct surfaces *surfaces, const struct named_parts *parts,
                  const struct named_values *emissivities,
                  const struct named_values *temperatures, enum trace_mode mode,
                  const c205_model *model, struct thermal *thermal, c205_error *error);
void thermal_free(struct thermal *thermal);

#endif
