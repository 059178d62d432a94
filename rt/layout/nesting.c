/* nesting.c - groups the parts of large CSG trees into nested nodes, along a bounding
 * volume hierarchy. */
#include "rt/layout/nesting.h"

#include <stdlib.h>
#include <string.h>

#include "rt/layout/bounds.h"
#include "rt/bvh/hierarchy.h"

enum { MANY = 8 }; /* smaller lists are not grouped */

/* The state of the grouping: the original scene, and the nested scene that is built. */
struct nesting {
    const struct scene *scene;
    const struct bound *bounds; /* bounds of the scene's nodes */
    struct nested_scene *nested;
    bool failed; /* out of memory */
};

/* The children of a node that can be grouped. */
struct part_list {
    size_t count;
    size_t *nodes;
    struct bound whole; /* a bound around all parts */
    struct hierarchy hierarchy;
};

static void nest_node(struct nesting *nesting, size_t node);

static size_t open_node(struct nesting *nesting, enum tree_operation operation,
                        const struct bound *bound)
{
    struct scene *nested = &nesting->nested->scene;
    size_t node = nested->node_count++;
    nested->nodes[node] = (struct tree_node){ .operation = operation };
    nesting->nested->bounds[node] = *bound;
    return node;
}

static void close_node(struct nesting *nesting, size_t node)
{
    struct scene *nested = &nesting->nested->scene;
    nested->nodes[node].next = nested->node_count;
}

/* ---- Parts --------------------------------------------------------------- */

/* Returns the solid that `child` adds to a union, or that `child` subtracts as a
 * complement from an intersection. Returns 0 for any other child, and for an unbounded
 * solid. */
static size_t part_of(const struct nesting *nesting, size_t parent, size_t child)
{
    const struct tree_node *nodes = nesting->scene->nodes;
    size_t part = nodes[parent].operation == TREE_OR ? child
                  : nodes[parent].operation == TREE_AND
                          && nodes[child].operation == TREE_NOT
                      ? child + 1
                      : 0;
    return part > 0 && !bound_is_none(&nesting->bounds[part]) ? part : 0;
}

static size_t count_parts(const struct nesting *nesting, size_t node)
{
    const struct tree_node *nodes = nesting->scene->nodes;
    size_t count = 0;
    for (size_t child = node + 1; child < nodes[node].next; child = nodes[child].next)
        count += part_of(nesting, node, child) > 0;
    return count;
}

static bool plan_parts(const struct nesting *nesting, size_t node,
                       struct part_list *parts)
{
    const struct tree_node *nodes = nesting->scene->nodes;
    struct bound *bounds = malloc(parts->count * sizeof *bounds);
    size_t count = 0;
    bool good;
    parts->nodes = malloc(parts->count * sizeof *parts->nodes);
    good = bounds && parts->nodes;
    for (size_t child = node + 1; good && child < nodes[node].next;
         child = nodes[child].next) {
        size_t part = part_of(nesting, node, child);

        if (part > 0) {
            bounds[count] = nesting->bounds[part];
            parts->nodes[count++] = part;
        }
    }
    if (good)
        bound_enclose(bounds, count, &parts->whole);
    good = good && hierarchy_build(bounds, count, &parts->hierarchy);
    free(bounds);
    return good;
}

static void put_some(struct nesting *nesting, const struct part_list *parts,
                     size_t first, size_t count)
{
    for (size_t i = 0; i < count; i++)
        nest_node(nesting, parts->nodes[parts->hierarchy.order[first + i]]);
}

/* Writes the parts below a node of the hierarchy as children of the CSG node that was
 * opened last. */
static void put_below(struct nesting *nesting, const struct part_list *parts,
                      size_t number);

/* Writes the parts below a node of the hierarchy as one child of the CSG node that was
 * opened last: a union, or the part itself if there is only one. */
static void put_group(struct nesting *nesting, const struct part_list *parts,
                      size_t number)
{
    if (parts->hierarchy.nodes[number].count == 1) {
        put_below(nesting, parts, number);
    } else {
        size_t whole = open_node(nesting, TREE_OR,
                                 &parts->hierarchy.nodes[number].bound);
        put_below(nesting, parts, number);
        close_node(nesting, whole);
    }
}

static void put_below(struct nesting *nesting, const struct part_list *parts,
                      size_t number)
{
    const struct hierarchy_node *nodes = parts->hierarchy.nodes;
    if (nodes[number].count > 0) {
        put_some(nesting, parts, nodes[number].first, nodes[number].count);
    } else {
        put_group(nesting, parts, number + 1);
        put_group(nesting, parts, nodes[number + 1].next);
    }
}

static void put_all(struct nesting *nesting, const struct part_list *parts)
{
    if (parts->hierarchy.node_count > 0)
        put_below(nesting, parts, 0);
    else
        put_some(nesting, parts, 0, parts->count);
}

/* Writes the `count` parts of a node, grouped by the hierarchy. In a union, the groups
 * become children of the node. In a difference, the subtracted solids become the
 * complement of one union of groups. */
static void nest_parts(struct nesting *nesting, size_t node, size_t count)
{
    struct part_list parts = { .count = count };
    size_t complement, whole;
    if (!plan_parts(nesting, node, &parts)) {
        nesting->failed = true;
    } else if (nesting->scene->nodes[node].operation == TREE_OR) {
        put_all(nesting, &parts);
    } else {
        complement = open_node(nesting, TREE_NOT, &bound_none);
        whole = open_node(nesting, TREE_OR, &parts.whole);
        put_all(nesting, &parts);
        close_node(nesting, whole);
        close_node(nesting, complement);
    }
    free(parts.nodes);
    hierarchy_free(&parts.hierarchy);
}

/* ---- Nodes --------------------------------------------------------------- */

static void nest_node(struct nesting *nesting, size_t node)
{
    const struct tree_node *nodes = nesting->scene->nodes;
    size_t nested = open_node(nesting, nodes[node].operation, &nesting->bounds[node]);
    size_t count = count_parts(nesting, node);
    nesting->nested->scene.nodes[nested].primitive = nodes[node].primitive;
    for (size_t child = node + 1; child < nodes[node].next; child = nodes[child].next)
        if (count < MANY || part_of(nesting, node, child) == 0)
            nest_node(nesting, child);
    if (count >= MANY)
        nest_parts(nesting, node, count);
    close_node(nesting, nested);
}

/* ---- The whole scene ----------------------------------------------------- */

static void nest_regions(struct nesting *nesting)
{
    struct scene *nested = &nesting->nested->scene;
    nested->node_count = 0;
    for (size_t i = 0; i < nested->region_count; i++) {
        size_t root = nested->regions[i].first_node;
        nested->regions[i].first_node = nested->node_count;
        nest_node(nesting, root);
        nested->regions[i].node_count = nested->node_count
                                        - nested->regions[i].first_node;
    }
}

/* Allocates the nested scene. The groups of n parts are at most n - 1 nodes, and the
 * complement and the union around them are two nodes. */
static bool take_room(const struct scene *scene, struct nested_scene *nested)
{
    size_t nodes = 3 * scene->node_count + 1, regions = scene->region_count;
    nested->scene = *scene;
    nested->scene.nodes = malloc(nodes * sizeof *nested->scene.nodes);
    nested->scene.regions = malloc((regions + 1) * sizeof *nested->scene.regions);
    nested->bounds = malloc(nodes * sizeof *nested->bounds);
    if (nested->scene.regions && regions > 0)
        memcpy(nested->scene.regions, scene->regions, regions * sizeof *scene->regions);
    return nested->scene.nodes && nested->scene.regions && nested->bounds;
}

bool nesting_make(const struct scene *scene, struct nested_scene *nested)
{
    struct bound *bounds = malloc((scene->node_count + 1) * sizeof *bounds);
    struct nesting nesting = { .scene = scene, .bounds = bounds, .nested = nested };
    bool good = take_room(scene, nested) && bounds && bound_nodes(scene, bounds);
    if (good)
        nest_regions(&nesting);
    free(bounds);
    return good && !nesting.failed;
}

void nesting_free(struct nested_scene *nested)
{
    free(nested->scene.nodes);
    free(nested->scene.regions);
    free(nested->bounds);
}
