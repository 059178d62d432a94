/* other_shapes.c - shapes of the language that are not supported. */
#include "rt/scene/language/scene_statement.h"

const struct keyword unsupported_shapes[] = {
    { "isosurface julia_fractal lemon ovus parametric polynomial sor sphere_sweep "
      "superellipsoid",
      item_unsupported, 0 },
    { NULL, NULL, 0 },
};
