#include "rt/adapter/adapter.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/error.h"

/* Where they are installed, seen from the program's folder. */
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

static bool is_in(const char *folder, const char *file,
                  char path[ADAPTER_PATH])
{
    snprintf(path, ADAPTER_PATH, "%.4096s/%.60s", folder, file);
    return access(path, R_OK) == 0;
}

bool adapter_find(const char *file, char path[ADAPTER_PATH],
                  c205_error *error)
{
    const char *named = getenv("RT205_LIBDIR");
    char beside[4096], installed[sizeof beside + sizeof FROM_BIN];

    if (!program_folder(beside, sizeof beside))
        strcpy(beside, ".");
    snprintf(installed, sizeof installed, "%s%s", beside, FROM_BIN);
    return (named && is_in(named, file, path)) || is_in(beside, file, path)
           || is_in(installed, file, path)
           || error_say(error, "no %s in %.80s or %.80s", file, beside,
                        installed);
}
