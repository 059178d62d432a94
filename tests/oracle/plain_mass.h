/* plain_mass.h - volume and centroid of a scene's solids by sampling points, in plain C
 * doubles.  plain_regions.h decides whether a point is inside. */
#ifndef PLAIN_MASS_H
#define PLAIN_MASS_H

#include "tests/oracle/plain_regions.h"

/* The volume and the three first moments about the centre of the box. */
enum { PLAIN_MASS_FIGURES = 4 };

/* Samples the box with one random point in each cell; error is the standard error. */
void plain_mass(const struct scene *scene, const double middle[3],
                const double width[3], uint64_t *state,
                double value[PLAIN_MASS_FIGURES], double error[PLAIN_MASS_FIGURES]);

#endif
