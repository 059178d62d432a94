/* polygon.h - flat outlines, which become meshes. */
#ifndef RT_SCENE_POLYGON_H
#define RT_SCENE_POLYGON_H

#include "rt/scene/language/object.h"
#include "rt/scene/language/reader.h"

/* The arguments of polygon, behind its '{'.  One of which POV-Ray shows nothing
 * is no part of the object. */
bool polygon_read(struct reader *reader, struct scene_object *object,
                  const struct scene_token *at);

#endif
