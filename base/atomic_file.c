/* atomic_file.c - writes a temporary file and renames it when it is complete. */
#include "base/atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "vm/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/outputs.h"

enum { SUFFIX_SIZE = 16, ATTEMPTS = 100, MAX_LINKS = 40, PATH_SIZE = 4096 };

static void set_path_error(c205_error *error, const char *path, const char *why)
{
    error_set(error, "cannot write %.180s: %.60s", path, why);
}

static bool is_stream(const struct stat *status, int number)
{
    struct stat stream;
    return fstat(number, &stream) == 0 && stream.st_dev == status->st_dev
           && stream.st_ino == status->st_ino;
}

/* Returns true for files that are written directly: devices, pipes, and the files of
 * stdout and stderr. */
static bool is_special(const char *path)
{
    struct stat status;
    if (stat(path, &status) != 0)
        return errno == ELOOP;
    return !S_ISREG(status.st_mode) || is_stream(&status, STDOUT_FILENO)
           || is_stream(&status, STDERR_FILENO);
}

/* Returns the target of the symbolic link at a path, relative to the folder of the
 * link. Returns NULL if the path is not a link. The caller frees the result. */
static char *link_target(const char *path)
{
    struct stat status;
    if (lstat(path, &status) != 0 || !S_ISLNK(status.st_mode))
        return NULL;
    const char *slash = strrchr(path, '/');
    size_t folder = slash ? (size_t)(slash - path) + 1 : 0;
    size_t size = folder + PATH_SIZE;
    char *target = calloc(1, size);
    if (!target || readlink(path, target + folder, PATH_SIZE - 1) < 0) {
        free(target);
        return NULL;
    }
    if (target[folder] == '/')
        memmove(target, target + folder, size - folder);
    else
        memcpy(target, path, folder);
    return target;
}

/* Returns a copy of the path in which symbolic links at its end are resolved. NULL: out
 * of memory. */
static char *followed(const char *path)
{
    char *file = malloc(strlen(path) + 1), *target;
    if (file)
        strcpy(file, path);
    for (int i = 0;
         file && !is_special(file) && i < MAX_LINKS && (target = link_target(file));
         i++) {
        free(file);
        file = target;
    }
    return file;
}

/* Creates a file with the first unused name of the form "path.newN". */
static int open_beside(struct atomic_file *whole)
{
    size_t size = strlen(whole->path) + SUFFIX_SIZE;
    int file = -1;
    whole->temporary = malloc(size);
    errno = ENOMEM;
    for (int n = 0; whole->temporary && file < 0 && n < ATTEMPTS; n++) {
        snprintf(whole->temporary, size, "%s.new%d", whole->path, n);
        file = interrupt_create(whole->temporary);
        if (file < 0 && errno != EEXIST)
            break;
    }
    return file;
}

static void whole_free(struct atomic_file *whole)
{
    interrupt_release(whole->temporary);
    free(whole->temporary);
    free(whole->path);
    free(whole);
}

static FILE *open_place(struct atomic_file *whole)
{
    if (file_is_stream(whole->path))
        return stdout;
    int file = is_special(whole->path) ? open(whole->path, O_WRONLY)
                                       : open_beside(whole);
    return file < 0 ? NULL : fdopen(file, "w");
}

/* Closes the file, except stdout, which remains open. */
static bool close_place(struct atomic_file *whole)
{
    return whole->file == stdout || fclose(whole->file) == 0;
}

struct atomic_file *atomic_file_open(const char *path, c205_error *error)
{
    struct atomic_file *whole = calloc(1, sizeof *whole);
    if (!whole || !(whole->path = followed(path))) {
        free(whole);
        set_path_error(error, path, "out of memory");
        return NULL;
    }
    whole->file = open_place(whole);
    if (!whole->file) {
        set_path_error(error, path, strerror(errno));
        whole_free(whole);
        return NULL;
    }
    return whole;
}

bool atomic_file_check(const char *path, c205_error *error)
{
    if (file_is_stream(path))
        return true;
    if (is_special(path)) {
        if (access(path, W_OK) == 0)
            return true;
        set_path_error(error, path, strerror(errno));
        return false;
    }
    struct atomic_file *whole = atomic_file_open(path, error);
    if (!whole)
        return false;
    atomic_file_discard(whole);
    return true;
}

/* Returns true if all data was written. A regular file is also synchronised to the
 * disk. */
static bool reaches_disk(const struct atomic_file *whole)
{
    return !ferror(whole->file) && fflush(whole->file) == 0
           && (!whole->temporary || fsync(fileno(whole->file)) == 0);
}

bool atomic_file_commit(struct atomic_file *whole, c205_error *error)
{
    if (outputs_refused(whole->path)) {
        set_path_error(error, whole->path, file_reason(ETXTBSY));
        atomic_file_discard(whole);
        return false;
    }
    errno = 0;
    bool good = reaches_disk(whole);
    good = close_place(whole) && good;
    if (good && whole->temporary)
        good = rename(whole->temporary, whole->path) == 0;
    if (!good) {
        set_path_error(error, whole->path, errno ? strerror(errno) : "write error");
        if (whole->temporary)
            unlink(whole->temporary);
    }
    whole_free(whole);
    return good;
}

void atomic_file_discard(struct atomic_file *whole)
{
    close_place(whole);
    if (whole->temporary)
        unlink(whole->temporary);
    whole_free(whole);
}
