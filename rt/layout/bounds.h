/* bounds.h - spheres and boxes that nothing of a solid reaches beyond. */
#ifndef RT_BOUNDS_H
#define RT_BOUNDS_H

#include "rt/shapes/bound.h"

/* Each node of the scene's trees, in their order: an intersection has the
 * least of its children's spheres and what their boxes have in common, a union
 * bounds about them all, a complement none.  False: no memory. */
bool bound_nodes(const struct scene *scene, struct bound *bounds);

#endif
