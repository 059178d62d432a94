/* source.h - the texts of a scene: files, or what the program carries. */
#ifndef RT_SCENE_SOURCE_H
#define RT_SCENE_SOURCE_H

#include "vm/c205.h"
#include "vm/text.h"

#include <stdbool.h>
#include <stddef.h>

/* The .inc files of rt/scene, for #include without such a file. */
extern const struct text scene_texts[];

/* A text stays where it is as long as its list lives: tokens point into it. */
struct scene_source {
    struct scene_source *next;
    char *name;
    char *text; /* ends with a NUL that is not part of it */
    size_t length;
    bool library; /* not of the scene's own folders */
    bool is_text; /* or the bytes of an image or a font */
};

enum { SOURCE_LONGEST = 16 << 20 }; /* bytes */

/* Add a text, or a file of one.  NULL: the error has the reason. */
struct scene_source *source_add(struct scene_source **list, const char *name,
                                const char *text, size_t length, c205_error *error);
struct scene_source *source_load(struct scene_source **list, const char *path,
                                 c205_error *error);

/* A file that a text names. */
struct source_request {
    const char *name;
    const struct scene_source *from;
    const char *const *search; /* folders; ends with NULL, or is NULL */
    bool is_text;
};
/* It is searched in the folder of `from`, in the search folders, among those of
 * POV-Ray's package, in scene_texts; and then once more in this order without
 * regard to the case of letters, where a folder must have it once.  Each file is
 * read once.  NULL: the error has the reason. */
struct scene_source *source_include(struct scene_source **list,
                                    const struct source_request *request,
                                    c205_error *error);
/* A file was found by a name of other case. */
bool source_is_other(const struct scene_source *source, const char *name);
void sources_free(struct scene_source *list);

#endif
