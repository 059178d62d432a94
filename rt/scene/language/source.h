/* source.h - the texts of a scene: files, or what the program carries. */
#ifndef RT_SCENE_SOURCE_H
#define RT_SCENE_SOURCE_H

#include "vm/text.h"

#include <stdbool.h>
#include <stddef.h>

/* The .inc files of rt/scene, for #include without such a file. */
extern const struct text scene_texts[];

/* A text stays where it is as long as its list lives: tokens point into it. */
struct source {
    struct source *next;
    char *name;
    char *text; /* ends with a NUL that is not part of it */
    size_t length;
};

enum { SOURCE_LONGEST = 16 << 20 }; /* bytes */

/* Add a text, a file, or one of scene_texts.  NULL with errno when it cannot
 * be had; EFBIG when it is too long. */
struct source *source_add(struct source **list, const char *name,
                          const char *text, size_t length);
struct source *source_load(struct source **list, const char *path);
/* The file that an #include of `from` names: in its folder, in the search
 * folders, in scene_texts; each text is read once. */
struct source *source_include(struct source **list, const char *name,
                              const struct source *from,
                              const char *const *search);
void sources_free(struct source *list);

#endif
