/* plain_tracer.h - a scene traced a second time, in plain C doubles.
 *
 * Written from the geometry of the shapes and from POV-Ray's rules of
 * shading; it shares nothing with the kernels but struct scene.  One ray
 * through the centre of each pixel and all that comes of it, every region
 * tried, no tricks.
 *
 * The frame's channels: colour in linear light; depth, the distance along the
 * ray; the unit normal that faces the viewer; the number of the primitive,
 * from 1.  Where nothing is hit: the background, and 0 in all the others.
 */
#ifndef PLAIN_TRACER_H
#define PLAIN_TRACER_H

#include "rt/picture/picture.h"
#include "rt/shapes/primitive.h"

/* False when memory is short; the caller frees the frame. */
bool plain_trace(const struct scene *scene, size_t width, size_t height,
                 struct frame *frame);

#endif
