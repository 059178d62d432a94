/* scene_read.h - scenes from files in POV-Ray's language (docs/scenes.md). */
#ifndef RT_SCENE_READ_H
#define RT_SCENE_READ_H

#include "base/diagnostic.h"
#include "rt/scene/raster.h"
#include "rt/shapes/primitive.h"

struct scene_options {
    int width, height;         /* of the picture in pixels: image_width and
                                  image_height; 0: these are errors */
    bool strict;               /* every report is an error */
    const char *const *search; /* folders for #include; NULL-terminated, or
                                  NULL; the file's own folder comes first */
    /* Asked now and then in a long reading: false ends it, with an error.  NULL:
     * nobody is asked. */
    bool (*go_on)(void *context);
    void *context;
    /* What reads the images that the scene names, other than PGM and PPM. NULL:
     * these are errors. */
    raster_reader *read_raster;
    uint64_t reading_most; /* bytes, loops counted; 0: as reader.h says */
};

/* Read a scene file.  NULL when it has errors (all are in *reports) or cannot
 * be read.  The caller frees both. */
struct scene *scene_read(const char *path, const struct scene_options *options,
                         struct diagnostics *reports);
/* The same from text; name stands for the file in reports. */
struct scene *scene_read_text(const char *name, const char *text,
                              const struct scene_options *options,
                              struct diagnostics *reports);

#endif
