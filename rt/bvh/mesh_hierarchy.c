/* mesh_hierarchy.c - builds the bounding volume hierarchy of a mesh. */
#include "rt/bvh/mesh_hierarchy.h"

#include <math.h>
#include <stdlib.h>

/* From this depth on, lists are halved, which bounds the recursion. */
enum { HALVED_FROM = 64 };

struct mesh_build {
    struct cutting cutting;
    struct mesh_hierarchy *hierarchy;
};

/* Returns half of the surface area of a box. The number of rays that hit the box is
 * proportional to the area. */
static double surface_of(const struct box *box)
{
    double x = box->high[0] - box->low[0], y = box->high[1] - box->low[1],
           z = box->high[2] - box->low[2];
    return x * y + y * z + z * x;
}

/* Returns the cost of a part by the surface-area heuristic: its number of triangles
 * times half its surface area. The cost is proportional to the expected number of
 * tests. */
static double part_cost(const struct cut_part *part, const struct box *whole)
{
    (void)whole;
    return (double)part->count * surface_of(&part->box);
}

/* ---- Splits -------------------------------------------------------------- */

/* Moves the triangle of the upper part that is lowest along the axis to the lower
 * part. */
static void lift(const struct boxed *things, size_t *row, size_t count, size_t lower,
                 int axis)
{
    size_t least = lower, kept;
    for (size_t i = lower; i < count; i++)
        if (things[row[i]].place[axis] < things[row[least]].place[axis])
            least = i;
    kept = row[least];
    row[least] = row[lower];
    row[lower] = kept;
}

/* Splits a list near a cut, so that all leaves of the lower part are full. */
static size_t cut_leaves(const struct cutting *cutting, size_t *row, size_t count,
                         const struct cut *cut)
{
    size_t lower = cut_row(cutting, row, count, cut);
    while (lower % TRIANGLES_IN_LEAF != 0 && lower + 1 < count)
        lift(cutting->things, row, count, lower++, cut->axis);
    return lower - lower % TRIANGLES_IN_LEAF;
}

static size_t half_of(size_t count)
{
    size_t leaves = (count + TRIANGLES_IN_LEAF - 1) / TRIANGLES_IN_LEAF;
    return leaves / 2 * TRIANGLES_IN_LEAF;
}

/* ---- Nodes --------------------------------------------------------------- */

/* Splits the triangles of a node into two parts. Returns the number of triangles in the
 * lower part, and sets node->axis. */
static size_t split(const struct mesh_build *build, size_t *row, size_t count,
                    size_t depth, struct mesh_node *node)
{
    struct cut cut = cut_find(&build->cutting, row, count, &node->box, INFINITY);
    size_t lower = 0;
    if (cut.axis >= 0 && depth < HALVED_FROM)
        lower = cut_leaves(&build->cutting, row, count, &cut);
    node->axis = lower > 0 ? cut.axis : 0;
    return lower > 0 ? lower : half_of(count);
}

/* Builds the subtree of the triangles first .. first + count - 1 of the order. */
static void build_node(const struct mesh_build *build, size_t first, size_t count,
                       size_t depth)
{
    struct mesh_hierarchy *hierarchy = build->hierarchy;
    size_t *row = hierarchy->order + first, lower;
    struct mesh_node *node = &hierarchy->nodes[hierarchy->node_count++];
    node->box = box_about(build->cutting.things, row, count);
    node->first = first;
    node->count = count;
    node->axis = 0;
    if (count > TRIANGLES_IN_LEAF) {
        lower = split(build, row, count, depth, node);
        node->count = 0;
        build_node(build, first, lower, depth + 1);
        build_node(build, first + lower, count - lower, depth + 1);
    }
    node->next = hierarchy->node_count;
}

/* ---- Tests --------------------------------------------------------------- */

/* Selects the nodes that are tested. If a ray misses a node, the test of the node saves
 * the tests of its two children. The test is worthwhile only if more than half of the
 * rays that hit the nearest tested ancestor miss the node. The root is always
 * tested. */
static void plan_tests(struct mesh_node *nodes, size_t number, double above)
{
    struct mesh_node *node = &nodes[number];
    bool is_leaf = node->count > 0;
    double surface = surface_of(&node->box);
    node->is_passed = !is_leaf && number > 0 && surface > above / 2;
    if (is_leaf)
        return;
    surface = node->is_passed ? above : surface;
    plan_tests(nodes, number + 1, surface);
    plan_tests(nodes, nodes[number + 1].next, surface);
}

/* ---- Links --------------------------------------------------------------- */

struct threading {
    const struct mesh_node *nodes;
    const unsigned char *orders;
    const struct mesh_rows *rows;
};

static double place_of(const struct threading *threading, size_t node)
{
    return (double)(threading->rows->size * (node + 1));
}

static bool upper_first(const struct threading *threading, size_t node)
{
    return threading->orders[node] & MESH_UPPER_FIRST;
}

/* Returns the first tested node at or below a node, in the order of traversal. */
static size_t first_asked(const struct threading *threading, size_t node)
{
    while (threading->orders[node] & MESH_PASSED)
        node = upper_first(threading, node) ? threading->nodes[node + 1].next
                                            : node + 1;
    return node;
}

/* Stores the links of a subtree; rays that miss its root continue at `miss`. */
static void put_links(const struct threading *threading, size_t node, double miss)
{
    const struct mesh_node *nodes = threading->nodes;
    double *links = threading->rows->links + threading->rows->size * node;
    size_t near = node + 1, far = nodes[node + 1].next;
    double to_far;
    links[1] = miss;
    if (nodes[node].count > 0) {
        links[0] = miss + MESH_LEAF_HIT;
        return;
    }
    if (upper_first(threading, node)) {
        near = far;
        far = node + 1;
    }
    links[0] = place_of(threading, first_asked(threading, near));
    to_far = place_of(threading, first_asked(threading, far));
    put_links(threading, near, to_far);
    put_links(threading, far, miss);
}

void mesh_hierarchy_thread(const struct mesh_hierarchy *hierarchy,
                           const unsigned char *orders, const struct mesh_rows *rows)
{
    struct threading threading = { hierarchy->nodes, orders, rows };
    put_links(&threading, 0, 0);
}

/* ---- Interface ----------------------------------------------------------- */

size_t mesh_hierarchy_nodes(size_t triangles)
{
    return 2 * ((triangles + TRIANGLES_IN_LEAF - 1) / TRIANGLES_IN_LEAF) - 1;
}

bool mesh_hierarchy_build(const struct boxed *triangles, size_t count,
                          struct mesh_hierarchy *hierarchy)
{
    size_t *other = malloc((count + 1) * sizeof *other);
    struct mesh_build build = { { triangles, part_cost, other }, hierarchy };
    size_t nodes = mesh_hierarchy_nodes(count) + 1;
    bool good;
    hierarchy->node_count = 0;
    hierarchy->nodes = malloc(nodes * sizeof *hierarchy->nodes);
    hierarchy->order = malloc((count + 1) * sizeof *hierarchy->order);
    good = other && hierarchy->nodes && hierarchy->order;
    for (size_t i = 0; good && i < count; i++)
        hierarchy->order[i] = i;
    if (good) {
        build_node(&build, 0, count, 1);
        plan_tests(hierarchy->nodes, 0, 0);
    }
    free(other);
    return good;
}

void mesh_hierarchy_free(struct mesh_hierarchy *hierarchy)
{
    free(hierarchy->nodes);
    free(hierarchy->order);
    *hierarchy = (struct mesh_hierarchy){ 0 };
}
