/* quadric_face.c - compares quadrics by their matrices in world space. */
#include "rt/shapes/quadric_face.h"

#include <math.h>

#include "rt/scene/vector3.h"
#include "rt/shapes/coincident.h"
#include "rt/shapes/shape.h"

/* Rounding error, relative to the greatest element of a matrix. */
#define ROUNDING 1e-12

/* A linear form in homogeneous coordinates. */
typedef double row[4];

static void add_product(double weight, const row a, const row b, row *sum)
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            sum[i][j] += weight * (a[i] * b[j] + b[i] * a[j]) / 2;
}

void quadric_about_axis(const struct primitive *primitive, const double base[3],
                        const double axis[3], double along, double rise, double square,
                        row *matrix)
{
    static const row one = { 0, 0, 0, 1 };
    row level = { 0 };
    for (int i = 0; i < 3; i++) {
        row part;
        for (int j = 0; j < 4; j++)
            part[j] = primitive->to_local.rows[i][j] - (j == 3 ? base[i] : 0);
        add_product(1, part, part, matrix);
        for (int j = 0; j < 4; j++)
            level[j] += axis[i] * part[j];
    }
    add_product(-along, level, level, matrix);
    add_product(-2 * rise, level, one, matrix);
    add_product(-square, one, one, matrix);
}

void quadric_of_cone(const struct primitive *primitive, const double base[3],
                     double base_radius, const double cap[3], double cap_radius,
                     row *matrix)
{
    double axis[3], length, slope;
    subtract3(cap, base, axis);
    length = length3(axis);
    scale3(1 / length, axis);
    slope = (cap_radius - base_radius) / length;
    quadric_about_axis(primitive, base, axis, 1 + slope * slope, base_radius * slope,
                       base_radius * base_radius, matrix);
}

void quadric_of_terms(const struct primitive *primitive,
                      const double terms[QUADRIC_TERMS], row *matrix)
{
    enum { ONE = 3 };
    static const row one = { 0, 0, 0, 1 };
    static const int factors[QUADRIC_TERMS][2] = { { 0, 0 },    { 1, 1 },   { 2, 2 },
                                                   { 0, 1 },    { 0, 2 },   { 1, 2 },
                                                   { 0, ONE },  { 1, ONE }, { 2, ONE },
                                                   { ONE, ONE } };
    const double(*rows)[4] = (const double(*)[4])primitive->to_local.rows;
    for (int i = 0; i < QUADRIC_TERMS; i++) {
        int a = factors[i][0], b = factors[i][1];
        add_product(terms[i], a == ONE ? one : rows[a], b == ONE ? one : rows[b],
                    matrix);
    }
}

static void matrix_of(const struct primitive *primitive, row *matrix)
{
    for (int i = 0; i < 16; i++)
        matrix[i / 4][i % 4] = 0;
    shape_of(primitive)->quadric(primitive, matrix);
}

/* Moves the origin to `at`, changes the unit of length to `unit`, and scales the matrix
 * so that its element of greatest absolute value is 1 or -1. */
static void move_matrix(row *matrix, const double at[3], double unit)
{
    row moved[4] = { { 0 } };
    double size = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 16; k++) {
                int a = k / 4, b = k % 4;
                double left = i < 3 ? (a == i) * unit : a < 3 ? at[a] : 1;
                double right = j < 3 ? (b == j) * unit : b < 3 ? at[b] : 1;
                moved[i][j] += left * matrix[a][b] * right;
            }
    for (int i = 0; i < 16; i++)
        size = fmax(size, fabs(moved[i / 4][i % 4]));
    for (int i = 0; i < 16; i++)
        matrix[i / 4][i % 4] = moved[i / 4][i % 4] / (size > 0 ? size : 1);
}

double quadric_face_key(const struct primitive *primitive)
{
    static const row weights[3] = { { .1667, .1988, .1697, .13 },
                                    { .2581, .3078, .2627, .13 },
                                    { .3495, .4168, .3557, .13 } };
    double size = 0, key = 0;
    row matrix[4];
    matrix_of(primitive, matrix);
    for (int i = 0; i < 3; i++) {
        size += dot3(matrix[i], matrix[i]);
        for (int j = 0; j < 4; j++)
            key += weights[i][j] * matrix[i][j];
    }
    return size > 0 ? fabs(key) / sqrt(size) : 0;
}

int quadric_face_compare(const struct primitive *a, const struct primitive *b,
                         const double at[3], double reach)
{
    row one[4], other[4];
    double sum = 0, difference = 0;
    matrix_of(a, one);
    matrix_of(b, other);
    move_matrix(one, at, reach);
    move_matrix(other, at, reach);
    for (int i = 0; i < 16; i++) {
        double x = one[i / 4][i % 4], y = other[i / 4][i % 4];
        sum = fmax(sum, fabs(x + y));
        difference = fmax(difference, fabs(x - y));
    }
    if (fmin(sum, difference) > COINCIDENT / fmax(reach, 1) + ROUNDING)
        return 0;
    return difference < sum ? 1 : -1;
}
