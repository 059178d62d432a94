/* kernels.c - the lists of the shapes' kernels, from shapes.def. */
#include "rt/shapes/kernels.h"

#include <stddef.h>

#define INCLUDE(file) "        .include \"shapes/" file "\"\n",

static const char *const scalar[] = {
#define SHAPE(KIND, name, ...) INCLUDE(#name "_scalar.s")
#include "rt/shapes/shapes.def"
    NULL
};

static const char *const vector[] = {
#define SHAPE(KIND, name, ...) INCLUDE(#name "_vector.s")
#include "rt/shapes/shapes.def"
    NULL
};

static const char *const normal_scalar[] = {
#define SHAPE(KIND, name, ...) INCLUDE("normal_" #name "_scalar.s")
#include "rt/shapes/shapes.def"
    NULL
};

static const char *const normal_vector[] = {
#define SHAPE(KIND, name, ...) INCLUDE("normal_" #name "_vector.s")
#include "rt/shapes/shapes.def"
    NULL
};

const struct text shape_texts[] = {
    { "shapes/every_scalar.s", scalar },
    { "shapes/every_vector.s", vector },
    { "shapes/every_normal_scalar.s", normal_scalar },
    { "shapes/every_normal_vector.s", normal_vector },
    { NULL, NULL },
};
