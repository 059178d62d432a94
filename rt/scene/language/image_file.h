/* image_file.h - image files that a scene names. */
#ifndef RT_SCENE_IMAGE_FILE_H
#define RT_SCENE_IMAGE_FILE_H

#include "rt/scene/language/reader.h"

struct image_file {
    struct scene_token at; /* its name */
    const struct scene_source *source;
    enum raster_kind kind;
};

/* The word of a kind that POV-Ray has and that is not supported, if it is the
 * next token; else NULL. */
const char *image_kind_unsupported(const struct reader *reader);
/* The word for the kind, which may be left out but must not be a wrong one, and
 * the name; expected: what may be there. */
bool image_file_read(struct reader *reader, const char *expected,
                     struct image_file *file);
/* The pixels that these bytes are, those of the file or as they were changed.
 * The caller frees the samples. */
bool image_file_pixels(struct reader *reader, const struct image_file *file,
                       const char *bytes, struct raster *raster);

#endif
