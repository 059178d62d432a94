/* tree_value.h - evaluates a Boolean tree at a point by its definition. */
#ifndef TREE_VALUE_H
#define TREE_VALUE_H

#include "rt/scene/scene.h"

/* Returns a node's value. `inside`: whether the point is in each primitive. */
static inline bool tree_value(const struct scene *scene, size_t node,
                              const bool *inside)
{
    const struct tree_node *tree = &scene->nodes[node];
    bool value = tree->operation == TREE_AND;
    if (tree->operation == TREE_LEAF)
        return inside[tree->primitive];
    for (size_t child = node + 1; child < tree->next;
         child = scene->nodes[child].next) {
        bool other = tree_value(scene, child, inside);

        value = tree->operation == TREE_AND  ? value && other
                : tree->operation == TREE_OR ? value || other
                                             : !other;
    }
    return value;
}

#endif
