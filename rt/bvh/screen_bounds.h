/* screen_bounds.h - screen bounds of a mesh: for each node of its hierarchy a window,
 * as seen from a viewpoint that many rays pass through.
 *
 * The view axis w is the axis on which the distance of the viewpoint e from the mesh is
 * greatest. With u and v, the two axes after w in cyclic order, the projection of a
 * point p is
 *
 *     z = sign (p - e)_w     (p - e)_u / z     (p - e)_v / z
 *
 * The window of a node is the range of the last two values over all corners below the
 * node, and the least z. A ray through the viewpoint has constant u and v, so it misses
 * every node whose window does not contain them. Testing a window is cheaper than
 * testing a box. But the window of a long and oblique part is much larger than its box,
 * because it is parallel to the axes. Windows are therefore used only if they cost less
 * in total, estimated from the areas of both.
 *
 * Source: the buffers of Weghorst, Hooper and Greenberg 1984 and of Haines and
 * Greenberg 1986, here with a tree of windows in place of cells.
 */
#ifndef RT_SCREEN_BOUNDS_H
#define RT_SCREEN_BOUNDS_H

#include "rt/bvh/viewpoints.h"
#include "rt/bvh/mesh_hierarchy.h"

/* The end of a mesh's table (records.s): one row per viewpoint outside the mesh; then
 * for each of these viewpoints a row of zeros and one row per node. */
struct screen_bounds {
    const struct mesh_hierarchy *hierarchy;
    const double *triangles; /* rows of the triangles, which begin with their three
                              * corners */
    size_t row;              /* words of a row */
    double triangles_place;  /* offset of these rows in the table, in words */
};

/* Returns the size of this part in words, and sets *seeing to the number of viewpoints
 * outside the box. */
size_t screen_bounds_size(const struct viewpoints *viewpoints, const struct box *whole,
                          size_t nodes, size_t *seeing);
/* Writes this part, which is at the offset `place` of the table, and sets *planned to
 * the number of viewpoints that have windows. Fails if memory is exhausted. */
bool screen_bounds_put(const struct screen_bounds *bounds,
                       const struct viewpoints *viewpoints, double place, double *words,
                       size_t *planned);
/* Marks which of these words are integers. */
void screen_bounds_mark(size_t seeing, size_t nodes, bool *marks);

#endif
