/* tori.h - tori about y: what is common to both. */
#ifndef RT_TORI_H
#define RT_TORI_H

#include "rt/shapes/bound.h"

/* Of the major radius and the tube's half axes, away from y and along it. */
void torus_bound(const struct primitive *primitive, double major, double radial,
                 double axial, struct bound *bound);
size_t torus_words(double major, double radial, double axial, double *words);

#endif
