/* file.c - reads whole files, and compares paths by device and inode. */
#include "base/file.h"

#include "base/outputs.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "vm/error.h"

/* Reads to the end of the file, or until more than `largest` bytes have been read. */
static char *read_stream(FILE *file, size_t largest, size_t *length)
{
    size_t room = 1 << 14;
    char *text = malloc(room);
    *length = 0;
    while (text) {
        *length += fread(text + *length, 1, room - *length - 1, file);
        if (*length < room - 1 || *length > largest)
            break;
        char *larger = realloc(text, room *= 2);
        if (!larger)
            free(text);
        text = larger;
    }
    if (text)
        text[*length] = '\0';
    return text;
}

/* Returns 0 after a successful read, and otherwise its errno. */
static int reason(const FILE *file, const char *text, size_t length, size_t largest)
{
    if (!file || !text || errno)
        return errno ? errno : EIO;
    return length > largest ? EFBIG : 0;
}

bool file_is_stream(const char *path)
{
    return strcmp(path, "-") == 0;
}

bool file_ends_with(const char *path, const char *ending)
{
    size_t length = strlen(path), rest = strlen(ending);
    return length > rest && path[length - rest - 1] != '/'
           && strcmp(path + length - rest, ending) == 0;
}

const char *file_reason(int code)
{
    return code == ETXTBSY ? "an output of this command cannot be an input"
                           : strerror(code);
}

static bool is_output(FILE *file)
{
    struct stat status;
    bool refused = fstat(fileno(file), &status) == 0 && outputs_refuse(&status);
    if (refused)
        errno = ETXTBSY;
    return refused;
}

char *file_read(const char *path, size_t largest, size_t *length, c205_error *error)
{
    FILE *file;
    char *text = NULL;
    int why;
    errno = 0;
    file = file_is_stream(path) ? stdin : fopen(path, "rb");
    *length = 0;
    if (file && !is_output(file)) {
        text = read_stream(file, largest, length);
        if (text && !ferror(file))
            errno = 0;
    }
    why = reason(file, text, *length, largest);
    if (file && file != stdin)
        fclose(file);
    if (!why)
        return text;
    free(text);
    if (why == EFBIG)
        error_set(error, "this file has more than %zu bytes", largest);
    else
        error_set(error, "%s", file_reason(why));
    errno = why;
    return NULL;
}

bool file_is_plain(const char *path, c205_error *error)
{
    struct stat is;
    if (stat(path, &is) == 0)
        return S_ISREG(is.st_mode)
               || error_set(error, "%s",
                            S_ISDIR(is.st_mode) ? "a folder" : "a pipe or a device");
    error_set(error, "%s", strerror(errno));
    return lstat(path, &is) == 0 && S_ISLNK(is.st_mode)
           && error_set(error, "a broken link");
}

/* Finds the folder of a path and the name of the file in it. Returns false if the
 * folder does not exist. */
static bool find_place(const char *path, struct stat *folder, const char **name)
{
    const char *slash = strrchr(path, '/');
    char text[4096];
    int length = !slash ? 0 : (int)(slash - path) + 1;
    *name = path + length;
    if (length >= (int)sizeof text)
        return false;
    snprintf(text, sizeof text, "%.*s.", length, path);
    return stat(text, folder) == 0;
}

static bool is_same(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

bool file_is_one(const char *a, const char *b)
{
    struct stat in_a, in_b;
    const char *name_a, *name_b;
    if (stat(a, &in_a) == 0 && stat(b, &in_b) == 0)
        return is_same(&in_a, &in_b);
    return find_place(a, &in_a, &name_a) && find_place(b, &in_b, &name_b)
           && is_same(&in_a, &in_b) && strcmp(name_a, name_b) == 0;
}
