/* clip.h - what an object is cut by, and what it lies within.
 *
 *   clipped_by { OBJECT ... }    bounded_by { OBJECT ... }
 *
 * Of a clipped object that is left which lies inside of all objects that clip it,
 * and these are not seen.  A bound is what POV-Ray looks at before it looks at the
 * object; it changes what is seen if the object is made of others and reaches
 * beyond it.
 */
#ifndef RT_SCENE_CLIP_H
#define RT_SCENE_CLIP_H

#include "rt/scene/language/statement.h"

/* Both are words that change an object, the subject. */
item_reader clipped_by_read;
item_reader bounded_by_read;

#endif
