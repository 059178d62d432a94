/* mesh.h - finds the triangle of a mesh that a ray has hit. */
#ifndef RT_MESH_H
#define RT_MESH_H

#include "rt/shapes/primitive.h"

/* Returns the indices of the triangles, in the order of their rows in the mesh's table.
 * Returns NULL if out of memory. The caller frees the indices. */
size_t *mesh_order(const struct primitive *mesh);
/* Returns the index of a row of the mesh's table. words: the offset of the row in the
 * table, in words. */
size_t mesh_row(const struct primitive *mesh, size_t words);

#endif
