/* tori.h - computes the bounds and the record words of circular and elliptical tori
 * about the y axis. */
#ifndef RT_TORI_H
#define RT_TORI_H

#include "rt/shapes/shape_bound.h"

/* Computes the bound of a torus. radial and axial are the half axes of the tube,
 * perpendicular to y and along y. */
void torus_bound(const struct primitive *primitive, double major, double radial,
                 double axial, struct bound *bound);
size_t torus_words(double major, double radial, double axial, double *words);

#endif
