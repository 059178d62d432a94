/* bodies.h - a scene with some of its regions alone. */
#ifndef RT_MASS_BODIES_H
#define RT_MASS_BODIES_H

#include "rt/scene/scene_internal.h"

/* Parts that reach for ever, or have no bound that is known, are marked endless.
 * False: no memory. */
bool bodies_find_endless(const struct scene *scene, struct named_parts *parts);
/* The regions of parts that are not left out; what primitives point to is the scene's, which
 * must outlive it.  Objects keep their numbers.  False: no memory. */
bool bodies_take(const struct scene *scene, const struct named_parts *parts,
                 struct scene *bodies);
void bodies_free(struct scene *bodies);

#endif
