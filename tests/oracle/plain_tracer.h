/* plain_tracer.h - a second tracer, in plain C doubles.
 *
 * It is derived from the geometry of the shapes and from POV-Ray's shading rules, and
 * shares only struct scene with the kernels. It traces one ray through the centre of
 * each pixel, and all secondary rays. It tests every region, without acceleration.
 *
 * The channels of the frame are the colour in linear light, the depth (the distance
 * along the ray), the unit normal that faces the viewer, and the number of the
 * primitive from 1. Pixels without a hit have the colour of the background, and 0 in
 * all other channels.
 */
#ifndef PLAIN_TRACER_H
#define PLAIN_TRACER_H

#include "rt/picture/picture.h"
#include "rt/shapes/primitive.h"

/* Traces a scene. Returns false if out of memory. The caller frees the frame. */
bool plain_trace(const struct scene *scene, size_t width, size_t height,
                 struct frame *frame);

#endif
