#include "rt/layout/bounds.h"

#include <math.h>
#include <stdlib.h>

/* The bounds of a node's children, one after another; how many. */
static size_t gather(const struct scene *scene, size_t node,
                     const struct bound *bounds, struct bound *children)
{
    size_t count = 0;

    for (size_t child = node + 1; child < scene->nodes[node].next;
         child = scene->nodes[child].next)
        children[count++] = bounds[child];
    return count;
}

/* The least of the spheres, and what the boxes have in common. */
static struct bound common_of(const struct bound *children, size_t count)
{
    struct bound least = bound_none;

    for (size_t i = 0; i < count; i++)
        if (children[i].radius < least.radius)
            least = children[i];
    for (size_t i = 0; i < count; i++)
        for (int axis = 0; axis < 3; axis++) {
            least.low[axis] = fmax(least.low[axis], children[i].low[axis]);
            least.high[axis] = fmin(least.high[axis], children[i].high[axis]);
        }
    return least;
}

static void bound_node(const struct scene *scene, size_t node,
                       struct bound *bounds, struct bound *children)
{
    size_t count = gather(scene, node, bounds, children);

    switch (scene->nodes[node].operation) {
    case TREE_LEAF:
        bound_primitive(&scene->primitives[scene->nodes[node].primitive],
                        &bounds[node]);
        break;
    case TREE_AND: bounds[node] = common_of(children, count); break;
    case TREE_OR: bound_enclose(children, count, &bounds[node]); break;
    case TREE_NOT: bounds[node] = bound_none; break;
    }
}

/* Backwards, so that what is below a node comes before it. */
bool bound_nodes(const struct scene *scene, struct bound *bounds)
{
    struct bound *children = malloc((scene->node_count + 1)
                                    * sizeof *children);

    if (!children)
        return false;
    for (size_t node = scene->node_count; node-- > 0;)
        bound_node(scene, node, bounds, children);
    free(children);
    return true;
}
