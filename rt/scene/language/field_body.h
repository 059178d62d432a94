/* field_body.h - the body below a height field. */
#ifndef RT_SCENE_FIELD_BODY_H
#define RT_SCENE_FIELD_BODY_H

#include "rt/scene/language/scene_object.h"
#include "rt/scene/language/reader.h"

/* Adds an inside to the height fields of an object that becomes part of a solid or is
 * inverted. */
bool fields_fill(struct reader *reader, struct scene_object *object,
                 const struct scene_token *at);

#endif
