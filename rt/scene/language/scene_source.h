/* scene_source.h - the texts of a scene: files, and texts built into the program. */
#ifndef RT_SCENE_SOURCE_H
#define RT_SCENE_SOURCE_H

#include "vm/c205.h"
#include "vm/text.h"

#include <stdbool.h>
#include <stddef.h>

/* The .inc files of rt/scene/library, for an #include of a file that is not
 * installed. */
extern const struct text scene_texts[];

/* A source lives as long as its list, because tokens point into it. */
struct scene_source {
    struct scene_source *next;
    char *name;
    char *text; /* ends with a NUL, which `length` does not count */
    size_t length;
    bool library; /* it is not in the folders of the scene */
    bool is_text; /* false: bytes of an image or a font */
};

enum { SOURCE_LONGEST = 16 << 20 }; /* in bytes */

/* source_add adds a text to the list, source_load the text of a file. Both return NULL
 * after an error. */
struct scene_source *source_add(struct scene_source **list, const char *name,
                                const char *text, size_t length, c205_error *error);
struct scene_source *source_load(struct scene_source **list, const char *path,
                                 c205_error *error);

/* A request for a file that a scene names. */
struct source_request {
    const char *name;
    const struct scene_source *from;
    const char *const *search; /* folders, which end with NULL; NULL: none */
    bool is_text;
};
/* Finds a file. The search order is: the folder of `from`, the search folders, the
 * folders of POV-Ray's package, scene_texts. If the file is not found, the search is
 * repeated in the same order without regard to case. A folder must then have only one
 * match. Each file is read once. Returns NULL after an error. */
struct scene_source *source_include(struct scene_source **list,
                                    const struct source_request *request,
                                    c205_error *error);
/* Returns true if the file was found under a name that differs from `name` in case. */
bool source_is_other(const struct scene_source *source, const char *name);
void sources_free(struct scene_source *list);

#endif
