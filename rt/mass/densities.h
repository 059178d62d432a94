/* densities.h - assigns a density to each part of a scene. */
#ifndef RT_DENSITIES_H
#define RT_DENSITIES_H

#include "rt/scene/named_values.h"

extern const struct value_kind density_kind;

/* Sets the density of each part, or NaN for a part that is not selected and has no
 * density. Returns false if a selected part has no density or has several materials.
 * The error names these parts. */
bool densities_find(const struct named_values *given, const struct named_parts *parts,
                    double *densities, c205_error *error);

#endif
