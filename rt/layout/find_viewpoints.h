/* find_viewpoints.h - finds the points of a scene through which many rays pass. */
#ifndef RT_LAYOUT_FIND_VIEWPOINTS_H
#define RT_LAYOUT_FIND_VIEWPOINTS_H

#include "rt/scene/scene.h"
#include "rt/bvh/viewpoints.h"

/* Collects up to MAX_VIEWPOINTS viewpoints. The first is the camera, if its rays start
 * at one point. The others are the lights that cast shadows from one point. */
void viewpoints_find(const struct scene *scene, struct viewpoints *viewpoints);

#endif
