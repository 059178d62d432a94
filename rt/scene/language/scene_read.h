/* scene_read.h - scenes from files in POV-Ray's language (docs/scenes.md). */
#ifndef RT_SCENE_READ_H
#define RT_SCENE_READ_H

#include "base/diagnostic.h"
#include "rt/scene/raster.h"
#include "rt/shapes/primitive.h"

struct scene_options {
    int width, height;         /* of the picture in pixels: image_width and
                                * image_height; 0: the scene must not use them */
    bool strict;               /* treat every report as an error */
    const char *const *search; /* folders for #include, NULL-terminated; or NULL; the
                                * folder of the file comes first */
    /* Called from time to time during a long reading; false ends the reading with an
     * error. NULL: no call. */
    bool (*go_on)(void *context);
    void *context;
    /* Reads images other than PGM and PPM. NULL: these are errors. */
    raster_reader *read_raster;
    uint64_t
        reading_most; /* limit of bytes to read, loops counted in each iteration; 0:
                            * MAX_READING (reader.h) */
};

/* Reads a scene file. Returns NULL if the file has errors, all of which are in
 * *reports, or cannot be read. The caller frees both. */
struct scene *scene_read(const char *path, const struct scene_options *options,
                         struct diagnostics *reports);
/* Reads a scene from text; `name` is the file name in reports. */
struct scene *scene_read_text(const char *name, const char *text,
                              const struct scene_options *options,
                              struct diagnostics *reports);

#endif
