/* images.h - writes the images of pigments into memory, for light/image.s. */
#ifndef RT_LAYOUT_IMAGES_H
#define RT_LAYOUT_IMAGES_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Returns true if a pigment of the scene needs the kernel light/image.s. */
bool scene_has_images(const struct scene *scene);
/* Writes the used images. Returns an array with the address of each image's pixels, or
 * 0 for unused images. Returns NULL if out of memory. The caller frees the array. */
uint64_t *images_layout(struct record_layout *layout, const struct scene *scene);
/* Return three values: the routine that maps a point to a position in the image, the
 * routine that maps the position to a colour, and the MAP_NUMBERS parameters of these
 * routines. */
const char *image_routine(const struct image_map *map);
const char *image_sampler(const struct image_map *map);
void image_numbers(const struct image_map *map, double numbers[]);

#endif
