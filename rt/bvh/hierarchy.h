/* hierarchy.h - a bounding volume hierarchy over regions, which the machine
 * traverses instead of testing every region.
 *
 * The host builds it and traces no rays. nesting.h uses one to group the parts of
 * a large tree. Each node has a sphere around all regions below it. Nodes are in
 * preorder: the first child of a node follows the node directly, and the second
 * child is at the first child's `next`.
 */
#ifndef RT_HIERARCHY_H
#define RT_HIERARCHY_H

#include "rt/bvh/bound.h"

struct hierarchy_node {
    struct bound bound;
    size_t next;   /* the node after the subtree of this one */
    size_t first;  /* leaf: position of its first region in the order */
    size_t count;  /* leaf: number of regions; 0: an inner node */
    double way[3]; /* from the centre of the first child to the second's */
};

/* The largest number of nodes on a path from the root to a leaf. The machine's
 * stack has room for that many. */
enum { HIERARCHY_DEPTH = 96 };

struct hierarchy {
    size_t count;
    size_t *order; /* region numbers: the loose ones first, then those of the leaves
                    * in order */
    size_t loose;  /* number of regions under no node, because they have no bound or
                    * because a hierarchy of them would not help */
    size_t node_count;
    struct hierarchy_node *nodes;
};

/* Builds a hierarchy over count regions. Returns false if out of memory. */
bool hierarchy_build(const struct bound *bounds, size_t count,
                     struct hierarchy *hierarchy);
/* Makes an empty hierarchy: all regions are loose, in their own order. */
bool hierarchy_none(size_t count, struct hierarchy *hierarchy);
void hierarchy_free(struct hierarchy *hierarchy);

#endif
