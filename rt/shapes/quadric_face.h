/* quadric_face.h - compares curved faces as quadrics in world space. The functions
 * require shapes whose descriptors have a quadric. */
#ifndef RT_QUADRIC_FACE_H
#define RT_QUADRIC_FACE_H

#include "rt/shapes/primitive.h"

/* Returns a sort key of the quadric. Nearly equal quadrics have nearly equal keys. */
double quadric_face_key(const struct primitive *primitive);
/* Compares two faces within the distance `reach` from a point. Returns 1 if they are
 * equal within COINCIDENT, -1 if they are equal but the inside of one face is the
 * outside of the other, and 0 if they differ. */
int quadric_face_compare(const struct primitive *a, const struct primitive *b,
                         const double at[3], double reach);

/* ---- For the descriptors of shapes --------------------------------------- */

/* These functions add the matrix of a quadric in world space. The arguments are in the
 * primitive's own space.
 *
 *   |X - base|^2 - along ((X - base) . axis)^2 - 2 rise (X - base) . axis - square
 *
 * The axis has length 1. */
void quadric_about_axis(const struct primitive *primitive, const double base[3],
                        const double axis[3], double along, double rise, double square,
                        double (*matrix)[4]);
void quadric_of_cone(const struct primitive *primitive, const double base[3],
                     double base_radius, const double cap[3], double cap_radius,
                     double (*matrix)[4]);
void quadric_of_terms(const struct primitive *primitive,
                      const double terms[QUADRIC_TERMS], double (*matrix)[4]);

#endif
