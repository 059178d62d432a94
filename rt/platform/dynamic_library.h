/* dynamic_library.h - opens shared libraries when they are first used; they stay
 * open.
 *
 * No other file of rt opens libraries. A library is called directly, by its system
 * name, or through an adapter: an object of this project with a table of
 * functions.
 */
#ifndef RT_HOST_DYNAMIC_LIBRARY_H
#define RT_HOST_DYNAMIC_LIBRARY_H

#include <stdbool.h>

#include "vm/c205.h"

enum { ADAPTER_PATH = 4096 + 64 };

/* Searches the folder in the environment variable RT205_LIBDIR, the folder of the
 * program, and the installation folder. Returns false if none has the file; the
 * error lists the folders. */
bool dynamic_find(const char *file, char path[ADAPTER_PATH], c205_error *error);

/* Returns the table with this name in the object at the path. shared: the names of
 * the object are visible to all other objects. Returns NULL with the reason in the
 * error. */
const void *dynamic_open(const char *path, const char *table, bool shared,
                         c205_error *error);

/* Returns NULL if there is no library of that name. */
void *dynamic_library(const char *name);
/* Stores a function of the library in *call. Returns false if the library has none
 * of that name. */
bool dynamic_call(void *library, const char *name, void *call);

#endif
