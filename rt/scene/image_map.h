/* image_map.h - images as pigments show them. */
#ifndef RT_SCENE_IMAGE_MAP_H
#define RT_SCENE_IMAGE_MAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The pixels of an image, as the scene's colours. */
struct image_table {
    size_t number;        /* among those of the scene, from 0 */
    size_t width, height; /* pixels */
    uint32_t most;
    const uint16_t *samples; /* red, green and blue of each pixel, the top row
                                first, its left one first: from 0 to most */
    const double *light;     /* what the samples 0 .. most stand for */
};
/* Of a scene: images, and pixels of all of them. */
enum { MAX_IMAGES = 1000, MAX_IMAGE_PIXELS = 1 << 23 };

/* How a point becomes a place of the image: rt/kernels/light/image.s has the
 * formulas. */
enum image_mapping {
    IMAGE_PLANAR,
    IMAGE_SPHERICAL,
    IMAGE_CYLINDRICAL,
    IMAGE_TORUS,
    IMAGE_MAPPINGS
};
/* .. and which colour is there: that of the pixel, or between those of the four
 * whose middles are about the place, by how near they are along both edges, or
 * by the squares of their distances. */
enum image_sampling {
    IMAGE_NEAREST,
    IMAGE_BILINEAR,
    IMAGE_BY_DISTANCE,
    IMAGE_SAMPLINGS
};
struct image_map {
    const struct image_table *table; /* the scene keeps it */
    enum image_mapping mapping;
    enum image_sampling sampling;
    bool once; /* not repeated, but for neighbours of its edges that are the edges
                  themselves */
};
/* A place may be outside of it, where it is clear. */
bool image_is_bounded(const struct image_map *map);

#endif
