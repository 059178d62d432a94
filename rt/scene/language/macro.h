/* macro.h - #macro, and calls of macros.
 *
 * A macro's body is read where it is called, as if it stood there; a local
 * level of names holds its parameters.  An argument that is nothing but a name
 * or an element is passed by reference, every other one by value.
 */
#ifndef RT_SCENE_MACRO_H
#define RT_SCENE_MACRO_H

#include "rt/scene/language/block.h"

item_reader macro_define;
/* The token is the name of a macro; its body comes next. */
bool macro_call(struct reader *reader);

#endif
