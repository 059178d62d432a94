/* steiner.h - what the kernels want of a Steiner patch.
 *
 * The patch is told from its centre, its weights with equal corners, and its
 * three corners are taken in the order that suits the kernel: the second
 * difference of the edge from the second to the third is the greatest.
 * Formulas: rt/kernels/shapes/steiner_patch_vector.s.
 */
#ifndef RT_STEINER_H
#define RT_STEINER_H

#include "rt/shapes/primitive.h"

enum { STEINER_SHAPE = 7, STEINER_TABLE = 27, MAX_STEINER_TABLE = 79 };

/* Are all weights the same? */
bool steiner_is_polynomial(const struct primitive *primitive);

/* Centre 3, square of the bound; the |d x P|^2 that counts as nothing (of a
 * rational patch, its share of |P|^2); the share of |d x P|^2 that is nothing
 * for B(s)^2; the resolution of distances. */
void steiner_shape(const struct primitive *primitive, double *shape);

/* K0 .. K5, x y z of each; their w; a vector for planes of another kind: so
 * much is STEINER_TABLE.  Then, for a surface of the fourth degree, what the
 * implicit way wants (rt/kernels/shapes/steiner_implicit_vector.s).  Returns the
 * number of words, MAX_STEINER_TABLE at most. */
size_t steiner_table(const struct primitive *primitive, double *table);

#endif
