/* layout.h - a scene as records in the machine's memory.
 *
 * The one place where scene numbers become the machine's own.  A scene is laid
 * out once, for any number of machines, each of which traces bands of a frame.
 */
#ifndef RT_LAYOUT_H
#define RT_LAYOUT_H

#include "asm/assemble.h"
#include "rt/layout/bounding.h"
#include "rt/scene/scene.h"

/* Where the frame's planes lie, for reading them back. */
struct frame_layout {
    uint64_t address;       /* FRAME_CHANNELS planes of width x rows words */
    size_t width, height;   /* of the whole frame, pixels */
    size_t samples;         /* across a pixel and down; 0: one */
    double threshold;       /* above it pixels get these samples; 0: all do */
    size_t first_row, rows; /* of the band that is traced */
    bool tiles;             /* queues of its pixels are tiles, not rows */
};

/* What all machines have in common. */
struct scene_layout;

/* NULL: no memory, or numbers that do not fit.  go_on is asked now and then:
 * false ends a long layout, with an error; NULL: nobody is asked. */
struct scene_layout *layout_new(const struct object *program, const struct scene *scene,
                                enum bounding bounding, bool (*go_on)(void *context),
                                void *context, c205_error *error);
void layout_free(struct scene_layout *layout);

/* After c205_load: map and fill what the program reads, map the planes that
 * it writes.  The layout stays as long as the machine runs or is looked at. */
bool layout_put(const struct scene_layout *layout, c205 *machine,
                struct frame_layout *frame, c205_error *error);

#endif
