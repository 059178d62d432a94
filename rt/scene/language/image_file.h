/* image_file.h - finds, reads and decodes the image files that a scene names. */
#ifndef RT_SCENE_IMAGE_FILE_H
#define RT_SCENE_IMAGE_FILE_H

#include "rt/scene/language/reader.h"

struct image_file {
    struct scene_token at; /* token of the file name */
    const struct scene_source *source;
    enum raster_kind kind;
};

/* Returns the keyword at the current token if it is an image kind of POV-Ray that is
 * not supported, else NULL. */
const char *image_kind_unsupported(const struct reader *reader);
/* Reads the keyword of the kind and the name. The keyword is optional, but must match
 * the file. `expected` describes both in messages. */
bool image_file_read(struct reader *reader, const char *expected,
                     struct image_file *file);
/* Decodes the pixels of a file. `bytes` are the bytes of the file, or a modified copy.
 * The caller frees the samples. */
bool image_file_pixels(struct reader *reader, const struct image_file *file,
                       const char *bytes, struct raster *raster);

#endif
