/* bumps.h - writes bump maps and other changes of normals as records for
 * rt/kernels/light/bump.s. */
#ifndef RT_LAYOUT_BUMPS_H
#define RT_LAYOUT_BUMPS_H

#include "rt/layout/record.h"
#include "rt/scene/scene.h"

/* Returns true if a surface of the scene needs the kernel light/bump.s. */
bool scene_has_bumps(const struct scene *scene);
/* Sets the address of each primitive's bump record, or 0 if it has none. Consecutive
 * primitives with the same normal share a record. */
void layout_bumps(struct record_layout *layout, const struct scene *scene,
                  uint64_t *addresses);

#endif
