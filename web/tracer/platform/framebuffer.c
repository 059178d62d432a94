/* framebuffer.c - framebuffers in the page. They are always in memory, for any size. */
#include "rt/platform/framebuffer.h"

#include <stdlib.h>

bool framebuffer_take(struct frame_planes *planes, size_t words)
{
    planes->words = calloc(words, sizeof *planes->words);
    return planes->words;
}

void planes_give_back(struct frame_planes *planes)
{
    free(planes->words);
    planes->words = NULL;
}

void framebuffer_leave(const struct frame_planes *planes, size_t first, size_t count)
{
    (void)planes, (void)first, (void)count;
}
