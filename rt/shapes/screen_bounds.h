/* screen_bounds.h - a mesh as it is seen from a point that many rays go through, an
 * eye: of each node of its hierarchy a window.
 *
 * The eye looks along the axis w on which it lies farthest beside the mesh.  With
 * u, v the axes next after w, a point p is at
 *
 *     z = sign (p - eye)_w     (p - eye)_u / z     (p - eye)_v / z
 *
 * and a window is between the least and the greatest of these last two that any
 * corner below the node has, behind the least z.  A ray through the eye has one
 * u and one v all along, so it passes a node beside whose window it is.  A window is
 * square to the axes, and of what is slender and stands askew it is much wider than a box:
 * so there are windows only where they cost less, by the areas of both.
 * Source: the buffers of Weghorst, Hooper and Greenberg 1984 and of Haines and
 * Greenberg 1986, here with a tree of windows in place of cells.
 */
#ifndef RT_MESH_WINDOWS_H
#define RT_MESH_WINDOWS_H

#include "rt/shapes/viewpoints.h"
#include "rt/shapes/mesh_hierarchy.h"

/* What is behind the other words of a mesh's table (records.s): rows for the eyes
 * that see it, then for each of these a row of zeros and one for each node. */
struct screen_bounds {
    const struct mesh_hierarchy *hierarchy;
    const double *triangles; /* the first one's row: three corners, and more */
    size_t row;              /* words of a row */
    double triangles_place;  /* words before them in the table */
};

/* Room for the eyes that see what is in the box, in words; their number to *seeing. */
size_t screen_bounds_size(const struct viewpoints *viewpoints, const struct box *whole,
                          size_t nodes, size_t *seeing);
/* Those words, and for how many eyes there are windows; so many words are before them
 * in the table.  False: no memory. */
bool screen_bounds_put(const struct screen_bounds *bounds,
                       const struct viewpoints *viewpoints, double place, double *words,
                       size_t *planned);
/* Which of them are integers. */
void screen_bounds_mark(size_t seeing, size_t nodes, bool *marks);

#endif
