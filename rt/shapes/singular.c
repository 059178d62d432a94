/* singular.c - the one-sided Jacobi method. */
#include "rt/shapes/singular.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

static double column_product(const struct singular *singular, size_t p, size_t q)
{
    double sum = 0;
    for (size_t i = 0; i < singular->rows; i++)
        sum += singular->scaled[i][p] * singular->scaled[i][q];
    return sum;
}

static void turn(singular_matrix matrix, size_t rows, size_t p, size_t q, double cosine,
                 double sine)
{
    for (size_t i = 0; i < rows; i++) {
        double x = matrix[i][p], y = matrix[i][q];
        matrix[i][p] = cosine * x - sine * y;
        matrix[i][q] = sine * x + cosine * y;
    }
}

/* Rotates two columns so that they are orthogonal. Returns false if they were
 * already. */
static bool make_square(struct singular *singular, size_t p, size_t q)
{
    double pp = column_product(singular, p, p);
    double qq = column_product(singular, q, q);
    double pq = column_product(singular, p, q);
    double ratio, tangent, cosine;
    if (fabs(pq) <= DBL_EPSILON * sqrt(pp) * sqrt(qq))
        return false;
    ratio = (qq - pp) / (2 * pq);
    tangent = copysign(1 / (fabs(ratio) + sqrt(1 + ratio * ratio)), ratio);
    cosine = 1 / sqrt(1 + tangent * tangent);
    turn(singular->scaled, singular->rows, p, q, cosine, cosine * tangent);
    turn(singular->right, singular->columns, p, q, cosine, cosine * tangent);
    return true;
}

void singular_decompose(struct singular *singular)
{
    enum { MAX_SWEEPS = 60 };
    bool turned = true;
    memset(singular->right, 0, sizeof singular->right);
    for (size_t i = 0; i < singular->columns; i++)
        singular->right[i][i] = 1;
    for (int sweep = 0; turned && sweep < MAX_SWEEPS; sweep++) {
        turned = false;
        for (size_t p = 0; p < singular->columns; p++)
            for (size_t q = p + 1; q < singular->columns; q++)
                turned |= make_square(singular, p, q);
    }
    for (size_t i = 0; i < singular->columns; i++)
        singular->values[i] = sqrt(column_product(singular, i, i));
}

static double least_value(const struct singular *singular, double share)
{
    double most = 0;
    for (size_t i = 0; i < singular->columns; i++)
        most = fmax(most, singular->values[i]);
    return share * most;
}

size_t singular_nullity(const struct singular *singular, double share)
{
    double least = least_value(singular, share);
    size_t count = 0;
    for (size_t i = 0; i < singular->columns; i++)
        count += singular->values[i] <= least;
    return count;
}

void singular_solve(const struct singular *singular, double share, const double *b,
                    double *x)
{
    double least = least_value(singular, share);
    memset(x, 0, singular->columns * sizeof *x);
    for (size_t j = 0; j < singular->columns; j++) {
        double value = singular->values[j], product = 0;
        if (value <= least)
            continue;
        for (size_t i = 0; i < singular->rows; i++)
            product += singular->scaled[i][j] * b[i];
        for (size_t i = 0; i < singular->columns; i++)
            x[i] += singular->right[i][j] * (product / value / value);
    }
}
