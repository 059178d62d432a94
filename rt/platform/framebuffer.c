/* framebuffer.c - stores the words of a whole frame, in memory or in a file. */
#include "rt/platform/framebuffer.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/* Opens an unnamed file of this size, and reserves its disk space. Returns -1 on
 * failure. */
static int open_nameless(size_t bytes)
{
    const char *folder = getenv("TMPDIR");
    char path[4096];
    int file;
    snprintf(path, sizeof path, "%s/rt205.XXXXXX", folder && *folder ? folder : "/tmp");
    file = mkstemp(path);
    if (file < 0)
        return -1;
    unlink(path);
    /* Without reserved space, a full disk would end the process when it writes to the
     * mapping. */
    if (posix_fallocate(file, 0, (off_t)bytes) == 0)
        return file;
    close(file);
    return -1;
}

/* Maps a part of the file. If the part is already mapped at `where`, its memory is
 * released, and its contents stay in the file. */
static void *map_part(const struct frame_planes *planes, void *where, size_t begin,
                      size_t end)
{
    return mmap(where, end - begin, PROT_READ | PROT_WRITE,
                MAP_SHARED | (where ? MAP_FIXED : 0), planes->file, (off_t)begin);
}

static bool map_file(struct frame_planes *planes)
{
    void *words;
    planes->file = open_nameless(planes->bytes);
    if (planes->file < 0)
        return false;
    words = map_part(planes, NULL, 0, planes->bytes);
    if (words != MAP_FAILED) {
        planes->words = words;
        return true;
    }
    close(planes->file);
    planes->file = -1;
    return false;
}

bool framebuffer_take(struct frame_planes *planes, size_t words)
{
    planes->bytes = words * sizeof *planes->words;
    planes->file = -1;
    if (planes->bytes > PLANES_IN_MEMORY && map_file(planes))
        return true;
    planes->words = calloc(words, sizeof *planes->words);
    return planes->words != NULL;
}

void planes_give_back(struct frame_planes *planes)
{
    if (!planes->words)
        return;
    if (planes->file < 0) {
        free(planes->words);
    } else {
        munmap(planes->words, planes->bytes);
        close(planes->file);
    }
    planes->words = NULL;
}

void framebuffer_leave(const struct frame_planes *planes, size_t first, size_t count)
{
    size_t page = (size_t)sysconf(_SC_PAGESIZE);
    size_t begin = first * sizeof *planes->words / page * page;
    size_t end = (first + count) * sizeof *planes->words;
    if (planes->file >= 0)
        map_part(planes, (char *)planes->words + begin, begin, end);
}
