/* height_field.h - height fields, which become meshes. */
#ifndef RT_SCENE_HEIGHT_FIELD_H
#define RT_SCENE_HEIGHT_FIELD_H

#include "rt/scene/language/scene_object.h"
#include "rt/scene/language/reader.h"

/* Reads the arguments of height_field, after its '{'. A field below its water level is
 * not added to the object. */
bool height_field_read(struct reader *reader, struct scene_object *object,
                       const struct scene_token *at);
/* Finishes a smooth field once its place in the world is final: its normals are
 * normalised there. The part then has no transform left. */
bool height_field_place(struct reader *reader, struct scene_part *part);

#endif
