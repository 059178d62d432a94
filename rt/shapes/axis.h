/* axis.h - computes orthonormal frames for shapes that have an axis. */
#ifndef RT_AXIS_H
#define RT_AXIS_H

#include <stdbool.h>

#define AXIS_IS_POINT "both ends of the axis are the same"

/* Writes 12 words: the midpoint of the axis, and an orthonormal frame u, v, w with w
 * along the axis. Returns the length of the axis. */
double axis_words(const double base[3], const double cap[3], double *words);
bool axis_is_point(const double base[3], const double cap[3]);
/* Normalises a vector. Returns an error message, or NULL. */
const char *axis_make_normal(double normal[3]);

#endif
