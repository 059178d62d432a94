/* shape_bound.h - computes bounding spheres and boxes of primitives. */
#ifndef RT_SHAPE_BOUND_H
#define RT_SHAPE_BOUND_H

#include "rt/bvh/bound.h"
#include "rt/shapes/primitive.h"

/* Bounds a primitive in world space, with a margin. Planes, quadrics and quartics are
 * unbounded. */
void bound_primitive(const struct primitive *primitive, struct bound *bound);

/* ---- For the descriptors of shapes --------------------------------------- */

/* Points in world space whose convex hull contains a shape. A circle has RING of
 * them. */
enum { RING = 16, MAX_HULL = 2 * RING };
struct hull {
    size_t count;
    struct bound points[MAX_HULL];
};

/* Adds a point of the primitive's own space, which is transformed to world space. */
void hull_point(struct hull *hull, const struct primitive *primitive,
                const double point[3]);
/* Adds RING points: the corners of a polygon around a circle. */
void hull_ring(struct hull *hull, const struct primitive *primitive,
               const double center[3], const double axis[3], double radius);
/* Adds polygons around the circles at both ends of an axis. */
void hull_rings(struct hull *hull, const struct primitive *primitive,
                const double base[3], double base_radius, const double cap[3],
                double cap_radius);
void bound_hull(const struct hull *hull, struct bound *bound);
/* Sets the box of the bound to the box around the hull, but leaves the sphere
 * unchanged. */
void bound_hull_box(const struct hull *hull, struct bound *bound);

/* Returns the greatest length, in world space, of a vector (x a, y b, z c), where (a,
 * b, c) is a unit vector. */
double bound_stretch(const struct primitive *primitive, double x, double y, double z);
/* Bounds a sphere. Its centre is in the primitive's own space, its radius `reach` in
 * world space. */
void bound_about(const struct primitive *primitive, const double center[3],
                 double reach, struct bound *bound);

/* Sets the bound of an unbounded shape. */
void bound_without(const struct primitive *primitive, struct bound *bound);

#endif
