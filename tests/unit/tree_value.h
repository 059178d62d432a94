/* tree_value.h - evaluates a Boolean tree at a point by its definition. */
#ifndef TREE_VALUE_H
#define TREE_VALUE_H

#include "rt/scene/scene.h"

/* Returns the value of a node, given whether the point is inside each primitive of the
 * scene. */
bool tree_value(const struct scene *scene, size_t node, const bool *inside);

#endif
