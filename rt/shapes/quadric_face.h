/* quadric_face.h - compares the faces of spheres, cylinders, cones and quadrics, as
 * quadrics of the world. */
#ifndef RT_QUADRIC_FACE_H
#define RT_QUADRIC_FACE_H

#include "rt/shapes/primitive.h"

bool quadric_face_is_there(const struct primitive *primitive);
/* Returns a key; faces that are nearly the same have nearly the same key. */
double quadric_face_key(const struct primitive *primitive);
/* Compares two faces within reach of a point. Returns 1: they are the same within
 * COINCIDENT, 0: they differ, -1: they are the same, and the inside of one is the
 * outside of the other. */
int quadric_face_compare(const struct primitive *a, const struct primitive *b,
                         const double at[3], double reach);

#endif
