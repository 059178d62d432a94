/* steiner.h - the data of a Steiner patch for its kernels.
 *
 * The patch is relative to its centre, and its weights are normalised to equal weights
 * at the corners. Its three corners are in the order that suits the kernel: the edge
 * from the second to the third has the greatest second difference. Formulas:
 * rt/kernels/shapes/steiner_patch_vector.s.
 */
#ifndef RT_STEINER_H
#define RT_STEINER_H

#include "rt/shapes/primitive.h"

enum { STEINER_SHAPE = 7, STEINER_TABLE = 27, MAX_STEINER_TABLE = 79 };

/* Returns true if all weights are equal. */
bool steiner_is_polynomial(const struct primitive *primitive);

/* Writes: centre 3; square of the bound; the |d x P|^2 that counts as 0 (for a rational
 * patch, relative to |P|^2); the share of |d x P|^2 below which B(s)^2 counts as 0; the
 * accuracy of distances. */
void steiner_shape(const struct primitive *primitive, double *shape);

/* Writes STEINER_TABLE words: K0 .. K5, x y z of each; their w; a vector for planes of
 * another kind. For a surface of degree four the words of the implicit form follow
 * (rt/kernels/shapes/steiner_implicit_vector.s). Returns the number of words, at most
 * MAX_STEINER_TABLE. */
size_t steiner_table(const struct primitive *primitive, double *table);

#endif
