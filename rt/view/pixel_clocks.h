/* pixel_clocks.h - finds the clocks in which the queue with a pixel's ray is
 * traced.
 *
 * A band's machine traces the pixels' rays queue by queue. In scalar form each
 * pixel is a queue of its own, with all secondary rays. In the vector form and in
 * that of 1984, reflected and refracted rays go into other, later queues.
 */
#ifndef RT_PIXEL_CLOCKS_H
#define RT_PIXEL_CLOCKS_H

#include "rt/view/frame_pixel.h"

/* Clocks of the band's machine, from its start. */
struct clock_stretch {
    uint64_t from, to;
};

/* Finds the clocks from the generation of the rays of the pixel's queue to the
 * storing of their colours. The band is traced up to that point. Returns false
 * after a trap, or if the trace's progress returned false. */
bool pixel_queue_clocks(const struct frame_pixel *pixel, struct clock_stretch *stretch,
                        c205_error *error);
/* Finds the first part of a range in which control is in the region. Returns false
 * in the same cases, or if there is none. */
bool pixel_region_clocks(const struct frame_pixel *pixel, const char *region,
                         struct clock_stretch *stretch, c205_error *error);

#endif
