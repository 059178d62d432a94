/* scene_read.h - reads scenes from files in POV-Ray's language (docs/scenes.md). */
#ifndef RT_SCENE_READ_H
#define RT_SCENE_READ_H

#include "base/diagnostic.h"
#include "rt/scene/raster.h"
#include "rt/shapes/primitive.h"

struct scene_options {
    int width, height;         /* size of the picture in pixels, for image_width and
                                * image_height; 0: the scene must not use them */
    bool strict;               /* treat each warning as an error */
    const char *const *search; /* folders for #include, which end with NULL; NULL: none;
                                * the folder of the file is always searched first */
    /* Called at intervals during a long reading. If it returns false, the reading ends
     * with an error. May be NULL. */
    bool (*go_on)(void *context);
    void *context;
    /* Reads images other than PGM and PPM. NULL: such images are errors. */
    raster_reader *read_raster;
    uint64_t
        reading_most; /* limit of bytes to read, which counts each iteration of a loop;
                       * 0: MAX_READING (reader.h) */
};

/* Reads a scene file. If the file has errors or cannot be read, *reports has all
 * errors, and the result is NULL. The caller frees both. */
struct scene *scene_read(const char *path, const struct scene_options *options,
                         struct diagnostics *reports);
/* Reads a scene from text; `name` is the file name in reports. */
struct scene *scene_read_text(const char *name, const char *text,
                              const struct scene_options *options,
                              struct diagnostics *reports);

#endif
