/* mesh_hierarchy.h - a hierarchy of boxes over the triangles of a mesh.
 *
 * The host plans it, and traces nothing.  Nodes stand in preorder: of two nodes
 * below another the first stands behind it, and the second where the first
 * one's next points.  All leaves have TRIANGLES_IN_LEAF triangles but the
 * last, so that the number of nodes is known beforehand.
 */
#ifndef RT_MESH_HIERARCHY_H
#define RT_MESH_HIERARCHY_H

#include <stdbool.h>

#include "rt/shapes/cuts.h"

enum { TRIANGLES_IN_LEAF = 2 };

struct mesh_node {
    struct box box;
    size_t next;    /* the node behind all that is below this one */
    size_t first;   /* of a leaf: its triangles' places in the order */
    size_t count;   /* .. and how many; 0: there are two nodes below, */
    int axis;       /* cut across this axis, the lower one first */
    bool is_passed; /* rays are asked at the nodes below it instead */
};

struct mesh_hierarchy {
    size_t node_count;
    struct mesh_node *nodes;
    size_t *order; /* the triangles' numbers, as the leaves have them */
};

/* Of so many triangles, at least one. */
size_t mesh_hierarchy_nodes(size_t triangles);
/* Their places may be told on any scale.  False: no memory. */
bool mesh_hierarchy_build(const struct boxed *triangles, size_t count,
                          struct mesh_hierarchy *hierarchy);
void mesh_hierarchy_free(struct mesh_hierarchy *hierarchy);

#endif
