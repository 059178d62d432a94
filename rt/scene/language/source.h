/* source.h - the texts of a scene: files, or what the program carries. */
#ifndef RT_SCENE_SOURCE_H
#define RT_SCENE_SOURCE_H

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
};

enum { SOURCE_LONGEST = 16 << 20 }; /* bytes */

/* Add a text, a file, or one of scene_texts.  NULL with errno when it cannot
 * be had; EFBIG when it is too long. */
struct scene_source *source_add(struct scene_source **list, const char *name,
                                const char *text, size_t length);
struct scene_source *source_load(struct scene_source **list,
                                 const char *path);
/* The file that an #include of `from` names: in its folder, in the search
 * folders, among those of POV-Ray's package, in scene_texts; each text is read
 * once. */
struct scene_source *source_include(struct scene_source **list,
                                    const char *name,
                                    const struct scene_source *from,
                                    const char *const *search);
void sources_free(struct scene_source *list);

#endif
