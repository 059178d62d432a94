/* patch.h - tests whether a quadratic triangular patch with weights has an area.
 *
 * The homogeneous position at s, t, u (s + t + u = 1) is
 *
 *     H = b200 s^2 + b020 t^2 + b002 u^2 + 2 b110 st + 2 b011 tu + 2 b101 su
 *
 * Each b has four components: the control point times its weight, and the weight. The
 * point is the first three components of H divided by the fourth.
 */
#ifndef RT_PATCH_H
#define RT_PATCH_H

#include "rt/shapes/primitive.h"

/* Returns true if the patch is a surface, not a curve or a point. */
bool patch_has_area(const struct primitive *patch);

#endif
