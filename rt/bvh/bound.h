/* bound.h - bounding spheres and boxes, and bounds of bounds.
 *
 * A bound only saves work: a ray that misses it also misses its content.
 */
#ifndef RT_BOUND_H
#define RT_BOUND_H

#include <stdbool.h>
#include <stddef.h>

/* The radius of an unbounded shape. It equals k_big of the kernels, and exceeds the
 * size of every scene. */
#define BOUND_NONE 1e30

struct bound {
    double center[3], radius;
    double low[3], high[3]; /* the box, along the world axes */
};

extern const struct bound bound_none;
bool bound_is_none(const struct bound *bound);

/* Returns the distance of a point from the farthest point of the bounding sphere. */
double bound_reach(const struct bound *bound, const double from[3]);
/* Computes the minimal box around other bounds, and a sphere that is slightly larger
 * than the minimum. */
void bound_enclose(const struct bound *parts, size_t count, struct bound *whole);
/* Computes a bound of the intersection of other bounds: the smallest of their spheres,
 * and the intersection of their boxes. */
void bound_common(const struct bound *parts, size_t count, struct bound *whole);
/* Computes the box that encloses the boxes of other bounds. */
void bound_box(const struct bound *parts, size_t count, struct bound *whole);
/* Enlarges a bound by more than the rounding errors of the machine. */
void bound_add_margin(struct bound *bound);

#endif
