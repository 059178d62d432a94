/* folder.h - lists the names in a folder. */
#ifndef BASE_FOLDER_H
#define BASE_FOLDER_H

#include "vm/c205.h"

/* Returns true if a path names a folder. */
bool folder_is(const char *path);

/* The names in a folder, sorted, without those that begin with a point. */
struct folder {
    size_t count;
    char **names;
};
/* Reads a folder. Returns false with the reason, without the name, in the error. The
 * caller must free the folder in both cases. */
bool folder_read(struct folder *folder, const char *path, c205_error *error);
/* Appends a copy of a name. Returns false if memory is exhausted. */
bool folder_add(struct folder *folder, const char *name);
void folder_free(struct folder *folder);

#endif
