/* densities.h - how dense the parts of a scene are. */
#ifndef RT_DENSITIES_H
#define RT_DENSITIES_H

#include "rt/scene/named_values.h"

extern const struct value_kind density_kind;

/* Of each part; of one that is left out it may be NaN.  False: some others have none, or
 * are of several materials; the error names them. */
bool densities_find(const struct named_values *given, const struct named_parts *parts,
                    double *densities, c205_error *error);

#endif
