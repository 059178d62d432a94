/* frame_pixel.h - locates a pixel of a frame in the machine of its band. */
#ifndef RT_FRAME_PIXEL_H
#define RT_FRAME_PIXEL_H

#include "rt/trace/trace.h"

struct frame_pixel {
    const struct trace *trace;
    size_t x, y;
    size_t band;  /* the band that contains it */
    size_t place; /* its index in the band's planes */
};

/* Locates a pixel that the frame has. Returns false if its pixels have several
 * rays. */
bool frame_pixel_find(struct frame_pixel *pixel, const struct trace *trace, size_t x,
                      size_t y, c205_error *error);

#endif
