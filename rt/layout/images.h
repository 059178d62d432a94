/* images.h - writes the images of pigments into memory, for light/image.s. */
#ifndef RT_LAYOUT_IMAGES_H
#define RT_LAYOUT_IMAGES_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Returns true if a pigment of the scene needs the kernel light/image.s. */
bool scene_has_images(const struct scene *scene);
/* Lays out the images in use. Returns the address of each image's pixels by its
 * number, with 0 for unused images, or NULL if out of memory. The caller frees the
 * array. */
uint64_t *images_layout(struct record_layout *layout, const struct scene *scene);
/* Return the routine that maps a point to a place in the image, the routine that
 * maps the place to a colour, and their MAP_NUMBERS parameters. */
const char *image_routine(const struct image_map *map);
const char *image_sampler(const struct image_map *map);
void image_numbers(const struct image_map *map, double numbers[]);

#endif
