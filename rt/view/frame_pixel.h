/* frame_pixel.h - finds the band that contains a pixel of a frame, and the index of the
 * pixel in it. */
#ifndef RT_FRAME_PIXEL_H
#define RT_FRAME_PIXEL_H

#include "rt/trace/trace.h"

struct frame_pixel {
    const struct trace *trace;
    size_t x, y;
    size_t band;  /* band that contains the pixel */
    size_t place; /* index of the pixel in the band's planes */
};

/* Locates a pixel of the frame. Returns false if the frame's pixels have several
 * rays. */
bool frame_pixel_find(struct frame_pixel *pixel, const struct trace *trace, size_t x,
                      size_t y, c205_error *error);

#endif
