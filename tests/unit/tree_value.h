/* tree_value.h - what a Boolean tree says of a point, by its definition. */
#ifndef TREE_VALUE_H
#define TREE_VALUE_H

#include "rt/scene/scene.h"

/* The value of a node where the scene's primitives have these. */
bool tree_value(const struct scene *scene, size_t node, const bool *inside);

#endif
