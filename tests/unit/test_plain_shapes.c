/* test_plain_shapes.c - lines that cross cones, quadrics and tori: the plain tracer's
 * crossings are compared with rays computed by hand and volumes in closed form. A lost
 * or doubled root fails here. */
#include "tests/oracle/plain_roots.h"
#include "tests/unit/plain_surface.h"

/* ---- Cones -------------------------------------------------------------- */

/* Radius 3 at y = 0 and radius 1 at y = 4, a slope of 1 in 2. */
TEST(frustum)
{
    double c = 2 / sqrt(5), s = 1 / sqrt(5);
    const struct expectation both[] = {
        { { 9, 2, 0 }, { -2, 0, 0 }, 3.5, { c, s, 0 } },
        { { 0, 2, 0 }, { 0, 0, 1 }, 2, { 0, -s, -c } },
        { { 0, 7, 2 }, { 0, -1, 0 }, 5, { 0, s, c } },
        { { 9, 5, 0 }, { -1, 0, 0 }, 0, { 0 } },
        { { 9, -1, 0 }, { -1, 0, 0 }, 0, { 0 } },
        { { 0, .5, 0 }, { -1, 2, 0 }, 1.375, { c, -s, 0 } }, /* parallel to the side */
    };
    const struct expectation closed[] = {
        { { .5, 9, 0 }, { 0, -1, 0 }, 5, { 0, 1, 0 } },
        { { 2.5, -3, 0 }, { 0, 1, 0 }, 3, { 0, -1, 0 } },
    };
    const struct expectation open[] = {
        { { .5, 9, 0 }, { 0, -1, 0 }, 0, { 0 } },
        { { 2.5, -3, 0 }, { 0, 1, 0 }, 4, { -c, -s, 0 } },
    };
    struct surface cone = one(PRIMITIVE_CONE);
    cone.parts[0].shape.cone.base_radius = 3;
    cone.parts[0].shape.cone.cap[1] = 4;
    cone.parts[0].shape.cone.cap_radius = 1;
    ASSERT_HITS(&cone, both);
    ASSERT_HITS(&cone, closed);
    cone.parts[0].shape.cone.open = true;
    ASSERT_HITS(&cone, both);
    ASSERT_HITS(&cone, open);
}

/* The apex is at the origin, the base of radius 1 at x = 1. The mirror image beyond the
 * apex does not belong to the cone. */
TEST(pointed_cone)
{
    double h = sqrt(.5);
    const struct expectation rows[] = {
        { { .5, 9, 0 }, { 0, -1, 0 }, 8.5, { -h, h, 0 } },
        { { -.5, 9, 0 }, { 0, -1, 0 }, 0, { 0 } },
        { { -5, .25, 0 }, { 1, 0, 0 }, 5.25, { -h, h, 0 } },
        { { 5, .25, 0 }, { -1, 0, 0 }, 4, { 1, 0, 0 } },
    };
    struct surface cone = one(PRIMITIVE_CONE);
    cone.parts[0].shape.cone.cap[0] = 1;
    cone.parts[0].shape.cone.cap_radius = 1;
    ASSERT_HITS(&cone, rows);
}

/* ---- Quadrics ----------------------------------------------------------- */

static struct surface quadric(const double coefficients[QUADRIC_TERMS])
{
    struct surface surface = one(PRIMITIVE_QUADRIC);
    memcpy(surface.parts[0].shape.quadric.coefficients, coefficients,
           QUADRIC_TERMS * sizeof *coefficients);
    return surface;
}

TEST(quadrics)
{
    static const double paraboloid[] = { 1, 0, 1, 0, 0, 0, 0, -1, 0, 0 };
    static const double saddle[] = { 0, 0, 0, 1, 0, 0, 0, 0, -1, 2 };
    static const double plane[] = { 0, 0, 0, 0, 0, 0, 0, 2, 0, -6 };
    double h = sqrt(.5), t = sqrt(1. / 3);
    const struct expectation bowl[] = {
        { { .5, 9, 0 }, { 0, -1, 0 }, 8.75, { -h, h, 0 } }, /* a single crossing */
        { { 9, 4, 0 }, { -1, 0, 0 }, 7, { 4 / sqrt(17), -1 / sqrt(17), 0 } },
        { { 9, -1, 0 }, { -1, 0, 0 }, 0, { 0 } },
    };
    const struct expectation z_is_xy_and_2[] = {
        { { 1, 1, 9 }, { 0, 0, -2 }, 3, { -t, -t, t } },
        { { 1, 9, 3 }, { 0, -1, 0 }, 8, { t, t, -t } },
    };
    const struct expectation y_is_3[] = {
        { { 1, 9, 0 }, { 0, -1, 0 }, 6, { 0, 1, 0 } },
        { { 1, 9, 0 }, { 1, 0, 0 }, 0, { 0 } },
    };
    struct surface surface = quadric(paraboloid);
    ASSERT_HITS(&surface, bowl);
    surface = quadric(saddle);
    ASSERT_HITS(&surface, z_is_xy_and_2);
    surface = quadric(plane);
    ASSERT_HITS(&surface, y_is_3);
}

/* ---- Tori --------------------------------------------------------------- */

static struct surface torus(double major, double minor)
{
    struct surface surface = one(PRIMITIVE_TORUS);
    surface.parts[0].shape.torus.major = major;
    surface.parts[0].shape.torus.minor = minor;
    return surface;
}

static struct surface elliptical_torus(double major, double radial, double axial)
{
    struct surface surface = one(PRIMITIVE_ELLIPTICAL_TORUS);
    surface.parts[0].shape.elliptical_torus.major = major;
    surface.parts[0].shape.elliptical_torus.radial = radial;
    surface.parts[0].shape.elliptical_torus.axial = axial;
    return surface;
}

TEST(torus)
{
    const struct expectation ring[] = {
        { { 9, 0, 0 }, { -1, 0, 0 }, 6.5, { 1, 0, 0 } },
        { { 0, 0, 0 }, { 2, 0, 0 }, .75, { -1, 0, 0 } },
        { { 0, 0, 2 }, { 0, 0, 1 }, .5, { 0, 0, -1 } },
        { { 0, 9, 2.3 }, { 0, -1, 0 }, 8.6, { 0, .8, .6 } },
        { { 0, 9, 0 }, { 0, -1, 0 }, 0, { 0 } },
        { { 9, .501, 0 }, { -1, 0, 0 }, 0, { 0 } },
    };
    /* The tube passes the axis and has an outer and an inner side. */
    const struct expectation lemon[] = {
        { { .1, 9, 0 }, { 0, -1, 0 }, 9 - sqrt(.84), { -.4, sqrt(.84), 0 } },
        { { .1, 0, 0 }, { 0, 1, 0 }, .8, { -.6, -.8, 0 } },
    };
    struct surface surface = torus(2, .5);
    ASSERT_HITS(&surface, ring);
    surface = torus(.5, 1);
    ASSERT_HITS(&surface, lemon);
}

/* The normal of the ellipse at the angle a is (cos a / p, sin a / n). */
TEST(elliptical_torus)
{
    double x = .8 / .5, y = .6 / .25, l = sqrt(x * x + y * y);
    const struct expectation rows[] = {
        { { 9, 0, 0 }, { -1, 0, 0 }, 6.5, { 1, 0, 0 } },
        { { 2, 9, 0 }, { 0, -1, 0 }, 8.75, { 0, 1, 0 } },
        { { 2.4, 9, 0 }, { 0, -1, 0 }, 8.85, { x / l, y / l, 0 } },
        { { 9, .251, 0 }, { -1, 0, 0 }, 0, { 0 } },
    };
    struct surface surface = elliptical_torus(2, .5, .25);
    ASSERT_HITS(&surface, rows);
}

TEST(volumes)
{
    struct surface round = torus(1, .25);
    struct surface flat = elliptical_torus(1, .4, .2);
    assert_near(volume(&round, 1.25), 2 * PI * PI * .0625, 1e-3);
    assert_near(volume(&flat, 1.4), 2 * PI * PI * .08, 1e-3);
}

/* (x^2 + y^2 + z^2 + 3/4)^2 = 4 (x^2 + z^2), R = 1, r = 1/2, expanded. */
TEST(torus_in_other_ways)
{
    struct surface quartic = one(PRIMITIVE_QUARTIC);
    struct surface round = torus(1, .5);
    struct surface elliptical = elliptical_torus(1, .5, .5);
    for (int i = 0; i < 3; i++) {
        double inner = i == 1 ? 1.5 : 1.5 - 4;
        set_coefficient(&quartic, 4 * (i == 0), 4 * (i == 1), 4 * (i == 2), 1);
        set_coefficient(&quartic, 2 * (i != 0), 2 * (i != 1), 2 * (i != 2), 2);
        set_coefficient(&quartic, 2 * (i == 0), 2 * (i == 1), 2 * (i == 2), inner);
    }
    set_coefficient(&quartic, 0, 0, 0, .5625);
    assert_same_surface(&round, &quartic, 1.2);
    assert_same_surface(&round, &elliptical, 1.2);
}

/* ---- Roots -------------------------------------------------------------- */

TEST(roots)
{
    static const struct {
        long double c[5];
        size_t count;
        double roots[4];
    } rows[] = {
        { { 24, -50, 35, -10, 1 }, 4, { 1, 2, 3, 4 } },
        { { -6, 11, -6, 1, 0 }, 3, { 1, 2, 3 } },
        { { -1e12L, 0, 1, 0, 0 }, 2, { -1e6, 1e6 } },
        { { 3, -6, 0, 0, 0 }, 1, { .5 } },
        { { 1, 0, 0, 0, 1 }, 0, { 0 } },
        { { 0, 0, -3e-3L, 1, 0 }, 1, { 3e-3 } }, /* the root 0 is double */
        { { 5, 0, 0, 0, 0 }, 0, { 0 } },
        { { 0, 0, 0, 0, 0 }, 0, { 0 } },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        long double roots[HIGHEST_DEGREE];
        size_t count = plain_roots(rows[i].c, 4, roots);
        assert_true(count >= rows[i].count);
        for (size_t k = 0; k < rows[i].count; k++) {
            bool found = false;
            for (size_t j = 0; j < count; j++)
                found = found || fabsl(roots[j] / rows[i].roots[k] - 1) < 1e-14L;
            assert_true(found);
        }
    }
}
