/* mesh_hierarchy.h - a bounding volume hierarchy over the triangles of a mesh.
 *
 * The host builds it, but traces no rays. The nodes are in preorder: the first child
 * follows its parent, and the second child is the first child's `next`. All leaves but
 * the last have TRIANGLES_IN_LEAF triangles, so the number of nodes is known in
 * advance.
 */
#ifndef RT_MESH_HIERARCHY_H
#define RT_MESH_HIERARCHY_H

#include <stdbool.h>

#include "rt/bvh/cuts.h"

enum { TRIANGLES_IN_LEAF = 2 };

struct mesh_node {
    struct box box;
    size_t next;    /* index of the first node after this subtree */
    size_t first;   /* of a leaf: offset of its triangles in the order */
    size_t count;   /* number of its triangles; 0: an inner node */
    int axis;       /* of an inner node: the split axis; the first child is the lower
                     * one */
    bool is_passed; /* the node is not tested: rays test its children instead */
};

struct mesh_hierarchy {
    size_t node_count;
    struct mesh_node *nodes;
    size_t *order; /* indices of the triangles, in the order of the leaves */
};

/* Returns the number of nodes. There must be at least one triangle. */
size_t mesh_hierarchy_nodes(size_t triangles);
/* Builds a hierarchy. The points of the triangles may have any scale. Fails without
 * memory. */
bool mesh_hierarchy_build(const struct boxed *triangles, size_t count,
                          struct mesh_hierarchy *hierarchy);
void mesh_hierarchy_free(struct mesh_hierarchy *hierarchy);

/* How rays of one kind traverse a node. */
enum mesh_way {
    MESH_UPPER_FIRST = 1, /* the second child comes first */
    MESH_PASSED = 2,      /* the node is not tested: its children are */
};

/* A table of rows after one row of zeros. A node is identified by the offset of its row
 * in words; 0 is the end of the traversal. */
struct mesh_rows {
    double *links; /* the two links of the first node, which are adjacent */
    size_t size;   /* words of a row */
};
/* An offset that is greater than that of any row. */
#define MESH_LEAF_HIT 0x1p40

/* Stores the links of each node for a traversal without a stack: the next node of rays
 * that hit its bound, and of rays that miss it. After a leaf both continue at the same
 * node; the link of the hit is greater by MESH_LEAF_HIT, which marks the leaf. */
void mesh_hierarchy_thread(const struct mesh_hierarchy *hierarchy,
                           const unsigned char *orders, const struct mesh_rows *rows);

#endif
