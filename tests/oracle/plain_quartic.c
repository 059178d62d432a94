/* plain_quartic.c - surfaces of degree four. The polynomial along a line is composed of
 * the polynomials of the line's coordinates. */
#include "tests/oracle/plain_roots.h"
#include "tests/oracle/plain_shapes.h"

enum { TERMS = HIGHEST_DEGREE + 1 };

/* The coefficients of a polynomial in ascending order. */
struct along {
    long double c[TERMS];
};

/* A line, parametrised from its point nearest to the origin, with unit length: its
 * coordinates, and the ray parameters of this point and of a unit step. */
struct centred_line {
    struct along coordinate[3];
    long double start, step;
};

static struct centred_line centre(const struct ray *ray)
{
    struct centred_line line = { .start = 0 };
    long double square = 0, along = 0;
    for (int i = 0; i < 3; i++) {
        square += (long double)ray->direction[i] * ray->direction[i];
        along += (long double)ray->direction[i] * ray->origin[i];
    }
    line.start = -along / square;
    line.step = 1 / sqrtl(square);
    for (int i = 0; i < 3; i++) {
        line.coordinate[i].c[0] = ray->origin[i] + line.start * ray->direction[i];
        line.coordinate[i].c[1] = ray->direction[i] * line.step;
    }
    return line;
}

/* Multiplies two polynomials. Terms above degree four are dropped. */
static struct along times(const struct along *a, const struct along *b)
{
    struct along product = { { 0 } };
    for (int i = 0; i < TERMS; i++)
        for (int j = 0; i + j < TERMS; j++)
            product.c[i + j] += a->c[i] * b->c[j];
    return product;
}

static void add_times(struct along *sum, long double factor, const struct along *what)
{
    for (int i = 0; i < TERMS; i++)
        sum->c[i] += factor * what->c[i];
}

/* Computes the distances and normals at the roots. */
typedef void set_normal(const void *surface, const double point[3], double normal[3]);

static size_t cross_surface(const struct along *along, const struct centred_line *line,
                            const struct ray *ray, set_normal *set, const void *surface,
                            struct crossing crossings[MAX_CROSSINGS])
{
    long double roots[HIGHEST_DEGREE];
    size_t count = plain_roots(along->c, HIGHEST_DEGREE, roots);
    for (size_t i = 0; i < count; i++) {
        double point[3];
        crossings[i].distance = (double)(line->start + roots[i] * line->step);
        point_on(ray, crossings[i].distance, point);
        set(surface, point, crossings[i].normal);
    }
    return count;
}

/* ---- Tori ---------------------------------------------------------------- */

/* The ellipse of the tube has its centre at the distance `major` from the y axis:
 *     ((sqrt(x^2 + z^2) - major) / radial)^2 + (y / axial)^2 = 1.
 * Without the root, with r = (radial / axial)^2:
 *     (x^2 + z^2 + r y^2 + major^2 - radial^2)^2 = 4 major^2 (x^2 + z^2).
 */
static struct along torus_along(const struct torus *torus,
                                const struct along coordinate[3])
{
    long double major = torus->major, radial = torus->radial;
    long double ratio = radial / torus->axial;
    struct along xx = times(&coordinate[0], &coordinate[0]);
    struct along yy = times(&coordinate[1], &coordinate[1]);
    struct along zz = times(&coordinate[2], &coordinate[2]);
    struct along across = xx, sum;
    add_times(&across, 1, &zz);
    sum = across;
    add_times(&sum, ratio * ratio, &yy);
    sum.c[0] += major * major - radial * radial;
    sum = times(&sum, &sum);
    add_times(&sum, -4 * major * major, &across);
    return sum;
}

static void torus_normal(const void *surface, const double point[3], double normal[3])
{
    const struct torus *torus = surface;
    double ratio = torus->radial / torus->axial;
    double across = point[0] * point[0] + point[2] * point[2];
    double sum = across + ratio * ratio * point[1] * point[1]
                 + torus->major * torus->major - torus->radial * torus->radial;
    normal[0] = point[0] * (sum - 2 * torus->major * torus->major);
    normal[1] = point[1] * ratio * ratio * sum;
    normal[2] = point[2] * (sum - 2 * torus->major * torus->major);
}

CROSS(cross_torus)
{
    struct torus torus = torus_of(primitive);
    struct centred_line line = centre(ray);
    struct along surface = torus_along(&torus, line.coordinate);
    return cross_surface(&surface, &line, ray, torus_normal, &torus, crossings);
}

CROSS(cross_elliptical_torus)
{
    return cross_torus(primitive, ray, crossings);
}

/* ---- Any quartic --------------------------------------------------------- */

/* The powers of x, y and z of the terms, descending in x, then y, then z. */
typedef int powers_of_term[3];

static void list_powers(powers_of_term powers[QUARTIC_TERMS])
{
    size_t count = 0;
    for (int x = HIGHEST_DEGREE; x >= 0; x--)
        for (int y = HIGHEST_DEGREE - x; y >= 0; y--)
            for (int z = HIGHEST_DEGREE - x - y; z >= 0; z--) {
                powers[count][0] = x;
                powers[count][1] = y;
                powers[count++][2] = z;
            }
}

static struct along quartic_along(const double *coefficients,
                                  const struct along coordinate[3])
{
    powers_of_term powers[QUARTIC_TERMS];
    struct along sum = { { 0 } };
    list_powers(powers);
    for (int i = 0; i < QUARTIC_TERMS; i++) {
        struct along term = { { coefficients[i] } };
        for (int axis = 0; axis < 3; axis++)
            for (int k = 0; k < powers[i][axis]; k++)
                term = times(&term, &coordinate[axis]);
        add_times(&sum, 1, &term);
    }
    return sum;
}

/* Returns the partial derivative of a term at a point. */
static double term_slope(const powers_of_term powers, int by, const double point[3])
{
    double value = powers[by];
    for (int axis = 0; axis < 3; axis++)
        for (int k = axis == by; k < powers[axis]; k++)
            value *= point[axis];
    return value;
}

static void quartic_normal(const void *surface, const double point[3], double normal[3])
{
    const double *coefficients = surface;
    powers_of_term powers[QUARTIC_TERMS];
    list_powers(powers);
    for (int axis = 0; axis < 3; axis++) {
        normal[axis] = 0;
        for (int i = 0; i < QUARTIC_TERMS; i++)
            normal[axis] += coefficients[i] * term_slope(powers[i], axis, point);
    }
}

CROSS(cross_quartic)
{
    const double *c = primitive->shape.quartic.coefficients;
    struct centred_line line = centre(ray);
    struct along surface = quartic_along(c, line.coordinate);
    return cross_surface(&surface, &line, ray, quartic_normal, c, crossings);
}
