/* condition.h - #ifdef, #ifndef, #else and #end.
 *
 * A name is defined when the scene has declared it; so are the words that this
 * language has and POV-Ray's has not.  Words of POV-Ray's own are not, as
 * there.
 */
#ifndef RT_SCENE_CONDITION_H
#define RT_SCENE_CONDITION_H

#include "rt/scene/block.h"

enum { CONDITION_WHEN_DEFINED, CONDITION_UNLESS_DEFINED };

item_reader condition_read; /* #ifdef, #ifndef */
item_reader condition_else;
item_reader condition_end;
/* Of other directives that an #end closes: an error; what they hold is not
 * read. */
item_reader condition_unsupported;
/* At the end of the scene: those still open are errors. */
void conditions_close(struct reader *reader);

#endif
