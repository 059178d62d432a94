/* lights.h - writes a scene's lights into the machine's memory. */
#ifndef RT_LIGHTS_H
#define RT_LIGHTS_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Returns true if a light of the scene needs the kernel light/beam.s. */
bool scene_has_beams(const struct scene *scene);
/* Returns true if a light of the scene needs the kernel light/area_vector.s. */
bool scene_has_areas(const struct scene *scene);
/* Returns true if the light casts all its shadows from its position. */
bool light_shadows_from_point(const struct light *light);
void layout_lights(struct record_layout *layout, const struct scene *scene);

#endif
