/* terms.h - surfaces that are given by the coefficients of a polynomial. */
#ifndef RT_TERMS_H
#define RT_TERMS_H

#include "rt/shapes/primitive.h"

/* Checks that some coefficient other than the last, the constant, is not 0. The result
 * is that of a shape's settle. */
const char *terms_finish(struct primitive *primitive, const double *coefficients,
                         size_t count);
/* Enlarges the space of a quartic by 2^log; its surface in the world stays the same. */
void quartic_enlarge(struct primitive *quartic, int log);

#endif
