/* mesh_hierarchy.h - a bounding volume hierarchy over the triangles of a mesh.
 *
 * The host builds the hierarchy and traces no rays. The nodes are in preorder: the
 * first child directly follows its parent, and the second child is the first child's
 * `next`. All leaves except the last have TRIANGLES_IN_LEAF triangles, so the number of
 * nodes is known in advance.
 */
#ifndef RT_MESH_HIERARCHY_H
#define RT_MESH_HIERARCHY_H

#include <stdbool.h>

#include "rt/bvh/cuts.h"

enum { TRIANGLES_IN_LEAF = 2 };

struct mesh_node {
    struct box box;
    size_t next;    /* the first node after this node's subtree */
    size_t first;   /* leaf: position of its first triangle in the order */
    size_t count;   /* leaf: number of triangles; 0: an inner node */
    int axis;       /* inner node: the axis of the split; the first child is the lower
                     * one */
    bool is_passed; /* rays test the children instead of this node */
};

struct mesh_hierarchy {
    size_t node_count;
    struct mesh_node *nodes;
    size_t *order; /* indices of the triangles, in the order of the leaves */
};

/* Returns the number of nodes of a hierarchy over this many triangles, at least one. */
size_t mesh_hierarchy_nodes(size_t triangles);
/* Builds a hierarchy. All members `place` of the triangles may be scaled by a common
 * factor. Returns false if out of memory. */
bool mesh_hierarchy_build(const struct boxed *triangles, size_t count,
                          struct mesh_hierarchy *hierarchy);
void mesh_hierarchy_free(struct mesh_hierarchy *hierarchy);

/* Flags for the rays of a viewpoint at a node. */
enum mesh_way {
    MESH_UPPER_FIRST = 1, /* the second child comes first */
    MESH_PASSED = 2,      /* the children are tested instead of the node */
};

/* A table of one row per node, after a row of zeros. A node is identified by the offset
 * of its row in words. Offset 0 ends the traversal. */
struct mesh_rows {
    double *links; /* address of the two adjacent links of the first node */
    size_t size;   /* words of a row */
};
/* A number that marks leaves. It is greater than the offset of any row. */
#define MESH_LEAF_HIT 0x1p40

/* Stores two links for each node, for a traversal without a stack. Rays that hit the
 * node's bound continue at the first link, rays that miss it at the second. Both links
 * of a leaf lead to the same node; MESH_LEAF_HIT is added to the first one, to mark the
 * leaf. */
void mesh_hierarchy_thread(const struct mesh_hierarchy *hierarchy,
                           const unsigned char *orders, const struct mesh_rows *rows);

#endif
