/* plain_tracer.h - a second tracer, in plain C doubles.
 *
 * Written from the geometry of the shapes and from POV-Ray's shading rules; it shares
 * only struct scene with the kernels.  It traces one ray through the centre of each
 * pixel and all its secondary rays, tests every region, and has no acceleration.
 *
 * Channels of the frame: colour in linear light; depth, the distance along the ray; the
 * unit normal that faces the viewer; the number of the primitive, from 1.  Pixels
 * without a hit have the background, and 0 in all other channels.
 */
#ifndef PLAIN_TRACER_H
#define PLAIN_TRACER_H

#include "rt/picture/picture.h"
#include "rt/shapes/primitive.h"

/* Returns false if memory is short; the caller frees the frame. */
bool plain_trace(const struct scene *scene, size_t width, size_t height,
                 struct frame *frame);

#endif
