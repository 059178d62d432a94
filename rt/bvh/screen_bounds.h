/* screen_bounds.h - screen bounds of a mesh. A screen bound is a window around a node
 * of the hierarchy, as seen from a viewpoint that many rays pass through.
 *
 * The view axis w is the axis on which the distance of the viewpoint e from the mesh is
 * greatest. The axes u and v follow w in cyclic order. The projection of a point p is
 *
 *     z = sign (p - e)_w     (p - e)_u / z     (p - e)_v / z
 *
 * The window of a node has the least z and the ranges of the last two values over all
 * corners below the node. These two values are the same for all points of a ray through
 * the viewpoint, so the ray misses every node whose window does not contain them.
 * Testing a window is cheaper than testing a box. However, a window is parallel to the
 * axes u and v. A long oblique part can therefore have a window that is much larger
 * than its box. Windows are therefore used only if they cost less than boxes in total,
 * by an estimate.
 *
 * Source: the buffers of Weghorst, Hooper and Greenberg 1984 and of Haines and
 * Greenberg 1986, with a tree of windows instead of cells.
 */
#ifndef RT_SCREEN_BOUNDS_H
#define RT_SCREEN_BOUNDS_H

#include "rt/bvh/viewpoints.h"
#include "rt/bvh/mesh_hierarchy.h"

/* The screen bounds are the end of a mesh's table (records.s). They begin with one row
 * per viewpoint outside the mesh. Each of these viewpoints then has a row of zeros and
 * one row per node. */
struct screen_bounds {
    const struct mesh_hierarchy *hierarchy;
    const double *triangles; /* rows of the triangles; a row begins with the three
                              * corners */
    size_t row;              /* words of a row */
    double triangles_place;  /* offset of these rows in the table, in words */
};

/* Returns the size of the screen bounds in words, and sets *seeing to the number of
 * viewpoints that are outside of the box and not too close to it. */
size_t screen_bounds_size(const struct viewpoints *viewpoints, const struct box *whole,
                          size_t nodes, size_t *seeing);
/* Writes the screen bounds into `words`; place is their offset in the mesh's table.
 * Sets *planned to the number of viewpoints that have windows. Returns false if out of
 * memory. */
bool screen_bounds_put(const struct screen_bounds *bounds,
                       const struct viewpoints *viewpoints, double place, double *words,
                       size_t *planned);
/* Marks which words of the screen bounds are integers. */
void screen_bounds_mark(size_t seeing, size_t nodes, bool *marks);

#endif
