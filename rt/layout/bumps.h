/* bumps.h - what changes normals, as the kernels want it (rt/kernels/light/bump.s). */
#ifndef RT_LAYOUT_BUMPS_H
#define RT_LAYOUT_BUMPS_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Whether the kernels need light/bump.s for one of its surfaces. */
bool scene_has_bumps(const struct scene *scene);
/* For each primitive the address of its bump, 0: none.  Neighbours of one normal have
 * one. */
void layout_bumps(struct record_layout *layout, const struct scene *scene,
                  uint64_t *addresses);

#endif
