/* folder.c - reads the names in a folder. */
#include "base/folder.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/array.h"
#include "vm/error.h"

bool folder_is(const char *path)
{
    struct stat is;
    return stat(path, &is) == 0 && S_ISDIR(is.st_mode);
}

bool folder_add(struct folder *folder, const char *name)
{
    size_t size = strlen(name) + 1;
    char *copy = malloc(size);
    if (!copy || !array_add(&folder->names, &folder->count, &copy, sizeof copy)) {
        free(copy);
        return false;
    }
    memcpy(copy, name, size);
    return true;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

bool folder_read(struct folder *folder, const char *path, c205_error *error)
{
    DIR *open = opendir(path);
    const struct dirent *entry;
    bool good = true;
    int reason;
    *folder = (struct folder){ 0, NULL };
    if (!open)
        return error_set(error, "%s", strerror(errno));
    do {
        errno = 0;
        entry = readdir(open);
        if (entry && *entry->d_name != '.')
            good = folder_add(folder, entry->d_name);
    } while (good && entry);
    reason = errno;
    closedir(open);
    if (!good)
        return error_set(error, "out of memory");
    if (reason)
        return error_set(error, "%s", strerror(reason));
    if (folder->count > 0)
        qsort(folder->names, folder->count, sizeof *folder->names, compare_names);
    return true;
}

void folder_free(struct folder *folder)
{
    for (size_t i = 0; i < folder->count; i++)
        free(folder->names[i]);
    free(folder->names);
}
