/* lens.h - writes a camera's lens into the machine's memory. */
#ifndef RT_LENS_H
#define RT_LENS_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Writes the lens points of a pixel with samples x samples rays. The words are named in
 * rt/kernels/frame/lens.s. */
void layout_lens(struct record_layout *layout, const struct camera *camera,
                 size_t samples);

#endif
