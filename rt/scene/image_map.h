/* image_map.h - images as colours of a pigment. */
#ifndef RT_SCENE_IMAGE_MAP_H
#define RT_SCENE_IMAGE_MAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The pixels of an image in the colours of the scene. */
struct image_table {
    size_t number;        /* index among the images of the scene, from 0 */
    size_t width, height; /* pixels */
    uint32_t most;
    const uint16_t *samples; /* red, green and blue of each pixel, 0 to most; rows from
                              * the top, pixels from the left */
    const double *light;     /* linear value of each sample 0 .. most */
};
/* Limits of a scene: images, and pixels in all of them. */
enum { MAX_IMAGES = 1000, MAX_IMAGE_PIXELS = 1 << 23 };

/* How a point is mapped to a position in the image; the formulas are in
 * rt/kernels/light/image.s. */
enum image_mapping {
    IMAGE_PLANAR,
    IMAGE_SPHERICAL,
    IMAGE_CYLINDRICAL,
    IMAGE_TORUS,
    IMAGE_MAPPINGS
};
/* How the colour at a position is interpolated: the colour of the nearest pixel, or a
 * weighted mean of the four pixels whose centres are around it. IMAGE_BILINEAR weighs
 * them by the distances along both edges, IMAGE_BY_DISTANCE by the squares of their
 * distances. */
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
    bool once; /* not repeated; neighbours beyond an edge are the pixels of that edge */
};
/* Returns true if a point can be mapped outside the image, where the pigment is
 * clear. */
bool image_is_bounded(const struct image_map *map);

#endif
