/* dynamic_library.h - opens shared libraries when they are first used. They stay open.
 *
 * No other file of rt opens libraries. A library with a system name is called directly.
 * Other libraries are called through an adapter: a shared object of this project that
 * exports a table of functions.
 */
#ifndef RT_HOST_DYNAMIC_LIBRARY_H
#define RT_HOST_DYNAMIC_LIBRARY_H

#include <stdbool.h>

#include "vm/c205.h"

enum { ADAPTER_PATH = 4096 + 64 };

/* Searches for the file in the folder in the environment variable RT205_LIBDIR, in the
 * folder of the program, and in the installation folder. If it is not found, returns
 * false, and the error lists the folders. */
bool dynamic_find(const char *file, char path[ADAPTER_PATH], c205_error *error);

/* Opens the shared object at the path, and returns the table that it exports with this
 * name. If `shared` is true, other objects can use its symbols, too. On failure sets
 * the error and returns NULL. */
const void *dynamic_open(const char *path, const char *table, bool shared,
                         c205_error *error);

/* Opens the library with a system name. Returns NULL if there is no such library. */
void *dynamic_library(const char *name);
/* Stores a function of the library in *call. Returns false if the library has no
 * function with that name. */
bool dynamic_call(void *library, const char *name, void *call);

#endif
