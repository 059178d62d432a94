/* image_file.h - image files that a scene names. */
#ifndef RT_SCENE_IMAGE_FILE_H
#define RT_SCENE_IMAGE_FILE_H

#include "rt/scene/language/reader.h"

struct image_file {
    struct scene_token at; /* its name */
    const struct scene_source *source;
    enum raster_kind kind;
};

/* Returns the word at the current token if it is an image kind of POV-Ray that is not
 * supported, else NULL. */
const char *image_kind_unsupported(const struct reader *reader);
/* Reads the word of the kind, which is optional but must match the file, and the name.
 * `expected` describes them in messages. */
bool image_file_read(struct reader *reader, const char *expected,
                     struct image_file *file);
/* Decodes the pixels of a file; `bytes` are those of the file, or a modified copy. The
 * caller frees the samples. */
bool image_file_pixels(struct reader *reader, const struct image_file *file,
                       const char *bytes, struct raster *raster);

#endif
