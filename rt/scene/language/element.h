/* element.h - arrays in the text, and their elements. */
#ifndef RT_SCENE_ELEMENT_H
#define RT_SCENE_ELEMENT_H

#include "rt/scene/language/reader.h"

/* The token is the name of an array: with the indices that follow, if any do,
 * it becomes the name of an element, and is looked up. */
bool element_read(struct reader *reader);
/* The same for an element that need not be set. */
bool element_read_place(struct reader *reader);
/* An array as a value; the token is its word. */
bool array_read(struct reader *reader, struct scene_value *value);

#endif
