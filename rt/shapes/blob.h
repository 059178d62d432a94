/* blob.h - sizes of blobs that the assembly of the kernels needs. */
#ifndef RT_BLOB_H
#define RT_BLOB_H

#include "rt/shapes/primitive.h"

/* In a region of cylinders the vector form needs most of the 67,108,864 words that a
 * program can have. */
enum { MAX_BLOB_PARTS = 1500 };

/* Returns the number of pieces of the field along a ray: one for a sphere, three for a
 * cylinder. */
size_t blob_pieces(const struct primitive *primitive);
/* Returns the greatest number of pieces in a blob of the scene, for which the kernels
 * reserve space (BLOB_PIECES in records.s). 0: there are no blobs. */
size_t blob_pieces_most(const struct scene *scene);

#endif
