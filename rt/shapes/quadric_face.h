/* quadric_face.h - compares the faces of spheres, cylinders, cones and quadrics, as
 * quadrics in world space. */
#ifndef RT_QUADRIC_FACE_H
#define RT_QUADRIC_FACE_H

#include "rt/shapes/primitive.h"

bool quadric_face_is_there(const struct primitive *primitive);
/* Returns a sort key of the quadric. Nearly equal quadrics have nearly equal keys. */
double quadric_face_key(const struct primitive *primitive);
/* Compares two faces within the distance `reach` from a point. Returns 1 if they are
 * equal within COINCIDENT, -1 if they are equal but the inside of one face is the
 * outside of the other, and 0 if they differ. */
int quadric_face_compare(const struct primitive *a, const struct primitive *b,
                         const double at[3], double reach);

#endif
