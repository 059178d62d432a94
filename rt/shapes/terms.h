/* terms.h - surfaces that a polynomial's coefficients tell. */
#ifndef RT_TERMS_H
#define RT_TERMS_H

#include <stddef.h>

/* A surface needs a coefficient besides the last, the constant.  What is wrong
 * with it, or NULL. */
const char *terms_fault(const double *coefficients, size_t count);

#endif
