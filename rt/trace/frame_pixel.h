/* frame_pixel.h - a pixel of a frame in the machine of its band: the queue that its ray is
 * in, and when that is traced.
 *
 * A band's machine traces queue after queue of the pixels' rays; in scalar form each pixel is
 * a queue of its own, with all that comes of its ray.  Of a queue of the vector form and of
 * that of 1984 what is reflected and refracted goes into other queues, later.
 */
#ifndef RT_FRAME_PIXEL_H
#define RT_FRAME_PIXEL_H

#include "rt/trace/trace.h"

struct frame_pixel {
    const struct trace *trace;
    size_t x, y;
    size_t band;  /* that it is in, .. */
    size_t place; /* .. and where in the band's planes */
};

/* The frame has such a pixel.  False: its pixels have several rays. */
bool frame_pixel_find(struct frame_pixel *pixel, const struct trace *trace,
                      size_t x, size_t y, c205_error *error);

/* Whether the ray of the pixel is in the queue whose rays have just been made. */
bool frame_pixel_is_in_queue(const struct frame_pixel *pixel,
                             const c205 *machine);

/* Clocks of the band's machine, from its beginning. */
struct clock_stretch {
    uint64_t from, to;
};

/* From where the rays of the pixel's queue are made to where their colours are stored: the
 * band is traced up to there.  False: a trap, or the trace's progress said to stop. */
bool frame_pixel_queue(const struct frame_pixel *pixel,
                       struct clock_stretch *stretch, c205_error *error);
/* Of a stretch the first in which control is in that region.  False: or there is none. */
bool frame_pixel_region(const struct frame_pixel *pixel, const char *region,
                        struct clock_stretch *stretch, c205_error *error);

#endif
