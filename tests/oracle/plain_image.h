/* plain_image.h - the plain tracer's images, by POV-Ray's rules. */
#ifndef PLAIN_IMAGE_H
#define PLAIN_IMAGE_H

#include "rt/scene/scene.h"

/* Whether a point of the pigment's space is outside of an image. */
bool plain_image_misses(const struct image_map *map, const double point[3]);
/* .. and the image's colour of any other. */
void plain_image(const struct image_map *map, const double point[3], double color[3]);

#endif
