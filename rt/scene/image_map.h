/* image_map.h - images as colours of a pigment. */
#ifndef RT_SCENE_IMAGE_MAP_H
#define RT_SCENE_IMAGE_MAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The pixels of an image in the colours of the scene. */
struct image_table {
    size_t number;        /* index among the scene's images */
    size_t width, height; /* size in pixels */
    uint32_t most;
    const uint16_t *samples; /* red, green and blue of each pixel, 0 to most; the rows
                              * start at the top, pixels at the left */
    const double *light;     /* linear value of each sample from 0 to most */
};
/* Limits of a scene: the number of images, and of pixels in all images. */
enum { MAX_IMAGES = 1000, MAX_IMAGE_PIXELS = 1 << 23 };

/* How a point is mapped to a position in the image. The formulas are in
 * rt/kernels/light/image.s. */
enum image_mapping {
    IMAGE_PLANAR,
    IMAGE_SPHERICAL,
    IMAGE_CYLINDRICAL,
    IMAGE_TORUS,
    IMAGE_MAPPINGS
};
/* How the colour at a position is interpolated. IMAGE_NEAREST uses the nearest pixel.
 * The others use a weighted mean of the four pixels whose centres are around the
 * position. IMAGE_BILINEAR computes the weights from the distances along both edges,
 * IMAGE_BY_DISTANCE from the squares of the distances. */
enum image_sampling {
    IMAGE_NEAREST,
    IMAGE_BILINEAR,
    IMAGE_BY_DISTANCE,
    IMAGE_SAMPLINGS
};
struct image_map {
    const struct image_table *table; /* owned by the scene */
    enum image_mapping mapping;
    enum image_sampling sampling;
    bool once; /* not repeated; the neighbours beyond an edge are the pixels at the
                * edge */
};
/* Returns true if a point can be mapped outside the image, where the pigment is
 * transparent. */
bool image_is_bounded(const struct image_map *map);

#endif
