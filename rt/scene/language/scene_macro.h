/* scene_macro.h - #macro, and calls of macros.
 *
 * The body of a macro is read at its call, in place of the call. A local level of names
 * has its parameters. An argument that is only a name or an element is passed by
 * reference, every other one by value.
 */
#ifndef RT_SCENE_MACRO_H
#define RT_SCENE_MACRO_H

#include "rt/scene/language/scene_block.h"

item_reader macro_define;
/* Calls the macro that the current token names; its body is read next. */
bool macro_call(struct reader *reader);

#endif
