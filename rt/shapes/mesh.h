/* mesh.h - which triangle of a mesh a hit is on. */
#ifndef RT_MESH_H
#define RT_MESH_H

#include "rt/shapes/primitive.h"

/* The triangles' numbers, in the order in which their rows are in the mesh's
 * table.  NULL: no memory; the caller frees them. */
size_t *mesh_order(const struct primitive *mesh);
/* Which row it is, from 0 on, before which so many words of the table stand. */
size_t mesh_row(const struct primitive *mesh, size_t words);

#endif
