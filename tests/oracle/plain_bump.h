/* plain_bump.h - the plain tracer's changed normals, by POV-Ray's rules. */
#ifndef PLAIN_BUMP_H
#define PLAIN_BUMP_H

#include "rt/scene/scene.h"

/* A normal of length one at a point, as the bumps change it; the scene's unit of
 * length. */
void plain_bumps(const struct bumps *bumps, double unit, const double point[3],
                 double normal[3]);

#endif
