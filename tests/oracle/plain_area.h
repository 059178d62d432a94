/* plain_area.h - computes the areas of primitives and the centroids of their surfaces
 * from parameter grids. It shares no code with the kernels. */
#ifndef PLAIN_AREA_H
#define PLAIN_AREA_H

#include "rt/shapes/primitive.h"

struct plain_area {
    double area;      /* in world space */
    double middle[3]; /* centroid of the surface, in world space */
};

/* Computes the area of an emitter with a relative error of about 1e-6. */
struct plain_area plain_area(const struct primitive *primitive);

#endif
