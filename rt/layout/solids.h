/* solids.h - a scene's primitives and regions in the machine's memory. */
#ifndef RT_LAYOUT_SOLIDS_H
#define RT_LAYOUT_SOLIDS_H

#include "rt/layout/bounding.h"
#include "rt/layout/interiors.h"
#include "rt/layout/record.h"
#include "rt/shapes/viewpoints.h"

/* The images' pixels are laid out: where, by number.  Eyes: through which many rays
 * go; NULL: none. */
void layout_solids(struct record_layout *layout, const struct scene *scene,
                   const struct interiors *interiors, const uint64_t *images,
                   const struct viewpoints *viewpoints, enum bounding bounding);

#endif
