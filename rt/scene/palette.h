/* palette.h - image files whose pixels are numbers of colours in a table. */
#ifndef RT_SCENE_PALETTE_H
#define RT_SCENE_PALETTE_H

#include "rt/scene/raster.h"

/* Whether the pixels of a file are numbers of colours in a table. */
bool palette_is_used(enum raster_kind kind, const char *bytes, size_t length);
/* Each colour of the table becomes the grey of its number, so that the pixels
 * show their numbers.  False: the table is broken, or of a kind that is not
 * known here. */
bool palette_to_numbers(enum raster_kind kind, char *bytes, size_t length);

#endif
