/* plain_camera.h - camera rays of the plain tracer. */
#ifndef PLAIN_CAMERA_H
#define PLAIN_CAMERA_H

#include "tests/oracle/plain_shapes.h"

/* Returns the number of rays per pixel in each direction: 1 for a camera without a
 * lens. */
size_t plain_samples(const struct camera *camera);

/* Returns the ray of sample x, y in a picture of width x height samples. */
struct ray plain_camera_ray(const struct camera *camera, size_t width, size_t height,
                            size_t x, size_t y);

#endif
