/* height_field.h - fields of heights, which become meshes. */
#ifndef RT_SCENE_HEIGHT_FIELD_H
#define RT_SCENE_HEIGHT_FIELD_H

#include "rt/scene/language/object.h"
#include "rt/scene/language/reader.h"

/* The arguments of height_field, behind its '{'.  One that lies below its water
 * level is no part of the object. */
bool height_field_read(struct reader *reader, struct scene_object *object,
                       const struct scene_token *at);
/* The part, which is a smooth field, has come to its place in the world: there
 * its normals get the length one.  No transform is left. */
bool height_field_place(struct reader *reader, struct scene_part *part);

#endif
