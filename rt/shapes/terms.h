/* terms.h - checks and scales the surfaces that are defined by the coefficients of a
 * polynomial. */
#ifndef RT_TERMS_H
#define RT_TERMS_H

#include "rt/shapes/primitive.h"

/* Checks that at least one coefficient is not 0, apart from the last, which is the
 * constant term. Returns the same as `finish` in shape.h. */
const char *terms_finish(struct primitive *primitive, const double *coefficients,
                         size_t count);
/* Enlarges the space of a quartic by 2^log. The surface in world space does not
 * change. */
void quartic_enlarge(struct primitive *quartic, int log);

#endif
