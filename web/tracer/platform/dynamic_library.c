/* dynamic_library.c - dynamic libraries in the page. Only the writer of PNG files
 * exists, which is linked statically.
 */
#include "rt/platform/dynamic_library.h"

#include <string.h>

#include "vm/error.h"
#include "web/tracer/platform/png.h"

bool dynamic_find(const char *file, char path[ADAPTER_PATH], c205_error *error)
{
    strcpy(path, file);
    return strcmp(file, PICTURE_ADAPTER_FILE) == 0
           || error_set(error, "%s is not available in the page", file);
}

const void *dynamic_open(const char *path, const char *table, bool shared,
                         c205_error *error)
{
    (void)path, (void)table, (void)shared, (void)error;
    return &png_adapter;
}

void *dynamic_library(const char *name)
{
    (void)name;
    return NULL;
}

bool dynamic_call(void *library, const char *name, void *call)
{
    (void)library, (void)name, (void)call;
    return false;
}
