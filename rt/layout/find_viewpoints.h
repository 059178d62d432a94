/* find_viewpoints.h - the points of a scene that many rays go through. */
#ifndef RT_LAYOUT_FIND_VIEWPOINTS_H
#define RT_LAYOUT_FIND_VIEWPOINTS_H

#include "rt/scene/scene.h"
#include "rt/shapes/viewpoints.h"

/* Where the camera is, if its rays start at one point, then the lights that cast
 * shadows from one, as far as there is room. */
void viewpoints_find(const struct scene *scene, struct viewpoints *viewpoints);

#endif
