/* bounds.h - spheres that nothing of a solid reaches beyond.
 *
 * A bound only spares work: a ray that misses it would miss the solid.  So it
 * is made larger than what the machine's roundings could need.
 */
#ifndef RT_BOUNDS_H
#define RT_BOUNDS_H

#include "rt/scene/scene.h"

/* The radius of what has no bound: beyond every scene, as k_big. */
#define BOUND_NONE 1e30

struct bound {
    double center[3], radius;
};

extern const struct bound bound_none;
bool bound_is_none(const struct bound *bound);

/* A sphere about others, little greater than the least. */
void bound_enclose(const struct bound *parts, size_t count,
                   struct bound *whole);
/* A primitive in the world.  Planes, quadrics and quartics have none. */
void bound_primitive(const struct primitive *primitive, struct bound *bound);
/* Each node of the scene's trees, in their order: an intersection has the
 * least of its children's bounds, a union one about them all, a complement
 * none.  False: no memory. */
bool bound_nodes(const struct scene *scene, struct bound *bounds);

#endif
