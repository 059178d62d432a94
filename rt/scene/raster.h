/* raster.h - reads image files as arrays of integer samples.
 *
 * PGM and PPM are read here. All other formats are read by a raster_reader of the
 * caller: the adapter to OpenImageIO (rt/picture/picture.h), which is optional.
 */
#ifndef RT_SCENE_RASTER_H
#define RT_SCENE_RASTER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "vm/c205.h"

/* An image. The top row is the first. The channels of a pixel are adjacent: grey or
 * three colours, then an optional opacity. The colours are not premultiplied by the
 * opacity. Samples are from 0 to most. */
struct raster {
    size_t width, height, channels;
    uint32_t most;
    uint16_t *samples; /* allocated by malloc */
};
enum { RASTER_PIXELS = 1 << 23 }; /* largest number of pixels */

/* Reads the bytes of an image file. `format` is the name of the format in OpenImageIO.
 * The caller frees the samples. */
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

/* Returns the kind of a file, from its first bytes. TGA has no signature, so any
 * unknown file counts as TGA. */
enum raster_kind raster_kind_of(const char *bytes, size_t length);
/* Reads an image. `reads` is called for kinds other than PGM and PPM. If `reads` is
 * NULL, these kinds are errors. On failure sets the error and returns false. */
bool raster_read(enum raster_kind kind, const char *bytes, size_t length,
                 raster_reader *reads, struct raster *raster, c205_error *error);

#endif
