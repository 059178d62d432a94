/* part.h - what a part is called, and what it is made of.
 *
 *   part { "NAME" density F emissivity F temperature F }
 *
 * in an object: that part of it is called so from there on, by masses and by heat, and these
 * are its values, as if they were floats NAME_Density and so on (rt/scene/named_values.h).
 * POV-Ray has no such word: `#ifdef (part)` tells who reads.
 */
#ifndef RT_SCENE_PART_H
#define RT_SCENE_PART_H

#include "rt/scene/language/statement.h"

/* A word that changes an object, the subject. */
item_reader part_read;

#endif
