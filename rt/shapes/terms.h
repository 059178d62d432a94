/* terms.h - surfaces that a polynomial's coefficients tell. */
#ifndef RT_TERMS_H
#define RT_TERMS_H

#include "rt/shapes/primitive.h"

/* A surface needs a coefficient besides the last, the constant.  As a shape's
 * settle. */
const char *terms_finish(struct primitive *primitive, const double *coefficients,
                         size_t count);
/* A quartic in a space that is 2^log times as large: the same surface in the world. */
void quartic_enlarge(struct primitive *quartic, int log);

#endif
