/* path.h - walks over the edges of a prism's path, bounds the path, and counts the
 * crossings of a line with it.
 *
 * A path is a list of loops of points in x and z. Each loop ends with its first point.
 * If the edges are curves, there is one handle between the two corners of an edge.
 */
#ifndef RT_PATH_H
#define RT_PATH_H

#include "rt/shapes/shape_bound.h"

/* Returns the distance below which points count as equal: POV-Ray's 1e-10, multiplied
 * by the size of the path if the size is below 1. */
double path_closeness(const double (*points)[2], size_t count);
bool path_is_near(const double a[2], const double b[2], double closeness);

/* A walk over the edges of all loops, in order. It is initialised with { .path = ..,
 * .apart = .. }. In a path with handles, each step is half an edge: from a corner to
 * the handle, or from the handle to the next corner. */
struct path_walk {
    const struct outline *path;
    size_t apart;     /* index distance of successive corners: 1, or 2 with handles */
    size_t at, first; /* index of the next point, and of the first point of its loop */
    bool begins;      /* the edge is the first of its loop */
    const double *from, *to;
};
bool path_next(struct path_walk *walk);

/* Returns the largest number of edges that a line can cross. For curves the edges of
 * the polygon through the handles are counted, because a line crosses this polygon at
 * least as often as the curves. */
size_t path_crossings(const struct outline *path, size_t apart);
/* Bounds the path swept between two heights. */
void path_bound(const struct primitive *primitive, const struct outline *path,
                double low_end, double high_end, struct bound *bound);

#endif
