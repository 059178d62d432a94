/* color_scale.h - a colour bar below a picture, with numbers and their unit.
 *
 * The bar takes rows of its own, so that it hides nothing of the scene.  Numbers are
 * at its ends: the least and the largest value, or 0 where all have one sign; else
 * 0 is marked between them.  The title with the unit is below.  Letters are five by seven dots, enlarged in pictures
 * of 640 columns and more.
 */
#ifndef RT_HEAT_COLOR_SCALE_H
#define RT_HEAT_COLOR_SCALE_H

#include "rt/picture/picture.h"

struct color_scale {
    const char *title; /* of letters that color_scale.c has */
    double least, most;
    /* The colour at a share of the way: -1, least, or 0 if that is not negative;
     * 1, most. */
    void (*color)(const void *context, double share, double color[3]);
    const void *context;
};

/* The rows that it needs in a picture of this width. */
size_t color_scale_rows(const struct color_scale *scale, size_t width);
/* Draws it into the rows of the frame from the first one on; they are black. */
void color_scale_draw(const struct color_scale *scale, struct frame *frame,
                      size_t first);

#endif
