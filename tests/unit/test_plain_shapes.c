/* test_plain_shapes.c - lines that cross cones, quadrics, tori, patches and triangles.
 * The plain tracer's crossings are compared with rays computed by hand, and with
 * volumes in closed form. A lost or doubled root fails here. */
#include "tests/oracle/plain_roots.h"
#include "tests/unit/plain_surface.h"
#include "tests/unit/scene_reading.h"

static struct surface surface_of(const char *text)
{
    SCOPED(scene) *scene = read_scene(text);
    return (struct surface){ .count = 1, .parts = { scene->primitives[0] } };
}

/* The radius is 3 at y = 0 and 1 at y = 4, which is a slope of 1 in 2. */
#define FRUSTUM "cone { 0, 3, 4*y, 1 }"
#define OPEN_FRUSTUM "cone { 0, 3, 4*y, 1 open }"

/* The apex is at the origin, and the base of radius 1 is at x = 1. The mirror image
 * beyond the apex does not belong to the cone. */
#define POINTED "cone { 0, 0, x, 1 }"

/* The surfaces y = x^2 + z^2, z = x y + 2 and y = 3. */
#define BOWL "quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 }"
#define SADDLE "quadric { 0, <1, 0, 0>, <0, 0, -1>, 2 }"
#define LEVEL "quadric { 0, 0, <0, 2, 0>, -6 }"

/* The tube of the lemon crosses the axis. It has an outer and an inner side. */
#define RING "torus { 2, .5 }"
#define LEMON "torus { .5, 1 }"
#define FLAT_RING "elliptical_torus { 2, .5, .25 }"

/* A triangle as a mesh, and as a patch with the midpoints of its edges. */
#define TRIANGLE "mesh { triangle { 4*x, 4*y, 0 } }"
#define PATCH "steiner_patch { 4*x, 4*y, 0, <2, 2, 0>, 2*y, 2*x }"

TEST(known)
{
    double c = 2 / sqrt(5), s = 1 / sqrt(5), h = sqrt(.5), t = sqrt(1. / 3);
    double x = .8 / .5, y = .6 / .25, l = sqrt(x * x + y * y);
    const struct {
        const char *text;
        struct expectation line;
    } rows[] = {
        { FRUSTUM, { { 9, 2, 0 }, { -2, 0, 0 }, 3.5, { c, s, 0 } } },
        { FRUSTUM, { { 0, 2, 0 }, { 0, 0, 1 }, 2, { 0, -s, -c } } },
        { FRUSTUM, { { 0, 7, 2 }, { 0, -1, 0 }, 5, { 0, s, c } } },
        { FRUSTUM, { { 9, 5, 0 }, { -1, 0, 0 }, 0, { 0 } } },
        { FRUSTUM, { { 9, -1, 0 }, { -1, 0, 0 }, 0, { 0 } } },
        /* parallel to the side */
        { FRUSTUM, { { 0, .5, 0 }, { -1, 2, 0 }, 1.375, { c, -s, 0 } } },
        { FRUSTUM, { { .5, 9, 0 }, { 0, -1, 0 }, 5, { 0, 1, 0 } } },
        { FRUSTUM, { { 2.5, -3, 0 }, { 0, 1, 0 }, 3, { 0, -1, 0 } } },
        { OPEN_FRUSTUM, { { .5, 9, 0 }, { 0, -1, 0 }, 0, { 0 } } },
        { OPEN_FRUSTUM, { { 2.5, -3, 0 }, { 0, 1, 0 }, 4, { -c, -s, 0 } } },
        { POINTED, { { .5, 9, 0 }, { 0, -1, 0 }, 8.5, { -h, h, 0 } } },
        { POINTED, { { -.5, 9, 0 }, { 0, -1, 0 }, 0, { 0 } } },
        { POINTED, { { -5, .25, 0 }, { 1, 0, 0 }, 5.25, { -h, h, 0 } } },
        { POINTED, { { 5, .25, 0 }, { -1, 0, 0 }, 4, { 1, 0, 0 } } },
        /* a single crossing */
        { BOWL, { { .5, 9, 0 }, { 0, -1, 0 }, 8.75, { -h, h, 0 } } },
        { BOWL, { { 9, 4, 0 }, { -1, 0, 0 }, 7, { 4 / sqrt(17), -1 / sqrt(17), 0 } } },
        { BOWL, { { 9, -1, 0 }, { -1, 0, 0 }, 0, { 0 } } },
        { SADDLE, { { 1, 1, 9 }, { 0, 0, -2 }, 3, { -t, -t, t } } },
        { SADDLE, { { 1, 9, 3 }, { 0, -1, 0 }, 8, { t, t, -t } } },
        { LEVEL, { { 1, 9, 0 }, { 0, -1, 0 }, 6, { 0, 1, 0 } } },
        { LEVEL, { { 1, 9, 0 }, { 1, 0, 0 }, 0, { 0 } } },
        { RING, { { 9, 0, 0 }, { -1, 0, 0 }, 6.5, { 1, 0, 0 } } },
        { RING, { { 0, 0, 0 }, { 2, 0, 0 }, .75, { -1, 0, 0 } } },
        { RING, { { 0, 0, 2 }, { 0, 0, 1 }, .5, { 0, 0, -1 } } },
        { RING, { { 0, 9, 2.3 }, { 0, -1, 0 }, 8.6, { 0, .8, .6 } } },
        { RING, { { 0, 9, 0 }, { 0, -1, 0 }, 0, { 0 } } },
        { RING, { { 9, .501, 0 }, { -1, 0, 0 }, 0, { 0 } } },
        { LEMON, { { .1, 9, 0 }, { 0, -1, 0 }, 9 - sqrt(.84), { -.4, sqrt(.84), 0 } } },
        { LEMON, { { .1, 0, 0 }, { 0, 1, 0 }, .8, { -.6, -.8, 0 } } },
        { FLAT_RING, { { 9, 0, 0 }, { -1, 0, 0 }, 6.5, { 1, 0, 0 } } },
        { FLAT_RING, { { 2, 9, 0 }, { 0, -1, 0 }, 8.75, { 0, 1, 0 } } },
        { FLAT_RING, { { 2.4, 9, 0 }, { 0, -1, 0 }, 8.85, { x / l, y / l, 0 } } },
        { FLAT_RING, { { 9, .251, 0 }, { -1, 0, 0 }, 0, { 0 } } },
        { PATCH, { { 1, 1, -5 }, { 0, 0, 1 }, 5, { 0, 0, -1 } } },
        { PATCH, { { 1, 2.9, 5 }, { 0, 0, -2 }, 2.5, { 0, 0, 1 } } },
        { PATCH, { { 1, 3.1, 5 }, { 0, 0, -2 }, 0, { 0 } } },
        { PATCH, { { -.1, 1, 5 }, { 0, 0, -2 }, 0, { 0 } } },
        { PATCH, { { 0, 0, 5 }, { .2, .2, -1 }, 5, { 0, 0, 1 } } },
        { TRIANGLE, { { 1, 1, -5 }, { 0, 0, 1 }, 5, { 0, 0, -1 } } },
        { TRIANGLE, { { 1, 2.9, 5 }, { 0, 0, -2 }, 2.5, { 0, 0, 1 } } },
        { TRIANGLE, { { 1, 3.1, 5 }, { 0, 0, -2 }, 0, { 0 } } },
        { TRIANGLE, { { -.1, 1, 5 }, { 0, 0, -2 }, 0, { 0 } } },
        { TRIANGLE, { { 1, -.1, 5 }, { 0, 0, -2 }, 0, { 0 } } },
        { TRIANGLE, { { 1, 1, 5 }, { 0, 0, 1 }, 0, { 0 } } },  /* behind the origin */
        { TRIANGLE, { { -1, 1, 0 }, { 1, 0, 0 }, 0, { 0 } } }, /* in its plane */
        /* just outside its plane */
        { TRIANGLE, { { -1, 1, 1e-9 }, { 1, 0, 0 }, 0, { 0 } } },
        { TRIANGLE, { { 0, 0, 5 }, { 0, 0, -1 }, 5, { 0, 0, 1 } } }, /* its corners */
        { TRIANGLE, { { 4, 0, 5 }, { 0, 0, -1 }, 5, { 0, 0, 1 } } },
        { TRIANGLE, { { 0, 4, 5 }, { 0, 0, -1 }, 5, { 0, 0, 1 } } },
        { TRIANGLE, { { 2, 2, 5 }, { 0, 0, -1 }, 5, { 0, 0, 1 } } }, /* its edges */
        { TRIANGLE, { { 0, 1, 5 }, { 0, 0, -1 }, 5, { 0, 0, 1 } } },
    };
    enum { SIDES = 6 }; /* the first rows are also valid for the open frustum */
    for (size_t i = 0; i < COUNT(rows) + SIDES; i++) {
        const char *text = i < COUNT(rows) ? rows[i].text : OPEN_FRUSTUM;
        const struct expectation *line = &rows[i % COUNT(rows)].line;
        SCOPED(scene) *scene = read_scene(text);
        struct surface surface = { .count = 1, .parts = { scene->primitives[0] } };
        struct ray ray;
        copy(ray.origin, line->origin);
        copy(ray.direction, line->direction);
        struct spelling found = shoot(&surface, &ray);
        bool good = line->distance == 0
                        ? isinf(found.distance)
                        : fabs(found.distance - line->distance) <= CLOSE;
        for (int k = 0; k < 3 && line->distance != 0; k++)
            good = good && fabs(found.normal[k] - line->normal[k]) <= CLOSE;
        FAIL_IF(!good, "row %zu, %s: a hit at %.17g", i, text, found.distance);
    }
}

TEST(volumes)
{
    struct surface round = surface_of("torus { 1, .25 }");
    struct surface flat = surface_of("elliptical_torus { 1, .4, .2 }");
    assert_near(volume(&round, 1.25), 2 * PI * PI * .0625, 1e-3);
    assert_near(volume(&flat, 1.4), 2 * PI * PI * .08, 1e-3);
}

/* (x^2 + y^2 + z^2 + 3/4)^2 = 4 (x^2 + z^2), which is R = 1 and r = 1/2, expanded. */
TEST(torus_in_other_ways)
{
    struct surface quartic = one(PRIMITIVE_QUARTIC);
    struct surface round = surface_of("torus { 1, .5 }");
    struct surface elliptical = surface_of("elliptical_torus { 1, .5, .5 }");
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
