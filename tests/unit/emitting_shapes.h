/* emitting_shapes.h - random shapes that have an emission (rt/heat/emission.h). */
#ifndef EMITTING_SHAPES_H
#define EMITTING_SHAPES_H

#include "rt/scene/transform.h"
#include "rt/shapes/primitive.h"

#include <stdint.h>

enum { EMITTING_KINDS = 9 };
extern const enum primitive_kind emitting_kinds[EMITTING_KINDS];

/* Settled, about as large as 1, mostly turned, stretched, mirrored and moved.  The
 * triangles of a mesh hold until the next one is drawn. */
struct primitive draw_emitting(enum primitive_kind kind, uint64_t *random);
/* To that place. */
void move_shape(struct primitive *primitive, const struct placement *placement);

#endif
