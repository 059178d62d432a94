/* plain_camera.h - the rays by which the plain tracer looks at a scene. */
#ifndef PLAIN_CAMERA_H
#define PLAIN_CAMERA_H

#include "tests/oracle/plain_shapes.h"

/* Rays of a pixel, across and down: 1 for a camera without a lens. */
size_t plain_samples(const struct camera *camera);

/* Of a picture of width x height samples. */
struct ray plain_camera_ray(const struct camera *camera, size_t width, size_t height,
                            size_t x, size_t y);

#endif
