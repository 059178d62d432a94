/* pixel_clocks.h - finds the clocks in which the queue with a pixel's ray is traced.
 *
 * A band's machine traces the pixels' rays queue by queue. In the scalar form each
 * pixel is a separate queue, with all its secondary rays. In the other forms, reflected
 * and refracted rays go into later queues.
 */
#ifndef RT_PIXEL_CLOCKS_H
#define RT_PIXEL_CLOCKS_H

#include "rt/view/frame_pixel.h"

/* A range of clocks of the band's machine. */
struct clock_stretch {
    uint64_t from, to;
};

/* Finds the range of clocks of the pixel's queue. It begins when the rays are
 * generated, and ends when their colours are stored. The band is traced up to this
 * point. Returns false after a trap, or if the progress function of the trace returned
 * false. */
bool pixel_queue_clocks(const struct frame_pixel *pixel, struct clock_stretch *stretch,
                        c205_error *error);
/* Replaces *stretch by the first part of it in which the program counter is in the
 * region. Returns false if there is no such part, after a trap, or if the progress
 * function of the trace returned false. */
bool pixel_region_clocks(const struct frame_pixel *pixel, const char *region,
                         struct clock_stretch *stretch, c205_error *error);

#endif
