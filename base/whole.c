/* whole.c - see whole.h. */
#include "base/whole.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file.h"
#include "base/interrupt.h"

enum { SUFFIX_SIZE = 16, ATTEMPTS = 100 };

static void tell(c205_error *error, const char *path, const char *why)
{
    snprintf(error->message, sizeof error->message, "%.180s: %.60s", path,
             why);
}

static bool is_special(const char *path)
{
    struct stat status;
    return lstat(path, &status) == 0 && !S_ISREG(status.st_mode);
}

/* The first name "path.newN" that nobody uses. */
static int open_beside(struct whole *whole)
{
    size_t size = strlen(whole->path) + SUFFIX_SIZE;
    int file = -1;
    whole->temporary = malloc(size);
    errno = ENOMEM;
    for (int n = 0; whole->temporary && file < 0 && n < ATTEMPTS; n++) {
        snprintf(whole->temporary, size, "%s.new%d", whole->path, n);
        file = interrupt_create(whole->temporary);
        if (file < 0 && errno != EEXIST) {
            break;
        }
    }
    return file;
}

static void whole_free(struct whole *whole)
{
    interrupt_release(whole->temporary);
    free(whole->temporary);
    free(whole->path);
    free(whole);
}

static FILE *open_place(struct whole *whole)
{
    if (file_is_stream(whole->path)) {
        return stdout;
    }
    int file = is_special(whole->path) ? open(whole->path, O_WRONLY)
                                       : open_beside(whole);
    return file < 0 ? NULL : fdopen(file, "w");
}

/* stdout goes on. */
static bool close_place(struct whole *whole)
{
    return whole->file == stdout || fclose(whole->file) == 0;
}

struct whole *whole_open(const char *path, c205_error *error)
{
    struct whole *whole = calloc(1, sizeof *whole);
    if (!whole || !(whole->path = malloc(strlen(path) + 1))) {
        free(whole);
        tell(error, path, "no memory");
        return NULL;
    }
    strcpy(whole->path, path);
    whole->file = open_place(whole);
    if (!whole->file) {
        tell(error, path, strerror(errno));
        whole_free(whole);
        return NULL;
    }
    return whole;
}

bool whole_check(const char *path, c205_error *error)
{
    if (file_is_stream(path)) {
        return true;
    }
    if (is_special(path)) {
        if (access(path, W_OK) == 0) {
            return true;
        }
        tell(error, path, strerror(errno));
        return false;
    }
    struct whole *whole = whole_open(path, error);
    if (!whole) {
        return false;
    }
    whole_discard(whole);
    return true;
}

/* All that was written is on the disk; what is no regular file has none. */
static bool reaches_disk(const struct whole *whole)
{
    return !ferror(whole->file) && fflush(whole->file) == 0
           && (!whole->temporary || fsync(fileno(whole->file)) == 0);
}

bool whole_commit(struct whole *whole, c205_error *error)
{
    errno = 0;
    bool good = reaches_disk(whole);
    good = close_place(whole) && good;
    if (good && whole->temporary) {
        good = rename(whole->temporary, whole->path) == 0;
    }
    if (!good) {
        tell(error, whole->path, errno ? strerror(errno) : "write error");
        if (whole->temporary) {
            unlink(whole->temporary);
        }
    }
    whole_free(whole);
    return good;
}

void whole_discard(struct whole *whole)
{
    close_place(whole);
    if (whole->temporary) {
        unlink(whole->temporary);
    }
    whole_free(whole);
}
