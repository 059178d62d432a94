/* path.h - closed loops of edges, swept along y: points in x and z, loop behind
 * loop, each ends at the point that it begins with.  Where edges are curves
 * points between are their handles, one for each.
 */
#ifndef RT_PATH_H
#define RT_PATH_H

#include "rt/shapes/bound.h"

/* Points that differ by less than this count as one: POV-Ray's 1e-10, and as much of
 * the size of a path that is smaller than 1. */
double path_closeness(const double (*points)[2], size_t count);
bool path_is_near(const double a[2], const double b[2], double closeness);

/* Edge by edge, the loops one after another: begin with { .path = .., .apart =
 * .. }; where there are handles, half an edge by half an edge. */
struct path_walk {
    const struct outline *path;
    size_t apart;     /* how far one corner is from the next: 1 or, with
                         handles, 2 */
    size_t at, first; /* the point that is next, the first of its loop */
    bool begins;      /* the edge is the first of its loop */
    const double *from, *to;
};
bool path_next(struct path_walk *walk);

/* The most that a line crosses its edges; of curves, what it crosses the ways
 * over their handles, which is no less. */
size_t path_crossings(const struct outline *path, size_t apart);
/* Of what it is swept to, from one height to the other. */
void path_bound(const struct primitive *primitive, const struct outline *path,
                double low_end, double high_end, struct bound *bound);

#endif
