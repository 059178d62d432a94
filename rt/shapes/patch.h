/* patch.h - quadratic triangular patches with weights.
 *
 * The homogeneous position at s, t, u (s + t + u = 1) is
 *     H = b200 s^2 + b020 t^2 + b002 u^2 + 2 b110 st + 2 b011 tu + 2 b101 su,
 * each b the control point times its weight and the weight itself; the point
 * is H's first three over the fourth.
 */
#ifndef RT_PATCH_H
#define RT_PATCH_H

#include "rt/shapes/primitive.h"

/* Whether it is a surface, and not a curve or a point. */
bool patch_has_area(const struct primitive *patch);

#endif
