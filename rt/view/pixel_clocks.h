/* pixel_clocks.h - when the queue is traced that a pixel's ray is in.
 *
 * A band's machine traces queue after queue of the pixels' rays; in scalar form each pixel is
 * a queue of its own, with all that comes of its ray.  Of a queue of the vector form and of
 * that of 1984 what is reflected and refracted goes into other queues, later.
 */
#ifndef RT_PIXEL_CLOCKS_H
#define RT_PIXEL_CLOCKS_H

#include "rt/view/frame_pixel.h"

/* Clocks of the band's machine, from its beginning. */
struct clock_stretch {
    uint64_t from, to;
};

/* From where the rays of the pixel's queue are made to where their colours are stored: the
 * band is traced up to there.  False: a trap, or the trace's progress said to stop. */
bool pixel_queue_clocks(const struct frame_pixel *pixel, struct clock_stretch *stretch,
                        c205_error *error);
/* Of a stretch the first in which control is in that region.  False: or there is none. */
bool pixel_region_clocks(const struct frame_pixel *pixel, const char *region,
                         struct clock_stretch *stretch, c205_error *error);

#endif
