/* coincident.h - orders regions whose opaque surfaces may coincide. */
#ifndef RT_COINCIDENT_H
#define RT_COINCIDENT_H

#include "rt/scene/scene.h"

/* k_delta of the kernels: surfaces closer to each other count as one. */
#define COINCIDENT 1e-7

/* Sets the yield of every region of the scene. It is above 0 if an opaque surface of
 * the region may coincide with one of a later region, and then greater than that
 * region's yield; it is below 1 (docs/solids.md). Fails without memory. */
bool coincident_find(struct scene *scene);

#endif
