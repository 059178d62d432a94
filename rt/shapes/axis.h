/* axis.h - frames of shapes about an axis or across one. */
#ifndef RT_AXIS_H
#define RT_AXIS_H

#include <stdbool.h>

#define AXIS_IS_POINT "both ends of the axis are the same"

/* Writes words: the midpoint of an axis 3, and an orthonormal frame u 3, v 3, w 3 with
 * w along the axis. Returns the length of the axis. */
double axis_words(const double base[3], const double cap[3], double *words);
bool axis_is_point(const double base[3], const double cap[3]);
/* Normalises a normal. Returns an error message, or NULL. */
const char *axis_make_normal(double normal[3]);

#endif
