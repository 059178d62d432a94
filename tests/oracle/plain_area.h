/* plain_area.h - the areas of primitives and the middles of their surfaces, from grids
 * laid over them; nothing is shared with the kernels. */
#ifndef PLAIN_AREA_H
#define PLAIN_AREA_H

#include "rt/shapes/primitive.h"

struct plain_area {
    double area;      /* in the world */
    double middle[3]; /* the mean of its points, there */
};

/* Of kinds that have emission; relative errors of about 1e-6. */
struct plain_area plain_area(const struct primitive *primitive);

#endif
