/* picture_oiio.h - what the OpenImageIO adapter offers to picture.c.
 *
 * The adapter knows files; picture.c knows frames and colours.  Between them
 * go 32-bit samples, the channels of a pixel side by side, the top row first.
 */
#ifndef RT_PICTURE_OIIO_H
#define RT_PICTURE_OIIO_H

#include <stdio.h>

#include "rt/picture/picture.h"
#include "rt/scene/raster.h"

#define PICTURE_ADAPTER_FILE "rt205_oiio.so"
#define PICTURE_ADAPTER_SYMBOL "rt205_picture_adapter"

enum sample_format { SAMPLE_BYTE, SAMPLE_HALF, SAMPLE_FLOAT };

/* An image in memory.  srgb: its first three channels are encoded. */
struct picture_image {
    size_t width, height, channels;
    bool srgb;
    const char *const *names;
    enum sample_format format[FRAME_CHANNELS + 1];
    float *samples;
};

struct picture_adapter {
    /* Begin a picture of the kind that the path's ending says, in a file that
     * is open and stays so: the image is described, its samples are not there
     * yet.  What it gives is for the other two. */
    void *(*begin)(const char *path, const struct picture_image *image,
                   const struct picture_note *notes, FILE *file,
                   struct picture_error *error);
    /* The samples of rows first .. last - 1, each row once and in order. */
    bool (*rows)(void *picture, size_t first, size_t last, const float *samples,
                 struct picture_error *error);
    /* Finish it, if it is whole, and free it in any case. */
    bool (*end)(void *picture, bool whole, struct picture_error *error);

    /* Fill the image: of the file's channels those that image->names asks
     * for, in its order, absent ones 0.  The caller frees image->samples. */
    bool (*read)(const char *path, struct picture_image *image,
                 struct picture_error *error);

    bool (*read_note)(const char *path, const char *name, char *text, size_t size,
                      struct picture_error *error);

    /* An image of whole numbers, from bytes: of 8 or 16 bits, which most
     * tells. */
    raster_reader *read_raster;
};

#endif
