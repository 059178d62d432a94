/* emitting_shapes.h - random shapes that have an emission (rt/heat/emission.h). */
#ifndef EMITTING_SHAPES_H
#define EMITTING_SHAPES_H

#include "rt/scene/transform.h"
#include "rt/shapes/primitive.h"

#include <stdint.h>

enum { EMITTING_KINDS = 9 };
extern const enum primitive_kind emitting_kinds[EMITTING_KINDS];

/* Draws a finished primitive of a size near 1. Most are turned, stretched, mirrored and
 * moved. The triangles of a mesh are valid until the next mesh is drawn. */
struct primitive draw_emitting(enum primitive_kind kind, uint64_t *random);
/* Moves a shape to a placement. */
void move_shape(struct primitive *primitive, const struct placement *placement);

#endif
