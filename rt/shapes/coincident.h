/* coincident.h - regions whose opaque surfaces may coincide with those of others. */
#ifndef RT_COINCIDENT_H
#define RT_COINCIDENT_H

#include "rt/scene/scene.h"

/* k_delta of the kernels: surfaces nearer to each other are one. */
#define COINCIDENT 1e-7

/* Sets the yield of every region of the scene: above 0 where an opaque surface of it
 * may coincide with one of a later region, and then greater than that region's; below
 * 1 (docs/solids.md).  False: no memory. */
bool coincident_find(struct scene *scene);

#endif
