/* folder.h - what lies in a folder. */
#ifndef BASE_FOLDER_H
#define BASE_FOLDER_H

#include "vm/c205.h"

/* Whether a path names one. */
bool folder_is(const char *path);

/* The names in it, sorted, without those that begin with a point. */
struct folder {
    size_t count;
    char **names;
};
/* False: it cannot be read, and the error says why without naming it; to be freed in either
 * case. */
bool folder_read(struct folder *folder, const char *path, c205_error *error);
/* A copy of a name, at the end.  False: no memory. */
bool folder_add(struct folder *folder, const char *name);
void folder_free(struct folder *folder);

#endif
