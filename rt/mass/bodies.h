/* bodies.h - copies some of the regions of a scene into a new scene. */
#ifndef RT_MASS_BODIES_H
#define RT_MASS_BODIES_H

#include "rt/scene/named_parts.h"

/* Marks the parts that are infinite, or whose bound is unknown, as endless. Returns
 * false if out of memory. */
bool bodies_find_endless(const struct scene *scene, struct named_parts *parts);
/* Makes a scene of the regions of the selected parts. It shares the data that
 * primitives point to with the original scene, which must outlive it. Objects keep
 * their numbers. Returns false if out of memory. */
bool bodies_take(const struct scene *scene, const struct named_parts *parts,
                 struct scene *bodies);
void bodies_free(struct scene *bodies);

#endif
