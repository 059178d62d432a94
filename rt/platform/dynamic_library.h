/* dynamic_library.h - other libraries: shared objects that are opened only when they are
 * used, and stay open.
 *
 * The only file of rt that opens them.  A library is called directly, by its
 * name on the system, or through an adapter, an object of ours with a table of
 * functions.
 */
#ifndef RT_HOST_DYNAMIC_LIBRARY_H
#define RT_HOST_DYNAMIC_LIBRARY_H

#include <stdbool.h>

#include "vm/c205.h"

enum { ADAPTER_PATH = 4096 + 64 };

/* In the folder that the environment's RT205_LIBDIR names, beside the program, or where it
 * is installed; false: nowhere, the error says where it was looked for. */
bool dynamic_find(const char *file, char path[ADAPTER_PATH], c205_error *error);

/* The table that the object at the path has by that name.  shared: the names of
 * the object are for all others, too.  NULL: the error says why. */
const void *dynamic_open(const char *path, const char *table, bool shared,
                         c205_error *error);

/* NULL: there is no library of that name. */
void *dynamic_library(const char *name);
/* Put a function of it where call points to.  False: it has none of that name. */
bool dynamic_call(void *library, const char *name, void *call);

#endif
