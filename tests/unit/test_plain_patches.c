/* test_plain_patches.c - lines that cross Steiner patches, the Roman surface and the
 * cross-cap. The plain tracer's crossings are compared with closed forms, and with
 * other representations of the same surface. A lost root fails here. */
#include "tests/unit/plain_surface.h"

/* Exponents of x, y and z, and the coefficient. The last coefficient is 0. */
typedef const int quartic_terms[8][4];

static struct surface quartic_of(quartic_terms terms)
{
    struct surface surface = one(PRIMITIVE_QUARTIC);
    for (; (*terms)[3] != 0; terms++)
        set_coefficient(&surface, (*terms)[0], (*terms)[1], (*terms)[2], (*terms)[3]);
    return surface;
}

/* x^2 y^2 + y^2 z^2 + z^2 x^2 = x y z */
static quartic_terms roman_terms = {
    { 2, 2, 0, 1 }, { 0, 2, 2, 1 }, { 2, 0, 2, 1 }, { 1, 1, 1, -1 }
};

/* 4 x^2 (x^2 + y^2 + z^2 + z) + y^2 (y^2 + z^2 - 1) = 0 */
static quartic_terms cross_cap_terms = { { 4, 0, 0, 4 }, { 2, 2, 0, 4 }, { 2, 0, 2, 4 },
                                         { 2, 0, 1, 4 }, { 0, 4, 0, 1 }, { 0, 2, 2, 1 },
                                         { 0, 2, 0, -1 } };

/* From the triple point the distance is t = lmn / (l^2 m^2 + m^2 n^2 + n^2 l^2). */
TEST(roman_from_the_triple_point)
{
    struct surface roman = quartic_of(roman_terms);
    uint64_t random = RANDOM_SEED;
    for (int i = 0; i < 2000; i++) {
        struct ray ray = { { 0 }, { 0 } };
        random_direction(&random, ray.direction);
        double l = ray.direction[0], m = ray.direction[1], n = ray.direction[2];
        double t = l * m * n / (l * l * m * m + m * m * n * n + n * n * l * l);
        if (fabs(t) < 1e-4) /* near a double line */
            continue;
        double found = shoot(&roman, &ray).distance;
        if (t > 0)
            assert_near(found, t, 1e-12);
        else
            assert_true(isinf(found));
    }
}

TEST(roman_volume)
{
    struct surface roman = quartic_of(roman_terms);
    assert_near(volume(&roman, .6), 1. / 6, 1e-3);
}

/* ---- Surfaces of Steiner patches ----------------------------------------- */

/* The quadratic forms x, y, z and w: coefficients of s^2 t^2 u^2 2st 2tu 2su. */
typedef double four_forms[4][STEINER_POINTS];

static const four_forms roman_forms = {
    { 0, 0, 0, 0, .5, 0 },
    { 0, 0, 0, 0, 0, .5 },
    { 0, 0, 0, .5, 0, 0 },
    { 1, 1, 1, 0, 0, 0 },
};
static const four_forms sphere_forms = {
    { 0, 0, 0, 0, 0, 1 },
    { 0, 0, 0, 0, 1, 0 },
    { 1, 1, -1, 0, 0, 0 },
    { 1, 1, 1, 0, 0, 0 },
};
static const four_forms cross_cap_forms = {
    { 0, 0, 0, 0, .5, 0 },
    { 0, 0, 0, 1, 0, 0 },
    { 1, -1, 0, 0, 0, 0 },
    { 1, 1, 1, 0, 0, 0 },
};

static const int pairs[STEINER_POINTS][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 },
                                              { 0, 1 }, { 1, 2 }, { 0, 2 } };

static double polar_value(const double form[STEINER_POINTS], const double a[3],
                          const double b[3])
{
    double sum = 0;
    for (int k = 0; k < STEINER_POINTS; k++) {
        int i = pairs[k][0], j = pairs[k][1];
        sum += form[k] * a[i] * b[j];
        if (i != j)
            sum += form[k] * a[j] * b[i];
    }
    return sum;
}

/* Makes a patch whose domain is the triangle of three points in the parameter plane. */
static void put_patch(struct primitive *patch, const four_forms forms,
                      const double corners[3][3])
{
    patch->kind = PRIMITIVE_STEINER_PATCH;
    for (int k = 0; k < STEINER_POINTS; k++) {
        const double *a = corners[pairs[k][0]];
        const double *b = corners[pairs[k][1]];
        double w = polar_value(forms[3], a, b);
        assert_true(w > 0);
        patch->shape.steiner_patch.weights[k] = w;
        for (int i = 0; i < 3; i++)
            patch->shape.steiner_patch.points[k][i] = polar_value(forms[i], a, b) / w;
    }
}

/* Covers all s, t and u by four octants, each of which is divided into four patches, so
 * that all weights are positive. */
static struct surface whole(const four_forms forms)
{
    static const double corner[6][3] = { { 1, 0, 0 },   { 0, 1, 0 },   { 0, 0, 1 },
                                         { 0, .5, .5 }, { .5, 0, .5 }, { .5, .5, 0 } };
    static const int triangles[4][3] = {
        { 0, 5, 4 }, { 5, 1, 3 }, { 4, 3, 2 }, { 3, 4, 5 }
    };
    struct surface surface = { .count = 0 };
    for (int octant = 0; octant < 4; octant++)
        for (int k = 0; k < 4; k++) {
            double corners[3][3];
            for (int i = 0; i < 3; i++) {
                copy(corners[i], corner[triangles[k][i]]);
                corners[i][0] *= octant & 1 ? -1 : 1;
                corners[i][1] *= octant & 2 ? -1 : 1;
            }
            put_patch(&surface.parts[surface.count++], forms,
                      (const double(*)[3])corners);
        }
    return surface;
}

TEST(two_ways)
{
    struct surface roman = quartic_of(roman_terms), cap = quartic_of(cross_cap_terms);
    struct surface roman_patches = whole(roman_forms);
    struct surface cap_patches = whole(cross_cap_forms);
    struct surface ball_patches = whole(sphere_forms);
    struct surface ball = one(PRIMITIVE_SPHERE);
    ball.parts[0].shape.sphere.radius = 1;
    assert_same_surface(&roman, &roman_patches, .5);
    assert_same_surface(&cap, &cap_patches, .8);
    assert_same_surface(&ball, &ball_patches, 1);
}

/* ---- Patches ------------------------------------------------------------ */

static void random_patch(uint64_t *random, struct primitive *patch)
{
    static const double corner[3][2] = { { 1, 0 }, { 0, 1 }, { 0, 0 } };
    patch->kind = PRIMITIVE_STEINER_PATCH;
    for (int k = 0; k < STEINER_POINTS; k++) {
        double *point = patch->shape.steiner_patch.points[k];
        for (int i = 0; i < 3; i++)
            point[i] = number_between(random, -.4, .4);
        for (int i = 0; i < 2; i++)
            point[i] += (corner[pairs[k][0]][i] + corner[pairs[k][1]][i]) / 2;
        patch->shape.steiner_patch.weights[k] = number_between(random, .3, 3);
    }
}

static void point_of(const struct primitive *patch, const double p[3], double point[3])
{
    double weight = 0, sum[3] = { 0 };
    for (int k = 0; k < STEINER_POINTS; k++) {
        int i = pairs[k][0], j = pairs[k][1];
        double share = patch->shape.steiner_patch.weights[k] * p[i] * p[j]
                       * (i == j ? 1 : 2);
        add_scaled(sum, sum, share, patch->shape.steiner_patch.points[k]);
        weight += share;
    }
    scale_by(sum, 1 / weight);
    copy(point, sum);
}

/* Aims a random ray at a point of the patch. It must cross the patch there. All other
 * crossings must also be on the patch. */
static void assert_round_trip(uint64_t *random, const struct primitive *patch)
{
    double s = number_between(random, 0, 1);
    double t = number_between(random, 0, 1 - s);
    const double p[3] = { s, t, 1 - s - t };
    struct crossing crossings[MAX_CROSSINGS];
    double point[3];
    struct ray ray;
    bool found = false;
    point_of(patch, p, point);
    random_direction(random, ray.origin);
    scale_by(ray.origin, number_between(random, 1, 20));
    add_scaled(ray.direction, point, -1, ray.origin);
    size_t count = plain_crossings(patch, &ray, crossings);
    for (size_t i = 0; i < count; i++)
        found = found || fabs(crossings[i].distance - 1) < 1e-11;
    FAIL_IF(!found, "no crossing at %.17g, %.17g of %zu", s, t, count);
}

TEST(round_trips)
{
    uint64_t random = RANDOM_SEED;
    for (int i = 0; i < 200; i++) {
        struct primitive patch;
        random_patch(&random, &patch);
        for (int k = 0; k < 20; k++)
            assert_round_trip(&random, &patch);
    }
}
