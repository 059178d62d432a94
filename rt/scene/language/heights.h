/* heights.h - reads the heights of a height field, from an image or a function. */
#ifndef RT_SCENE_HEIGHTS_H
#define RT_SCENE_HEIGHTS_H

#include "rt/scene/language/reader.h"

#define HEIGHT_ONE 65536. /* the height of 1; the greatest height is HEIGHT_ONE - 1 */

/* A grid of at least 2 x 2 heights. Rows are along z, columns along x. */
struct heights {
    size_t columns, rows;
    uint16_t *list; /* allocated by malloc; starts with the lowest row */
};

/* Reads the heights of an image or a function. A keyword for the kind of an image may
 * precede the name of the image. The keyword `function` precedes a function. The caller
 * frees heights->list, even after an error. */
bool heights_read(struct reader *reader, struct heights *heights);
double height_at(const struct heights *heights, size_t x, size_t z);

#endif
