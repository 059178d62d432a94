/* layout.h - a scene as records in the machine's memory.
 *
 * The one place where scene numbers become the machine's own.  Where a field
 * lies is written once, in rt/kernels/records.s; it is found here by its name
 * among the program's symbols.
 */
#ifndef RT_LAYOUT_H
#define RT_LAYOUT_H

#include "asm/assemble.h"
#include "rt/scene/scene.h"

/* Where the frame's planes lie, for reading them back. */
struct frame_layout {
    uint64_t address; /* FRAME_CHANNELS planes of width x height words */
    size_t width, height;
};

/* After c205_load: map and fill what the program reads, map the planes that
 * it writes. */
bool layout_scene(c205 *machine, const struct object *program,
                  const struct scene *scene, struct frame_layout *frame,
                  c205_error *error);

#endif
