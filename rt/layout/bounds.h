/* bounds.h - spheres that nothing of a solid reaches beyond. */
#ifndef RT_BOUNDS_H
#define RT_BOUNDS_H

#include "rt/shapes/bound.h"

/* Each node of the scene's trees, in their order: an intersection has the
 * least of its children's bounds, a union one about them all, a complement
 * none.  False: no memory. */
bool bound_nodes(const struct scene *scene, struct bound *bounds);

#endif
