/* clip.h - clipping objects and bounds of objects.
 *
 *   clipped_by { OBJECT ... }    bounded_by { OBJECT ... }
 *
 * A clipped object keeps the part that is inside all its clipping objects, which are
 * not visible themselves. A bound is an object that POV-Ray tests before it tests the
 * bounded object. It changes the picture if the object is a compound and extends beyond
 * it.
 */
#ifndef RT_SCENE_CLIP_H
#define RT_SCENE_CLIP_H

#include "rt/scene/language/scene_statement.h"

/* Words that modify an object, the subject. */
item_reader clipped_by_read;
item_reader bounded_by_read;

#endif
