/* dynamic_library.c - opens shared libraries when they are first used. */
#include "rt/platform/dynamic_library.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "vm/error.h"

/* The installation folder, relative to the folder of the program. */
#define FROM_BIN "/../lib/rt205"

static bool program_folder(char *folder, size_t size)
{
    ssize_t length = readlink("/proc/self/exe", folder, size - 1);
    char *slash;
    if (length <= 0)
        return false;
    folder[length] = '\0';
    slash = strrchr(folder, '/');
    if (slash)
        *slash = '\0';
    return slash != NULL;
}

static bool is_in(const char *folder, const char *file, char path[ADAPTER_PATH])
{
    snprintf(path, ADAPTER_PATH, "%.4096s/%.60s", folder, file);
    return access(path, R_OK) == 0;
}

bool dynamic_find(const char *file, char path[ADAPTER_PATH], c205_error *error)
{
    const char *named = getenv("RT205_LIBDIR");
    char beside[4096], installed[sizeof beside + sizeof FROM_BIN];
    if (!program_folder(beside, sizeof beside))
        strcpy(beside, ".");
    snprintf(installed, sizeof installed, "%s%s", beside, FROM_BIN);
    return (named && is_in(named, file, path)) || is_in(beside, file, path)
           || is_in(installed, file, path)
           || error_set(error,
                        "no %s in %.80s or %.80s: set RT205_LIBDIR to its folder", file,
                        beside, installed);
}

const void *dynamic_open(const char *path, const char *table, bool shared,
                         c205_error *error)
{
    /* Lazy binding saves a third of the load time of a large library, because it does
     * not resolve functions that are never called. */
    void *object = dlopen(path, RTLD_LAZY | (shared ? RTLD_GLOBAL : RTLD_LOCAL));
    const void *found = object ? dlsym(object, table) : NULL;

    if (!found)
        error_set(error, "%s", dlerror());
    if (object && !found)
        dlclose(object);
    return found;
}

void *dynamic_library(const char *name)
{
    return dlopen(name, RTLD_LAZY | RTLD_LOCAL);
}

/* C99 does not convert between object and function pointers, but POSIX permits it. */
bool dynamic_call(void *library, const char *name, void *call)
{
    void *found = dlsym(library, name);
    memcpy(call, &found, sizeof found);
    return found != NULL;
}
