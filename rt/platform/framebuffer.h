/* framebuffer.h - the words of a whole frame, of which only the active part needs
 * memory.
 *
 * A small frame is in memory. A large one is a mapping of an unnamed file, in the
 * folder in the environment variable TMPDIR or in /tmp. A caller that has finished
 * with some words for now calls framebuffer_leave; they then need no memory until
 * the next access. If there is no space for the file, the frame is allocated in
 * memory.
 */
#ifndef RT_HOST_FRAMEBUFFER_H
#define RT_HOST_FRAMEBUFFER_H

#include "vm/c205.h"

/* Size in bytes; a larger frame goes to a file. */
#define PLANES_IN_MEMORY ((size_t)1 << 26)

struct frame_planes {
    c205_word *words; /* initially zeros */
    size_t bytes;
    int file; /* or -1 */
};

/* Allocates a frame. Returns false if out of memory. */
bool framebuffer_take(struct frame_planes *planes, size_t words);
void planes_give_back(struct frame_planes *planes);

/* Releases the memory of these words until the next access. */
void framebuffer_leave(const struct frame_planes *planes, size_t first, size_t count);

#endif
