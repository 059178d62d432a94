/* images.h - the images of pigments in the machine's memory: light/image.s. */
#ifndef RT_LAYOUT_IMAGES_H
#define RT_LAYOUT_IMAGES_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Whether the kernels need light/image.s for one of its pigments. */
bool scene_has_images(const struct scene *scene);
/* Lay out those that are seen: where the pixels of each are, by its number, or 0.
 * NULL: no memory.  The caller frees it. */
uint64_t *images_layout(struct record_layout *layout, const struct scene *scene);
/* What makes a place of a point, and a colour of that; its numbers, MAP_NUMBERS of
 * them. */
const char *image_routine(const struct image_map *map);
const char *image_sampler(const struct image_map *map);
void image_numbers(const struct image_map *map, double numbers[]);

#endif
