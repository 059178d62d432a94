/* emitting_shapes.h - random shapes that can emit (rt/heat/emission.h). */
#ifndef EMITTING_SHAPES_H
#define EMITTING_SHAPES_H

#include "rt/scene/transform.h"
#include "rt/shapes/primitive.h"

#include <stdint.h>

enum { EMITTING_KINDS = 9 };
extern const enum primitive_kind emitting_kinds[EMITTING_KINDS];

/* Makes a finished primitive whose size is near 1. Most primitives are rotated,
 * stretched, mirrored and moved. A mesh's triangles are valid until the next. */
struct primitive draw_emitting(enum primitive_kind kind, uint64_t *random);
/* Applies a placement to a shape. */
void move_shape(struct primitive *primitive, const struct placement *placement);

#endif
