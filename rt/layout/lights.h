/* lights.h - a scene's lights in the machine's memory. */
#ifndef RT_LIGHTS_H
#define RT_LIGHTS_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Whether the kernels need light/beam.s for one of its lights. */
bool scene_has_beams(const struct scene *scene);
/* .. and light/area_vector.s. */
bool scene_has_areas(const struct scene *scene);
/* It casts shadows, all of them from the place where it is. */
bool light_shadows_from_point(const struct light *light);
void layout_lights(struct record_layout *layout, const struct scene *scene);

#endif
