/* heights.h - rows of heights, from an image or a function. */
#ifndef RT_SCENE_HEIGHTS_H
#define RT_SCENE_HEIGHTS_H

#include "rt/scene/language/reader.h"

#define HEIGHT_ONE 65536. /* the height 1; the greatest is one less */

/* Rows go with z, columns with x: two of both at least. */
struct heights {
    size_t columns, rows;
    uint16_t *list; /* of malloc; the lowest row first */
};

/* Of an image, perhaps with a word for its kind before its name, or behind the
 * word `function`.  The caller frees the list, also after an error. */
bool heights_read(struct reader *reader, struct heights *heights);
double height_at(const struct heights *heights, size_t x, size_t z);

#endif
