/* color_scale.h - draws a colour bar below a picture, with numbers and their unit.
 *
 * The bar has additional rows, so it hides no part of the scene. If all values have the
 * same sign, the bar extends from 0 to the value farthest from 0. Otherwise it extends
 * from the smallest to the largest value, and 0 is marked. The title with the unit is
 * below the bar. Letters have five by seven dots, and are enlarged in pictures of 640
 * columns or more.
 */
#ifndef RT_HEAT_COLOR_SCALE_H
#define RT_HEAT_COLOR_SCALE_H

#include "rt/picture/picture.h"

struct color_scale {
    const char *title; /* may only have the letters in color_scale.c */
    double least, most;
    /* Computes the colour at a position of the scale. The share 0 is the value 0, and
     * the share 1 is the value `most`. If `least` is negative, the share -1 is the
     * value `least`. */
    void (*color)(const void *context, double share, double color[3]);
    const void *context;
};

/* Returns the number of rows of the scale below a picture of this width. */
size_t color_scale_rows(const struct color_scale *scale, size_t width);
/* Draws the scale into the black rows of the frame from `first` on. */
void color_scale_draw(const struct color_scale *scale, struct frame *frame,
                      size_t first);

#endif
