/* layout.h - a scene as records in the machine's memory.
 *
 * The one place where scene numbers become the machine's own.
 */
#ifndef RT_LAYOUT_H
#define RT_LAYOUT_H

#include "asm/assemble.h"
#include "rt/scene/scene.h"

/* Where the frame's planes lie, for reading them back. */
struct frame_layout {
    uint64_t address;       /* FRAME_CHANNELS planes of width x rows words */
    size_t width, height;   /* of the whole frame, pixels */
    size_t samples;         /* across a pixel and down; 0: one */
    size_t first_row, rows; /* of the band that is traced */
    bool tiles;             /* queues of its pixels are tiles, not rows */
    /* Asked now and then while a long scene is laid out: false ends it, with an
     * error.  NULL: nobody is asked. */
    bool (*go_on)(void *context);
    void *context;
};

/* After c205_load: map and fill what the program reads, map the planes that
 * it writes.  Without bounds every ray is tried against every primitive. */
bool layout_scene(c205 *machine, const struct object *program,
                  const struct scene *scene, bool bounds,
                  struct frame_layout *frame, c205_error *error);

#endif
