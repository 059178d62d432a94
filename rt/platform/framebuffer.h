/* framebuffer.h - the words of a whole frame, of which only the part in use needs
 * memory.
 *
 * A small frame is in memory. A large frame is a mapping of an unnamed file in the
 * folder in the environment variable TMPDIR, or in /tmp. framebuffer_leave releases the
 * memory of words until their next access. If there is no space for the file, the frame
 * is in memory.
 */
#ifndef RT_HOST_FRAMEBUFFER_H
#define RT_HOST_FRAMEBUFFER_H

#include "vm/c205.h"

/* A frame with more bytes is stored in a file. */
#define PLANES_IN_MEMORY ((size_t)1 << 26)

struct frame_planes {
    c205_word *words; /* initially zero */
    size_t bytes;
    int file; /* file descriptor, or -1 */
};

/* Allocates a frame. Returns false if out of memory. */
bool framebuffer_take(struct frame_planes *planes, size_t words);
void planes_give_back(struct frame_planes *planes);

/* Releases the memory of these words until the next access. */
void framebuffer_leave(const struct frame_planes *planes, size_t first, size_t count);

#endif
