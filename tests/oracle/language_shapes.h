/* language_shapes.h - shapes by chance: each opens its block and leaves it
 * open, for modifiers. */
#ifndef LANGUAGE_SHAPES_H
#define LANGUAGE_SHAPES_H

#include "tests/oracle/language_parts.h"

/* About the origin, no larger than a ball of 1.3 about it. */
/* closed: with an inside, and no way in. */
void open_solid_shape(struct language *draw, bool closed);
/* One that has no inside, but a look of its own in some parts. */
void open_sheet(struct language *draw);
/* What has no end, or not in all directions; for cutting. */
void open_endless(struct language *draw);

#endif
