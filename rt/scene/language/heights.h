/* heights.h - height data of an image or a function. */
#ifndef RT_SCENE_HEIGHTS_H
#define RT_SCENE_HEIGHTS_H

#include "rt/scene/language/reader.h"

#define HEIGHT_ONE 65536. /* height 1; the greatest height is one less */

/* A grid of at least 2 x 2 heights. Rows are along z, columns along x. */
struct heights {
    size_t columns, rows;
    uint16_t *list; /* allocated by malloc; the lowest row first */
};

/* Reads the heights of an image, whose name may follow a word for its kind, or of a
 * function after the word `function`. The caller frees the list, even after an
 * error. */
bool heights_read(struct reader *reader, struct heights *heights);
double height_at(const struct heights *heights, size_t x, size_t z);

#endif
