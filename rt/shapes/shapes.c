/* shapes.c - the table of descriptors and kernels of shapes, and its queries. */
#include "rt/shapes/shape.h"

const struct shape *const shapes[PRIMITIVE_KINDS] = {
#define SHAPE(KIND, name, ...) &shape_##name,
#include "rt/shapes/shapes.def"
};

const char *primitive_kind_name(enum primitive_kind kind)
{
    static const char *const names[PRIMITIVE_KINDS] = {
#define SHAPE(KIND, name, ...) #name,
#include "rt/shapes/shapes.def"
    };
    return names[kind];
}

const struct shape *shape_of(const struct primitive *primitive)
{
    return shapes[primitive->kind];
}

const struct shape_kernels *shape_kernels_of(const struct primitive *primitive)
{
    const struct shape *shape = shape_of(primitive);
    return shape->is_other && shape->is_other(primitive) ? &shape->other
                                                         : &shape->kernels;
}

bool shape_is_surface(const struct primitive *primitive)
{
    const struct shape *shape = shape_of(primitive);
    return (shape->segments ? shape->segments(primitive) : shape->kernels.segments)
           == 0;
}

const char *shape_empty(struct primitive *primitive, const char *reason)
{
    primitive->empty = true;
    return reason;
}

/* ---- Kernels ------------------------------------------------------------- */

#define INCLUDE(file) "        .include \"shapes/" file "\"\n",

static const char *const kernels[] = {
#define SHAPE(KIND, name, ...) INCLUDE(#name ".s")
#include "rt/shapes/shapes.def"
    NULL
};

static const char *const normals[] = {
#define SHAPE(KIND, name, ...) INCLUDE("normal_" #name ".s")
#include "rt/shapes/shapes.def"
    NULL
};

const struct text shape_texts[] = {
    { "shapes/every.s", kernels },
    { "shapes/every_normal.s", normals },
    { NULL, NULL },
};
