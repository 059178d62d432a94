/* path.h - closed loops of edges that are swept along y.
 *
 * A path has points in x and z, loop after loop; each loop ends with its first point.
 * If the edges are curves, each has one handle between its two corners.
 */
#ifndef RT_PATH_H
#define RT_PATH_H

#include "rt/shapes/shape_bound.h"

/* Returns the distance below which points count as one: POV-Ray's 1e-10, multiplied by
 * the size of a path that is smaller than 1. */
double path_closeness(const double (*points)[2], size_t count);
bool path_is_near(const double a[2], const double b[2], double closeness);

/* A walk over the edges of all loops, in order. It is initialised with { .path = ..,
 * .apart = .. }. With handles, each step is half an edge: to the handle, then to the
 * corner. */
struct path_walk {
    const struct outline *path;
    size_t apart;     /* the step from one corner to the next: 1 or, with handles, 2 */
    size_t at, first; /* the next point, and the first of its loop */
    bool begins;      /* the edge is the first of its loop */
    const double *from, *to;
};
bool path_next(struct path_walk *walk);

/* Returns the greatest number of edges that a line can cross. For curves the polygon
 * through the handles is counted, which is crossed at least as often. */
size_t path_crossings(const struct outline *path, size_t apart);
/* Bounds the sweep of a path between two heights. */
void path_bound(const struct primitive *primitive, const struct outline *path,
                double low_end, double high_end, struct bound *bound);

#endif
