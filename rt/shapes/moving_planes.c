/* moving_planes.c - computes the moving planes of a Steiner patch from a null space. */
#include "rt/shapes/moving_planes.h"

#include <string.h>

#include "rt/scene/vector3.h"
#include "rt/shapes/singular.h"

/* Singular values that are below this fraction of the greatest value count as 0. */
#define NOTHING 1e-9

/* The indices of the two parameters whose product is quadratic monomial m. */
static const int factors[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 },
                                   { 0, 1 }, { 1, 2 }, { 2, 0 } };

/* Returns the index of the cubic monomial p_i p_j p_k, from the exponents of s and
 * t. */
static size_t cubic_monomial(int i, int j, int k)
{
    static const size_t numbers[4][4] = {
        { 0, 1, 2, 3 }, { 4, 5, 6, 0 }, { 7, 8, 0, 0 }, { 9, 0, 0, 0 }
    };
    int s = (i == 0) + (j == 0) + (k == 0);
    int t = (i == 1) + (j == 1) + (k == 1);
    return numbers[s][t];
}

/* Sets up the linear system for the moving planes L (moving_planes.h). The unknowns are
 * the twelve entries of L, row by row. Each cubic monomial of p . (L H(p)) = 0 gives
 * one equation. */
static void set_up(const double points[6][4], struct singular *equations)
{
    memset(equations, 0, sizeof *equations);
    equations->rows = 10;
    equations->columns = 12;
    for (int i = 0; i < 3; i++)
        for (int m = 0; m < 6; m++) {
            size_t row = cubic_monomial(i, factors[m][0], factors[m][1]);
            for (int c = 0; c < 4; c++)
                equations->scaled[row][4 * i + c] += (m < 3 ? 1 : 2) * points[m][c];
        }
}

/* Returns the column with the least singular value, except the column `taken`. */
static size_t least_column(const struct singular *singular, size_t taken)
{
    size_t least = taken == 0 ? 1 : 0;
    for (size_t i = 0; i < singular->columns; i++)
        if (i != taken && singular->values[i] < singular->values[least])
            least = i;
    return least;
}

/* Computes the triple point: the common point of the planes that are the rows of L1 and
 * L2. */
static void find_triple(struct moving_planes *planes)
{
    struct singular singular = { .rows = 6, .columns = 4 };
    size_t column;
    for (size_t i = 0; i < 6; i++)
        memcpy(singular.scaled[i], planes->l[i / 3][i % 3], sizeof planes->triple);
    singular_decompose(&singular);
    column = least_column(&singular, singular.columns);
    for (size_t i = 0; i < 4; i++)
        planes->triple[i] = singular.right[i][column];
}

/* Computes the product of the moving plane l and the position H(p) (moving_planes.h).
 * Its elements are the coefficients of s, t and u. */
static void plane_at(const double points[6][4], const double l[3][4], const double p[3],
                     double row[3])
{
    memset(row, 0, 3 * sizeof *row);
    for (int m = 0; m < 6; m++) {
        double share = p[factors[m][0]] * p[factors[m][1]];
        for (int i = 0; i < 3; i++)
            for (int c = 0; c < 4; c++)
                row[i] += (m < 3 ? 1 : 2) * share * l[i][c] * points[m][c];
    }
}

/* Returns true if all points are in one plane. */
static bool is_flat(const double points[6][4])
{
    struct singular singular = { .rows = 6, .columns = 4 };
    for (size_t i = 0; i < 6; i++)
        memcpy(singular.scaled[i], points[i], sizeof points[i]);
    singular_decompose(&singular);
    return singular_nullity(&singular, NOTHING) > 0;
}

/* Returns true if the moving planes determine the parameters p of a point: the products
 * of both moving planes with H(p) (plane_at) are not parallel. This may fail at a
 * single place, if another p has the same H(p). If it fails at all places, the surface
 * is a quadric that is covered twice. */
static bool is_simple(const double points[6][4], const struct moving_planes *planes)
{
    static const double places[][3] = { { .5, .3, .2 },
                                        { .2, .5, .3 },
                                        { .3, .2, .5 } };
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        double normals[2][3], across[3];
        for (int which = 0; which < 2; which++)
            plane_at(points, planes->l[which], places[i], normals[which]);
        cross3(normals[0], normals[1], across);
        if (length3(across) > NOTHING * length3(normals[0]) * length3(normals[1]))
            return true;
    }
    return false;
}

void moving_planes_find(const double points[6][4], struct moving_planes *planes)
{
    struct singular singular;
    size_t taken;
    memset(planes, 0, sizeof *planes);
    if (is_flat(points))
        return;
    set_up(points, &singular);
    singular_decompose(&singular);
    planes->type = (enum surface_type)singular_nullity(&singular, NOTHING);
    if (planes->type != SURFACE_STEINER)
        return;
    taken = singular.columns;
    for (int which = 0; which < 2; which++) {
        taken = least_column(&singular, taken);
        for (size_t i = 0; i < 12; i++)
            planes->l[which][i / 4][i % 4] = singular.right[i][taken];
    }
    if (is_simple(points, planes))
        find_triple(planes);
    else
        planes->type = SURFACE_QUADRIC;
}
