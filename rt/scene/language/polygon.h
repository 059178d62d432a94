/* polygon.h - flat outlines, which become meshes. */
#ifndef RT_SCENE_POLYGON_H
#define RT_SCENE_POLYGON_H

#include "rt/scene/language/scene_object.h"
#include "rt/scene/language/reader.h"

/* Reads the arguments of polygon, after its '{'. A polygon that is invisible in POV-Ray
 * is not added to the object. */
bool polygon_read(struct reader *reader, struct scene_object *object,
                  const struct scene_token *at);

#endif
