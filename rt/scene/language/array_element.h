/* array_element.h - arrays and their elements. */
#ifndef RT_SCENE_ELEMENT_H
#define RT_SCENE_ELEMENT_H

#include "rt/scene/language/reader.h"

/* The current token is the name of an array. Reads the indices after it, if any; the
 * token then refers to the element, and is looked up. */
bool element_read(struct reader *reader);
/* Like element_read, for an element that need not be set. */
bool element_read_place(struct reader *reader);
/* Reads the value of an array; the current token is its word. */
bool array_read(struct reader *reader, struct scene_value *value);

#endif
