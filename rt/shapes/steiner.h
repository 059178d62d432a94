/* steiner.h - computes the data of a Steiner patch that its kernels read.
 *
 * The points of the patch are relative to its centre. The weights are normalised so
 * that all corners have the same weight. The corners are ordered as the kernel needs
 * them: the edge from the second to the third corner has the greatest second
 * difference. Formulas: rt/kernels/shapes/steiner_patch.s.
 */
#ifndef RT_STEINER_H
#define RT_STEINER_H

#include "rt/shapes/primitive.h"

enum { STEINER_SHAPE = 7, STEINER_TABLE = 27, MAX_STEINER_TABLE = 79 };

/* Returns true if all weights are equal. */
bool steiner_is_polynomial(const struct primitive *primitive);

/* Writes seven words for rt/kernels/shapes/steiner_patch.s, which defines d, P and
 * B(s): the centre (3 words); the square of the radius of the bounding sphere; the
 * value of |d x P|^2 that counts as 0 (for a rational patch, relative to |P|^2); the
 * value of B(s)^2 that counts as 0, relative to |d x P|^2; the accuracy of
 * distances. */
void steiner_shape(const struct primitive *primitive, double *shape);

/* Writes up to MAX_STEINER_TABLE words and returns their number. The first
 * STEINER_TABLE words are x, y and z of the coefficients K0 .. K5
 * (rt/kernels/shapes/steiner_patch.s), then w of K0 .. K5, then a vector of the planes
 * for rays that are parallel to K5. For a surface of degree four the words of the
 * implicit form follow (rt/kernels/shapes/steiner_implicit.s). */
size_t steiner_table(const struct primitive *primitive, double *table);

#endif
