/* other_shapes.c - shapes of the language that are not supported. */
#include "rt/scene/language/scene_statement.h"

const struct keyword unsupported_shapes[] = {
    { "isosurface", item_unsupported, 0 },
    { "julia_fractal", item_unsupported, 0 },
    { "lemon", item_unsupported, 0 },
    { "ovus", item_unsupported, 0 },
    { "parametric", item_unsupported, 0 },
    { "polynomial", item_unsupported, 0 },
    { "sor", item_unsupported, 0 },
    { "sphere_sweep", item_unsupported, 0 },
    { "superellipsoid", item_unsupported, 0 },
    { NULL, NULL, 0 },
};
