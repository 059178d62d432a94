/* nesting.h - regroups trees with many parts, so that a ray can skip groups.
 *
 * A union of many solids becomes a union of unions. A difference A less B, C, ..
 * becomes A less the union of B, C, .., which is nested likewise. Parts that are
 * near each other are grouped, by the same hierarchy that regions use. The
 * interior of the tree does not change, nor do its visible surfaces.
 */
#ifndef RT_NESTING_H
#define RT_NESTING_H

#include "rt/bvh/bound.h"
#include "rt/shapes/primitive.h"

/* A scene with nodes and regions of its own, which shares all else with the
 * original. The bounds of its original nodes are those of bounds.h. A group of
 * parts has a bound around the parts. */
struct nested_scene {
    struct scene scene;
    struct bound *bounds;
};

/* Nests the trees of a scene. The recursion is as deep as the trees. Returns false
 * if out of memory. */
bool nesting_make(const struct scene *scene, struct nested_scene *nested);
void nesting_free(struct nested_scene *nested);

#endif
