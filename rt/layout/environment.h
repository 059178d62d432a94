/* environment.h - writes a scene's sky and fogs into the machine's memory. */
#ifndef RT_ENVIRONMENT_H
#define RT_ENVIRONMENT_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Writes the sky. Call this after images_layout. `images` contains the address of each
 * image. */
void layout_sky(struct record_layout *layout, const struct scene *scene,
                const uint64_t *images);
void layout_fogs(struct record_layout *layout, const struct scene *scene);

#endif
