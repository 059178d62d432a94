/* scene_unit.h - chooses the unit of length in which a scene is traced, and scales the
 * scene. */
#ifndef RT_SCENE_UNIT_H
#define RT_SCENE_UNIT_H

#include "rt/scene/language/scene_object.h"

/* Sets scene->unit_log from the sizes and distances of the world's objects, and divides
 * all lengths of the world and of the scene by this unit. Lights that are farther than
 * LIGHT_FARTHEST from the objects are then moved to this distance; their directions and
 * shadows change only by rounding. Returns false if the sizes are outside of 1e-60 to
 * 1e60. */
bool unit_choose(struct scene *scene, struct scene_object *world);

#endif
