/* nesting.h - groups the parts of large trees, so that a ray can skip a whole group.
 *
 * A union of many solids becomes a union of unions. The difference of A and B, C, ..
 * becomes the difference of A and the union of B, C, .., which is grouped in the same
 * way. The hierarchy of rt/bvh/hierarchy.h groups parts that are near each other. The
 * interior and the visible surfaces of the tree do not change.
 */
#ifndef RT_NESTING_H
#define RT_NESTING_H

#include "rt/bvh/bound.h"
#include "rt/shapes/primitive.h"

/* A copy of a scene in which the parts of large trees are grouped. The copy has its own
 * nodes, regions and bounds, and shares all other data with the original scene.
 * bounds[i] is the bound of node i of the copy. A copied node has the bound that
 * bounds.h computes, and a new group has a bound around its parts. */
struct nested_scene {
    struct scene scene;
    struct bound *bounds;
};

/* Groups the parts in the trees of a scene. Returns false if out of memory. */
bool nesting_make(const struct scene *scene, struct nested_scene *nested);
void nesting_free(struct nested_scene *nested);

#endif
