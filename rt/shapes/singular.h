/* singular.h - the singular value decomposition of a small matrix, A V = U S.
 *
 * One-sided Jacobi: the columns of A are turned in pairs until they are
 * square to each other; V keeps the turns.  Source: Hestenes 1958; Golub and
 * Van Loan, Matrix Computations, 8.6.
 */
#ifndef RT_SINGULAR_H
#define RT_SINGULAR_H

#include <stddef.h>

enum { MAX_SINGULAR = 12 };
typedef double singular_matrix[MAX_SINGULAR][MAX_SINGULAR];

struct singular {
    size_t rows, columns;        /* each MAX_SINGULAR at most */
    singular_matrix scaled;      /* the columns of U, each by its value */
    singular_matrix right;       /* V: columns x columns */
    double values[MAX_SINGULAR]; /* not sorted, none below 0 */
};

/* Of the matrix in scaled; the other members are results. */
void singular_decompose(struct singular *singular);

/* How many values are at most share times the greatest. */
size_t singular_nullity(const struct singular *singular, double share);

/* The shortest x with the least |A x - b|; values at most share times the
 * greatest count as 0. */
void singular_solve(const struct singular *singular, double share, const double *b,
                    double *x);

#endif
