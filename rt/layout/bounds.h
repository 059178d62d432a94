/* bounds.h - computes bounding spheres and boxes for the nodes of trees. */
#ifndef RT_BOUNDS_H
#define RT_BOUNDS_H

#include "rt/bvh/bound.h"
#include "rt/shapes/primitive.h"

/* Computes the bound of each node of the scene's trees, in the order of the nodes. An
 * intersection gets the smallest of its children's spheres, and the intersection of
 * their boxes. A union gets bounds around all children. A complement has no bound.
 * Returns false if out of memory. */
bool bound_nodes(const struct scene *scene, struct bound *bounds);

#endif
