/* plain_mass.h - volume and centroid of a scene's bodies from points, in plain C
 * doubles: a point is inside of them or not (plain_regions.h). */
#ifndef PLAIN_MASS_H
#define PLAIN_MASS_H

#include "tests/oracle/plain_regions.h"

/* The volume and the three first moments, about the middle of the box. */
enum { PLAIN_MASS_FIGURES = 4 };

/* By points of a box, random each in its cell; errors are standard ones. */
void plain_mass(const struct scene *scene, const double middle[3],
                const double width[3], uint64_t *state,
                double value[PLAIN_MASS_FIGURES], double error[PLAIN_MASS_FIGURES]);

#endif
