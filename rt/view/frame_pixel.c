/* frame_pixel.c - finds the band that contains a pixel of a frame. */
#include "rt/view/frame_pixel.h"

#include "vm/error.h"

bool frame_pixel_find(struct frame_pixel *pixel, const struct trace *trace, size_t x,
                      size_t y, c205_error *error)
{
    const struct trace_options *how = trace_how(trace);
    size_t band = 0;
    if (how->samples > 1)
        return error_set(error,
                         "a pixel of this frame has %zu x %zu rays: only a pixel "
                         "with one ray can be followed",
                         how->samples, how->samples);
    while (trace_band_row(trace, band + 1) <= y)
        band++;
    *pixel = (struct frame_pixel){ trace, x, y, band,
                                   (y - trace_band_row(trace, band)) * how->width + x };
    return true;
}
