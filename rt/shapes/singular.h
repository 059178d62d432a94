/* singular.h - the singular value decomposition of a small matrix, A V = U S.
 *
 * The one-sided Jacobi method rotates pairs of columns of A until all columns are
 * orthogonal. V accumulates the rotations. Sources: Hestenes 1958; Golub and Van Loan,
 * Matrix Computations, 8.6.
 */
#ifndef RT_SINGULAR_H
#define RT_SINGULAR_H

#include <stddef.h>

enum { MAX_SINGULAR = 12 };
typedef double singular_matrix[MAX_SINGULAR][MAX_SINGULAR];

struct singular {
    size_t rows, columns;        /* at most MAX_SINGULAR each */
    singular_matrix scaled;      /* the columns of U, each multiplied by its singular
                                  * value */
    singular_matrix right;       /* V, which has `columns` rows and columns */
    double values[MAX_SINGULAR]; /* singular values: not sorted, not negative */
};

/* Decomposes the matrix in `scaled`. The other members are results. */
void singular_decompose(struct singular *singular);

/* Returns the number of singular values that are at most `share` times the greatest. */
size_t singular_nullity(const struct singular *singular, double share);

/* Computes the shortest x that minimises |A x - b|. Singular values that are at most
 * `share` times the greatest count as 0. */
void singular_solve(const struct singular *singular, double share, const double *b,
                    double *x);

#endif
