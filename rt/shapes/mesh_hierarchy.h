/* mesh_hierarchy.h - a hierarchy of boxes over the triangles of a mesh.
 *
 * The host plans it, and traces nothing.  Nodes are in preorder: of two nodes
 * below another the first is behind it, and the second where the first
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

/* How rays of one sort go through it, node by node. */
enum mesh_way {
    MESH_UPPER_FIRST = 1, /* they come to the second of the two below first */
    MESH_PASSED = 2,      /* they are asked at the nodes below instead */
};

/* Rows of some words, behind one of zeros, in which a node is told by how many words
 * are before its row, and 0 is the end. */
struct mesh_rows {
    double *links; /* of the first node; they are beside one another */
    size_t size;   /* words of a row */
};
/* More than where any row stands. */
#define MESH_MET 0x1p40

/* Where such rays go on, from each node: those that come near it, and the others; so
 * there is no stack.  Near a leaf they continue as the others do, and the link is greater
 * by MESH_MET. */
void mesh_hierarchy_thread(const struct mesh_hierarchy *hierarchy,
                           const unsigned char *ways, const struct mesh_rows *rows);

#endif
