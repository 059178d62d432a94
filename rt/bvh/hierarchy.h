/* hierarchy.h - a bounding volume hierarchy over regions. The machine traverses it
 * instead of testing every region.
 *
 * The host builds the hierarchy and traces no rays. nesting.h uses a hierarchy, too, to
 * group the parts of a large tree. Each node has a sphere around all regions below it.
 * Nodes are in preorder: the first child of a node directly follows the node, and the
 * second child is the first child's `next`.
 */
#ifndef RT_HIERARCHY_H
#define RT_HIERARCHY_H

#include "rt/bvh/bound.h"

struct hierarchy_node {
    struct bound bound;
    size_t next;   /* the first node after this node's subtree */
    size_t first;  /* leaf: position of its first region in the order */
    size_t count;  /* leaf: number of regions; 0: an inner node */
    double way[3]; /* vector from the first child's centre to the second child's
                    * centre */
};

/* The largest number of nodes on a path from the root to a leaf. The machine's stack
 * has this many entries. */
enum { HIERARCHY_DEPTH = 96 };

struct hierarchy {
    size_t count;
    size_t *order; /* region numbers: first the loose regions, then the regions of the
                    * leaves in order */
    size_t loose;  /* The number of regions that are in no leaf: they are unbounded, or
                    * there is no hierarchy because it would not help. */
    size_t node_count;
    struct hierarchy_node *nodes;
};

/* Builds a hierarchy over count regions. Returns false if out of memory. */
bool hierarchy_build(const struct bound *bounds, size_t count,
                     struct hierarchy *hierarchy);
/* Makes a hierarchy without nodes: all regions are loose (in no leaf), in their own
 * order. Returns false if out of memory. */
bool hierarchy_none(size_t count, struct hierarchy *hierarchy);
void hierarchy_free(struct hierarchy *hierarchy);

#endif
