/* environment.h - what is around a scene's things, in the machine's memory:
 * its sky and its fogs. */
#ifndef RT_ENVIRONMENT_H
#define RT_ENVIRONMENT_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* The images' pixels are laid out: where, by number. */
void layout_sky(struct record_layout *layout, const struct scene *scene,
                const uint64_t *images);
void layout_fogs(struct record_layout *layout, const struct scene *scene);

#endif
