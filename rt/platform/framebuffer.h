/* framebuffer.h - the words of a whole frame, in memory by the band.
 *
 * A frame of few pixels is in memory.  One of many is in a file
 * without a name, in the folder that the environment's TMPDIR names or in
 * /tmp: its words are reached like others, and who is done with some of them
 * says so, whereupon they cost no memory until they are looked at again.
 * Where there is no room for such a file, memory is taken after all.
 */
#ifndef RT_HOST_FRAMEBUFFER_H
#define RT_HOST_FRAMEBUFFER_H

#include "vm/c205.h"

/* Bytes; more of them go to a file. */
#define PLANES_IN_MEMORY ((size_t)1 << 26)

struct frame_planes {
    c205_word *words; /* all zero at first */
    size_t bytes;
    int file; /* or -1 */
};

/* False: there is no memory. */
bool framebuffer_take(struct frame_planes *planes, size_t words);
void planes_give_back(struct frame_planes *planes);

/* These words are not looked at for now. */
void framebuffer_leave(const struct frame_planes *planes, size_t first, size_t count);

#endif
