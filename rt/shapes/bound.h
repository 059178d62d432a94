/* bound.h - a sphere and a box that nothing of a shape reaches beyond.
 *
 * A bound only spares work: a ray that misses it would miss the shape.  So it
 * is made larger than what the machine's roundings could need.
 */
#ifndef RT_BOUND_H
#define RT_BOUND_H

#include "rt/shapes/primitive.h"

/* The radius of what has no bound: beyond every scene, as k_big. */
#define BOUND_NONE 1e30

struct bound {
    double center[3], radius;
    double low[3], high[3]; /* of the box, along the world's axes */
};

extern const struct bound bound_none;
bool bound_is_none(const struct bound *bound);

/* How far a point is from the farthest of a bound. */
double bound_reach(const struct bound *bound, const double from[3]);
/* About others: a sphere little greater than the least, and the least box. */
void bound_enclose(const struct bound *parts, size_t count, struct bound *whole);
/* What lies within all of them: the least of the spheres, and what the boxes have
 * in common. */
void bound_common(const struct bound *parts, size_t count, struct bound *whole);
/* A primitive in the world.  Planes, quadrics and quartics have none. */
void bound_primitive(const struct primitive *primitive, struct bound *bound);

/* ---- For the descriptors of shapes --------------------------------------- */

/* Points whose hull a shape does not leave, in the world. */
enum { RING = 16, MAX_HULL = 2 * RING };
struct hull {
    size_t count;
    struct bound points[MAX_HULL];
};

/* A point of the primitive's own space. */
void hull_point(struct hull *hull, const struct primitive *primitive,
                const double point[3]);
/* Points about a circle: RING of them, a little farther out. */
void hull_ring(struct hull *hull, const struct primitive *primitive,
               const double center[3], const double axis[3], double radius);
/* Circles about both ends of an axis. */
void hull_rings(struct hull *hull, const struct primitive *primitive,
                const double base[3], double base_radius, const double cap[3],
                double cap_radius);
void bound_hull(const struct hull *hull, struct bound *bound);
/* .. the box alone. */
void bound_hull_box(const struct hull *hull, struct bound *bound);
/* The box about others. */
void bound_box(const struct bound *parts, size_t count, struct bound *whole);

/* How much the way to the world stretches a vector at most, of those with
 * components at most as long as the weights are. */
double bound_stretch(const struct primitive *primitive, double x, double y, double z);
/* About a point of the primitive's own space, so far in the world. */
void bound_about(const struct primitive *primitive, const double center[3],
                 double reach, struct bound *bound);

/* Of a shape that has none. */
void bound_without(const struct primitive *primitive, struct bound *bound);

#endif
