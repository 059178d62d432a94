/* mesh.h - finds which triangle of a mesh a hit is on. */
#ifndef RT_MESH_H
#define RT_MESH_H

#include "rt/shapes/primitive.h"

/* Returns the indices of the triangles in the order of their rows in the mesh's table.
 * The caller frees them. Returns NULL without memory. */
size_t *mesh_order(const struct primitive *mesh);
/* Returns the index of a triangle's row from its offset in the table, in words. */
size_t mesh_row(const struct primitive *mesh, size_t words);

#endif
