/* field_body.h - what lies below a field of heights. */
#ifndef RT_SCENE_FIELD_BODY_H
#define RT_SCENE_FIELD_BODY_H

#include "rt/scene/language/object.h"
#include "rt/scene/language/reader.h"

/* The fields of an object that becomes part of a solid, or is turned inside out,
 * get an inside. */
bool fields_fill(struct reader *reader, struct scene_object *object,
                 const struct scene_token *at);

#endif
