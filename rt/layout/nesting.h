/* nesting.h - trees with many parts, as nested ones that a ray passes over.
 *
 * A union of many solids becomes unions of unions, and what a difference takes
 * away likewise: A less B, C, .. is A less the union of B, C, ..  Those that are near
 * each other are put together, by the hierarchy that regions have.  What is inside
 * of the tree does not change, nor which surface shows.
 */
#ifndef RT_NESTING_H
#define RT_NESTING_H

#include "rt/shapes/bound.h"

/* A scene with nodes and regions of its own, all else another's, and with the
 * bounds of its nodes: those that they had (bounds.h), and of parts that are put
 * together one about these. */
struct nested_scene {
    struct scene scene;
    struct bound *bounds;
};

/* As deep in calls as the scene's trees are.  False: no memory. */
bool nesting_make(const struct scene *scene, struct nested_scene *nested);
void nesting_free(struct nested_scene *nested);

#endif
