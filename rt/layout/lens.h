/* lens.h - writes a camera's lens into the machine's memory. */
#ifndef RT_LENS_H
#define RT_LENS_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Writes the lens points of a pixel's samples x samples rays to the words that
 * rt/kernels/frame/lens.s defines. */
void layout_lens(struct record_layout *layout, const struct camera *camera,
                 size_t samples);

#endif
