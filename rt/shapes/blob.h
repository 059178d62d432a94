/* blob.h - counts the pieces of blobs along a ray, for which the kernels reserve
 * space. */
#ifndef RT_BLOB_H
#define RT_BLOB_H

#include "rt/shapes/primitive.h"

/* The limit of components. In a region of cylinders the vector form then needs most of
 * the 67,108,864 words that a program can have. */
enum { MAX_BLOB_PARTS = 1500 };

/* Returns the number of pieces of a blob's field along a ray. A sphere has one piece, a
 * cylinder three. */
size_t blob_pieces(const struct primitive *primitive);
/* Returns the largest number of pieces of a blob in the scene, for which the kernels
 * reserve space (BLOB_PIECES in records.s). It is 0 without blobs. */
size_t blob_pieces_most(const struct scene *scene);

#endif
