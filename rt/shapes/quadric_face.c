/* quadric_face.c - compares quadrics by their matrices in world space. */
#include "rt/shapes/quadric_face.h"

#include <math.h>

#include "rt/scene/vector3.h"
#include "rt/shapes/coincident.h"

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

/* Computes, in world space, the matrix of
 *
 *   |X - base|^2 - along ((X - base) . axis)^2 - 2 rise (X - base) . axis - square
 *
 * The axis has length 1. */
static void round_matrix(const struct primitive *primitive, const double base[3],
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

static void cone_matrix(const struct primitive *primitive, const double base[3],
                        double base_radius, const double cap[3], double cap_radius,
                        row *matrix)
{
    double axis[3], length, slope;
    subtract3(cap, base, axis);
    length = length3(axis);
    scale3(1 / length, axis);
    slope = (cap_radius - base_radius) / length;
    round_matrix(primitive, base, axis, 1 + slope * slope, base_radius * slope,
                 base_radius * base_radius, matrix);
}

static void quadric_matrix(const struct primitive *primitive, row *matrix)
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
        add_product(primitive->shape.quadric.coefficients[i], a == ONE ? one : rows[a],
                    b == ONE ? one : rows[b], matrix);
    }
}

/* Computes the matrix of a primitive's quadric face in world space. Returns false if it
 * has no such face. */
static bool matrix_of(const struct primitive *primitive, row *matrix)
{
    static const double up[3] = { 0, 1, 0 };
    for (int i = 0; i < 16; i++)
        matrix[i / 4][i % 4] = 0;
    switch (primitive->kind) {
    case PRIMITIVE_SPHERE:
        round_matrix(primitive, primitive->shape.sphere.center, up, 0, 0,
                     primitive->shape.sphere.radius * primitive->shape.sphere.radius,
                     matrix);
        return true;
    case PRIMITIVE_CYLINDER:
        cone_matrix(primitive, primitive->shape.cylinder.base,
                    primitive->shape.cylinder.radius, primitive->shape.cylinder.cap,
                    primitive->shape.cylinder.radius, matrix);
        return true;
    case PRIMITIVE_CONE:
        cone_matrix(primitive, primitive->shape.cone.base,
                    primitive->shape.cone.base_radius, primitive->shape.cone.cap,
                    primitive->shape.cone.cap_radius, matrix);
        return true;
    case PRIMITIVE_QUADRIC: quadric_matrix(primitive, matrix); return true;
    default: return false;
    }
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

bool quadric_face_is_there(const struct primitive *primitive)
{
    row matrix[4];
    return matrix_of(primitive, matrix);
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
