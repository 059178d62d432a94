/* hierarchy.h - a bounding hierarchy over regions: what the machine walks
 * instead of looking at every region in turn.
 *
 * The host plans it, and traces nothing.  The parts of a great tree are put together
 * by one as well (nesting.h).  Each node has a sphere about all
 * regions below it; nodes are in preorder, so that the first of two nodes
 * below another is behind it, and the second where the first one's next
 * points.
 */
#ifndef RT_HIERARCHY_H
#define RT_HIERARCHY_H

#include "rt/shapes/bound.h"

struct hierarchy_node {
    struct bound bound;
    size_t next;   /* the node behind all that is below this one */
    size_t first;  /* of a leaf: its regions' places in the order */
    size_t count;  /* .. and how many; 0: there are two nodes below */
    double way[3]; /* from the centre of the first one to the second's */
};

/* The most nodes on a path of the hierarchy, both ends included: what the
 * machine's stack has room for. */
enum { HIERARCHY_DEPTH = 96 };

struct hierarchy {
    size_t count;
    size_t *order; /* the regions' numbers, the loose ones first; the others
                      as the leaves have them */
    size_t loose;  /* so many stand under no node: they have no bound, or a
                      hierarchy of them would be no gain */
    size_t node_count;
    struct hierarchy_node *nodes;
};

/* Of so many regions.  False: no memory. */
bool hierarchy_build(const struct bound *bounds, size_t count,
                     struct hierarchy *hierarchy);
/* All of them loose, in their own order. */
bool hierarchy_none(size_t count, struct hierarchy *hierarchy);
void hierarchy_free(struct hierarchy *hierarchy);

#endif
