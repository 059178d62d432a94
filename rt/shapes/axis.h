/* axis.h - shapes about an axis, cylinders and cones, and across one: planes and
 * discs. */
#ifndef RT_AXIS_H
#define RT_AXIS_H

#include <stdbool.h>

#define AXIS_IS_POINT "both ends of the axis are the same"

/* To words: the middle of an axis 3, and the unit frame u 3, v 3, w 3 about
 * it, w along.  Returns the axis's length. */
double axis_words(const double base[3], const double cap[3], double *words);
bool axis_is_point(const double base[3], const double cap[3]);
/* A normal gets the length one.  Returns what is wrong with it, or NULL. */
const char *axis_make_normal(double normal[3]);

#endif
