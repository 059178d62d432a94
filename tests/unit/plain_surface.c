/* plain_surface.c - crossings and volumes of surfaces from many rays. */
#include "plain_surface.h"

void assert_near(double found, double expected, double within)
{
    FAIL_IF(!(fabs(found - expected) <= within), "%.17g is not %.17g", found, expected);
}

double number_between(uint64_t *random, double low, double high)
{
    return xorshift_real(random, low, high);
}

void random_direction(uint64_t *random, double direction[3])
{
    do
        for (int i = 0; i < 3; i++)
            direction[i] = number_between(random, -1, 1);
    while (dot(direction, direction) > 1 || dot(direction, direction) < .01);
}

/* ---- Crossings of a surface of many parts ------------------------------- */

struct spelling shoot(const struct surface *surface, const struct ray *ray)
{
    struct spelling nearest = { INFINITY, { 0 } };
    for (size_t i = 0; i < surface->count; i++) {
        struct crossing crossings[MAX_CROSSINGS];
        size_t count = plain_crossings(&surface->parts[i], ray, crossings);
        assert_true(count <= MAX_CROSSINGS);
        for (size_t k = 0; k < count; k++)
            if (crossings[k].distance > START
                && crossings[k].distance < nearest.distance) {
                nearest.distance = crossings[k].distance;
                copy(nearest.normal, crossings[k].normal);
            }
    }
    if (dot(nearest.normal, nearest.normal) > 0)
        normalise(nearest.normal);
    if (dot(nearest.normal, ray->direction) > 0)
        scale_by(nearest.normal, -1);
    return nearest;
}

struct surface one(enum primitive_kind kind)
{
    struct surface surface = { .count = 1 };
    surface.parts[0].kind = kind;
    return surface;
}

void assert_hits(const struct surface *surface, const struct expectation *rows,
                 size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct ray ray;
        copy(ray.origin, rows[i].origin);
        copy(ray.direction, rows[i].direction);
        struct spelling found = shoot(surface, &ray);
        if (rows[i].distance == 0) {
            assert_true(isinf(found.distance));
            continue;
        }
        assert_near(found.distance, rows[i].distance, CLOSE);
        for (int k = 0; k < 3; k++)
            assert_near(found.normal[k], rows[i].normal[k], CLOSE);
    }
}

/* ---- Volumes ------------------------------------------------------------ */

static int compare_distances(const void *a, const void *b)
{
    const struct crossing *x = a, *y = b;
    return (x->distance > y->distance) - (x->distance < y->distance);
}

/* Returns the length of a ray inside a closed surface: the distances between crossings
 * 1 and 2, 3 and 4, and so on. */
static double inside(const struct surface *surface, const struct ray *ray)
{
    struct crossing crossings[MAX_CROSSINGS];
    size_t count = plain_crossings(&surface->parts[0], ray, crossings);
    double sum = 0;
    assert_int_equal(count % 2, 0);
    qsort(crossings, count, sizeof *crossings, compare_distances);
    for (size_t i = 0; i < count; i += 2)
        sum += crossings[i + 1].distance - crossings[i].distance;
    return sum;
}

double volume(const struct surface *surface, double size)
{
    int steps = 150;
    const double across[2][3] = { { .6, .8, 0 }, { 0, 0, 1 } };
    double sum = 0;
    for (int i = 0; i < steps; i++)
        for (int j = 0; j < steps; j++) {
            struct ray ray = { { 0 }, { -.8, .6, 0 } };
            double u = (2 * i + 1. - steps) / steps * size;
            double v = (2 * j + 1. - steps) / steps * size;
            add_scaled(ray.origin, ray.origin, u, across[0]);
            add_scaled(ray.origin, ray.origin, v, across[1]);
            sum += inside(surface, &ray);
        }
    return sum * 4 * size * size / steps / steps;
}

/* ---- Two surfaces that are one ------------------------------------------- */

void set_coefficient(struct surface *surface, int x, int y, int z, double value)
{
    size_t at = 0;
    for (int i = 4; i >= 0; i--)
        for (int j = 4 - i; j >= 0; j--)
            for (int k = 4 - i - j; k >= 0; k--, at++)
                if (i == x && j == y && k == z)
                    surface->parts[0].shape.quartic.coefficients[at] = value;
}

static struct ray random_ray(uint64_t *random, double size)
{
    struct ray ray;
    double target[3];
    random_direction(random, ray.origin);
    random_direction(random, target);
    scale_by(target, size);
    scale_by(ray.origin, 5 / sqrt(dot(ray.origin, ray.origin)));
    add_scaled(ray.direction, target, -1, ray.origin);
    return ray;
}

void assert_same_surface(const struct surface *a, const struct surface *b, double size)
{
    uint64_t random = RANDOM_SEED;
    int hits = 0, strays = 0;
    for (int i = 0; i < 2000; i++) {
        struct ray ray = random_ray(&random, size);
        struct spelling x = shoot(a, &ray), y = shoot(b, &ray);
        hits += !isinf(x.distance);
        if (isinf(x.distance) && isinf(y.distance))
            continue;
        double dn = 1 - fabs(dot(x.normal, y.normal));
        strays += !(fabs(x.distance - y.distance) < 1e-11 && dn < 1e-9);
    }
    assert_true(hits > 400);
    FAIL_IF(strays > 1, "%d of %d differ", strays, hits);
}
