/* adapter.h - where the adapters of other libraries are: shared objects that are
 * opened only when they are used.
 */
#ifndef RT_ADAPTER_H
#define RT_ADAPTER_H

#include <stdbool.h>

#include "vm/c205.h"

enum { ADAPTER_PATH = 4096 + 64 };

/* In the folder that the environment's RT205_LIBDIR names, beside the program, or where it
 * is installed; false: nowhere, the error says where it was looked for. */
bool adapter_find(const char *file, char path[ADAPTER_PATH],
                  c205_error *error);

#endif
