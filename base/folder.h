/* folder.h - lists the names in a folder. */
#ifndef BASE_FOLDER_H
#define BASE_FOLDER_H

#include "vm/c205.h"

/* Returns true if a path names a folder. */
bool folder_is(const char *path);

/* The names in a folder, sorted. Names that begin with a point are omitted. */
struct folder {
    size_t count;
    char **names;
};
/* Reads a folder. Returns false on failure; the error has the reason without the name
 * of the folder. The caller must free the struct in both cases. */
bool folder_read(struct folder *folder, const char *path, c205_error *error);
/* Appends a copy of a name. Returns false if the host is out of memory. */
bool folder_add(struct folder *folder, const char *name);
void folder_free(struct folder *folder);

#endif
