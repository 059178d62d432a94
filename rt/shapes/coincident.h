/* coincident.h - orders regions whose opaque surfaces may coincide. */
#ifndef RT_COINCIDENT_H
#define RT_COINCIDENT_H

#include "rt/scene/scene.h"

/* k_delta of the kernels: surfaces that are closer than this count as coincident. */
#define COINCIDENT 1e-7

/* Sets the yield of every region. A region has a yield above 0 if one of its opaque
 * surfaces may coincide with a surface of a later region. The earlier region has the
 * greater yield. All yields are below 1 (docs/solids.md). Returns false if out of
 * memory. */
bool coincident_find(struct scene *scene);

#endif
