/* palette.h - replaces the colours of the colour table in an image file by their
 * indices, so that the indices can be read as heights. */
#ifndef RT_SCENE_PALETTE_H
#define RT_SCENE_PALETTE_H

#include "rt/scene/raster.h"

/* Returns true if the pixels of a file are indices into a colour table. */
bool palette_is_used(enum raster_kind kind, const char *bytes, size_t length);
/* Replaces each colour of the table by the grey value of its index, so that the pixels
 * decode to their indices. Returns false if the table is invalid or of an unsupported
 * kind. */
bool palette_to_numbers(enum raster_kind kind, char *bytes, size_t length);

#endif
