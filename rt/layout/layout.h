/* layout.h - writes a scene as records in the machine's memory.
 *
 * Only this code converts numbers of a scene to numbers of the machine. A scene is laid
 * out once, for any number of machines. Each machine traces bands of a frame.
 */
#ifndef RT_LAYOUT_H
#define RT_LAYOUT_H

#include "asm/object/object.h"
#include "rt/layout/bounding.h"
#include "rt/scene/scene.h"

/* The position of a frame in memory, and its size. */
struct frame_layout {
    uint64_t address;       /* FRAME_CHANNELS planes of width x rows words */
    size_t width, height;   /* size of the whole frame in pixels */
    size_t samples;         /* samples x samples rays for each pixel; 0: one ray */
    double threshold;       /* Pixels that differ from a neighbour by more than this get
                             * further samples; 0: all pixels get them. */
    size_t first_row, rows; /* rows of the current band */
    bool tiles;             /* queues are tiles of pixels, not rows */
};

/* The part of memory that all machines share. */
struct scene_layout;

/* Writes the scene for a program into memory that machines can share. go_on may be
 * NULL. It is called at intervals; if it returns false, the layout stops with an error.
 * Returns NULL if out of memory, or if a number is out of range. */
struct scene_layout *layout_new(const struct object *program, const struct scene *scene,
                                enum bounding bounding, bool (*go_on)(void *context),
                                void *context, c205_error *error);
void layout_free(struct scene_layout *layout);

/* Maps and fills the memory that the program reads, and maps the planes that it writes.
 * Call this after c205_load. The layout must outlive all use of the machine. */
bool layout_put(const struct scene_layout *layout, c205 *machine,
                struct frame_layout *frame, c205_error *error);

#endif
