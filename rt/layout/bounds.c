/* bounds.c - computes bounding spheres and boxes for the nodes of trees. */
#include "rt/layout/bounds.h"

#include <math.h>
#include <stdlib.h>

#include "rt/shapes/shape.h"

/* Copies the bounds of a node's children in order. Returns their number. */
static size_t gather(const struct scene *scene, size_t node, const struct bound *bounds,
                     struct bound *children)
{
    size_t count = 0;
    for (size_t child = node + 1; child < scene->nodes[node].next;
         child = scene->nodes[child].next)
        children[count++] = bounds[child];
    return count;
}

/* Computes the bound of a primitive. An endless shape has no bound in a tree;
 * bound_alone bounds its visible part if it is a region by itself. */
static void bound_leaf(const struct primitive *primitive, struct bound *bound)
{
    if (shape_of(primitive)->endless)
        *bound = bound_none;
    else
        bound_primitive(primitive, bound);
}

static void bound_alone(const struct scene *scene, const struct region *region,
                        struct bound *bounds)
{
    if (region->primitive_count == 1)
        bound_primitive(&scene->primitives[region->first_primitive],
                        &bounds[region->first_node + region->node_count - 1]);
}

static void bound_node(const struct scene *scene, size_t node, struct bound *bounds,
                       struct bound *children)
{
    size_t count = gather(scene, node, bounds, children);
    switch (scene->nodes[node].operation) {
    case TREE_LEAF:
        bound_leaf(&scene->primitives[scene->nodes[node].primitive], &bounds[node]);
        break;
    case TREE_AND: bound_common(children, count, &bounds[node]); break;
    case TREE_OR: bound_enclose(children, count, &bounds[node]); break;
    case TREE_NOT: bounds[node] = bound_none; break;
    }
}

/* The loop runs backwards, because the bound of a node depends on the bounds of its
 * children, which come after it. */
bool bound_nodes(const struct scene *scene, struct bound *bounds)
{
    struct bound *children = malloc((scene->node_count + 1) * sizeof *children);
    if (!children)
        return false;
    for (size_t node = scene->node_count; node-- > 0;)
        bound_node(scene, node, bounds, children);
    for (size_t i = 0; i < scene->region_count; i++)
        bound_alone(scene, &scene->regions[i], bounds);
    free(children);
    return true;
}
