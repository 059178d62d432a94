/* blob.h - what must be known of blobs before the program is assembled. */
#ifndef RT_BLOB_H
#define RT_BLOB_H

#include "rt/shapes/primitive.h"

/* In a region of cylinders the vector form takes most of the 67,108,864 words
 * that a program can have. */
enum { MAX_BLOB_PARTS = 1500 };

/* The pieces of which its field is made along a ray: a ball is one, a cylinder
 * three. */
size_t blob_pieces(const struct primitive *primitive);
/* The most of a blob of the scene: the kernels are assembled with room for so
 * many (BLOB_PIECES in records.s).  0: there are no blobs. */
size_t blob_pieces_most(const struct scene *scene);

#endif
