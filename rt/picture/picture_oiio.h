/* picture_oiio.h - the interface between picture.c and the OpenImageIO adapter.
 *
 * The adapter handles files; picture.c handles frames and colours. They exchange 32-bit
 * samples. The channels are interleaved, and the top row is the first.
 */
#ifndef RT_PICTURE_OIIO_H
#define RT_PICTURE_OIIO_H

#include <stdio.h>

#include "rt/picture/picture.h"
#include "rt/scene/raster.h"

#define PICTURE_ADAPTER_FILE "rt205_oiio.so"
#define PICTURE_ADAPTER_SYMBOL "rt205_picture_adapter"

enum sample_format { SAMPLE_BYTE, SAMPLE_HALF, SAMPLE_FLOAT };

/* An image in memory. srgb: the first three channels are sRGB-encoded. */
struct picture_image {
    size_t width, height, channels;
    bool srgb;
    const char *const *names;
    enum sample_format format[FRAME_CHANNELS + 1];
    float *samples;
};

struct picture_adapter {
    /* Starts a picture, whose kind the path's ending selects. The file is open and
     * stays open. `image` describes the picture, but has no samples. Returns the state
     * for the next two functions. */
    void *(*begin)(const char *path, const struct picture_image *image,
                   const struct picture_note *notes, FILE *file, c205_error *error);
    /* Writes the samples of the rows first .. last - 1. Each row is written once, in
     * order. */
    bool (*rows)(void *picture, size_t first, size_t last, const float *samples,
                 c205_error *error);
    /* Finishes the picture if `whole` is true. Frees the state in all cases. */
    bool (*end)(void *picture, bool whole, c205_error *error);

    /* Reads an image. It has the channels in image->names, in this order. Channels that
     * are not in the file are 0. The caller frees image->samples. */
    bool (*read)(const char *path, struct picture_image *image, c205_error *error);

    bool (*read_note)(const char *path, const char *name, char *text, size_t size,
                      c205_error *error);

    /* Decodes an image with integer samples from the bytes of a file. Stores the
     * largest possible sample, 255 or 65535, in raster.most. */
    raster_reader *read_raster;
};

#endif
