/* solids.h - writes a scene's primitives and regions into the machine's memory. */
#ifndef RT_LAYOUT_SOLIDS_H
#define RT_LAYOUT_SOLIDS_H

#include "rt/layout/bounding.h"
#include "rt/layout/interiors.h"
#include "rt/layout/record.h"
#include "rt/bvh/viewpoints.h"

/* Writes the primitives and regions. Call this after images_layout; `images` contains
 * the address of each image. `viewpoints` are points that many rays pass through, or
 * NULL. */
void layout_solids(struct record_layout *layout, const struct scene *scene,
                   const struct interiors *interiors, const uint64_t *images,
                   const struct viewpoints *viewpoints, enum bounding bounding);

#endif
