/* array_element.h - parses arrays and the indices of their elements. */
#ifndef RT_ARRAY_ELEMENT_H
#define RT_ARRAY_ELEMENT_H

#include "rt/scene/language/reader.h"

/* Reads the indices after the name of an array, which is the current token. Afterwards
 * the token refers to the element, and its value is looked up. */
bool element_read(struct reader *reader);
/* Like element_read, but the element need not have a value. */
bool element_read_place(struct reader *reader);
/* Reads the value of an array. The current token is the keyword `array`. */
bool array_read(struct reader *reader, struct scene_value *value);

#endif
