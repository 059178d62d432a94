/* raster.h - image files as rows of whole numbers.
 *
 * PGM and PPM are read here.  All others are read by whoever gives a
 * raster_reader: the adapter to OpenImageIO (rt/picture/picture.h), which need not
 * be there.
 */
#ifndef RT_SCENE_RASTER_H
#define RT_SCENE_RASTER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "vm/c205.h"

/* The top row first, the channels of a pixel side by side: grey or three
 * colours, and perhaps one that says how opaque the pixel is, which has left no
 * trace in the others.  Samples go from 0 to most. */
struct raster {
    size_t width, height, channels;
    uint32_t most;
    uint16_t *samples; /* of malloc */
};
enum { RASTER_PIXELS = 1 << 23 }; /* at most */

/* A file's bytes, of a format that OpenImageIO has by this name.  The caller
 * frees the samples. */
typedef bool raster_reader(const char *format, const char *bytes, size_t length,
                           struct raster *raster, c205_error *error);

enum raster_kind {
    RASTER_BMP,
    RASTER_GIF,
    RASTER_JPEG,
    RASTER_PGM,
    RASTER_PNG,
    RASTER_PPM,
    RASTER_TGA,
    RASTER_TIFF,
    RASTER_KINDS
};

/* By its first bytes; TGA has none of its own, and is what is no other one. */
enum raster_kind raster_kind_of(const char *bytes, size_t length);
/* reads: for what is not PGM or PPM; NULL: there is nobody. */
bool raster_read(enum raster_kind kind, const char *bytes, size_t length,
                 raster_reader *reads, struct raster *raster, c205_error *error);

#endif
