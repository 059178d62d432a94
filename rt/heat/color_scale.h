/* color_scale.h - draws a colour bar below a picture, with numbers and their unit.
 *
 * The bar has rows of its own, so it hides nothing of the scene. The numbers at
 * its ends are the smallest and the largest value, or 0 at one end if all values
 * have the same sign. Otherwise 0 is marked between them. The title with the unit
 * is below. Letters have five by seven dots, and are enlarged in pictures of 640
 * columns or more.
 */
#ifndef RT_HEAT_COLOR_SCALE_H
#define RT_HEAT_COLOR_SCALE_H

#include "rt/picture/picture.h"

struct color_scale {
    const char *title; /* of letters that color_scale.c has */
    double least, most;
    /* Computes the colour of a share: -1 is `least`, or 0 if least is not negative; 1
     * is `most`. */
    void (*color)(const void *context, double share, double color[3]);
    const void *context;
};

/* Returns the rows that the scale needs in a picture of this width. */
size_t color_scale_rows(const struct color_scale *scale, size_t width);
/* Draws the scale into the rows of the frame from `first` on, which are black. */
void color_scale_draw(const struct color_scale *scale, struct frame *frame,
                      size_t first);

#endif
