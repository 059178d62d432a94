/* part.h - the statement that names a part and sets its physical values.
 *
 *   part { "NAME" density F emissivity F temperature F }
 *
 * in an object names that part of it for masses and heat, and sets its values, like
 * floats NAME_Density and so on (rt/scene/named_values.h). POV-Ray has no such word:
 * `#ifdef (part)` distinguishes the two programs.
 */
#ifndef RT_SCENE_PART_H
#define RT_SCENE_PART_H

#include "rt/scene/language/scene_statement.h"

/* A word that modifies an object, the subject. */
item_reader part_read;

#endif
