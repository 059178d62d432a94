/* plain_pattern.h - the plain tracer's patterns, by POV-Ray's rules. */
#ifndef PLAIN_PATTERN_H
#define PLAIN_PATTERN_H

#include "rt/scene/scene.h"

/* Where among the stops of the pigment's map a point of the pattern's space is. */
double plain_pattern(const struct pigment *pigment, const double point[3]);

#endif
