/* test_plain_solids.c - volumes of solids, computed from the plain tracer's crossings,
 * are compared with closed forms, also where faces coincide. A part that counts twice,
 * or a wrong complement, fails here. */
#include "tests/oracle/plain_regions.h"
#include "tests/random.h"
#include "tests/unit/scene_reading.h"

#define PI 3.14159265358979323846

/* The first region of a scene, and its crossings with a ray. */
struct solid {
    struct scene *scene;
    struct crossing_list *crossings;
};

static struct solid solid_with(const char *text, size_t reports)
{
    struct solid solid = { read_with(text, reports), NULL };
    solid.crossings = NON_NULL(crossing_list_new(solid.scene));
    assert_int_equal(solid.scene->region_count, 1);
    return solid;
}

static struct solid solid_of(const char *text)
{
    return solid_with(text, 0);
}

static void solid_free(struct solid *solid)
{
    crossing_list_free(solid->crossings);
    scene_free(solid->scene);
}

/* A line's crossings with a solid, coincident ones once, and its length inside. */
struct passage {
    int events;
    double length;
};

static struct passage pass(const struct solid *solid, const struct ray *ray)
{
    struct passage passage = { 0, 0 };
    struct plain_hit hit;
    double last = -1e6, entered = 0;
    bool inside = false;
    plain_cross_region(solid->crossings, solid->scene, solid->scene->regions, ray);
    while (plain_next_hit(solid->crossings, last, 1e6, &hit)) {
        assert_true(hit.entering != inside);
        inside = hit.entering;
        if (inside)
            entered = hit.distance;
        else
            passage.length += hit.distance - entered;
        last = hit.distance + 2 * PLAIN_DELTA;
        passage.events++;
    }
    assert_false(inside);
    return passage;
}

/* ---- Volumes ------------------------------------------------------------ */

/* Estimates the volume with parallel oblique rays through a grid from -size to size. */
static double volume(const struct solid *solid, double size)
{
    int steps = 200;
    const double across[2][3] = { { 2. / 3, -1. / 3, 2. / 3 },
                                  { 2. / 3, 2. / 3, -1. / 3 } };
    double sum = 0;
    for (int i = 0; i < steps; i++)
        for (int j = 0; j < steps; j++) {
            struct ray ray = { { 0 }, { -1. / 3, 2. / 3, 2. / 3 } };
            double u = (2 * i + 1. - steps) / steps * size;
            double v = (2 * j + 1. - steps) / steps * size;
            add_scaled(ray.origin, ray.origin, u, across[0]);
            add_scaled(ray.origin, ray.origin, v, across[1]);
            sum += pass(solid, &ray).length;
        }
    return sum * 4 * size * size / steps / steps;
}

static double lens(double r, double s, double d)
{
    double depth = r + s - d;
    return PI * depth * depth * (d * d + 2 * d * (r + s) - 3 * (r - s) * (r - s))
           / (12 * d);
}

#define TWO_BALLS "{ sphere { 0, 1 } sphere { .9*x, .8 } "

/* The error of the grid is at most two in a thousand. */
TEST(volumes)
{
    double both = lens(1, .8, .9);
    const struct {
        const char *text;
        double size, volume;
    } rows[] = {
        { "intersection { cylinder { -2*x, 2*x, 1 } cylinder { -2*y, 2*y, 1 } }", 1.8,
          16. / 3 },
        { "intersection { cylinder { -2*x, 2*x, 1 } cylinder { -2*y, 2*y, 1 } "
          "cylinder { -2*z, 2*z, 1 } }",
          1.3, 8 * (2 - sqrt(2)) },
        { "intersection " TWO_BALLS "}", 1.2, both },
        { "merge " TWO_BALLS "}", 1.8, 4 * PI / 3 * (1 + .512) - both },
        { "difference " TWO_BALLS "}", 1.2, 4 * PI / 3 - both },
        { "intersection { sphere { 0, 1 } cylinder { <.5, -2, 0>, <.5, 2, 0>, .5 } }",
          1.2, 2 * PI / 3 - 8. / 9 },
        { "intersection { cylinder { 0, y, 1 } plane { <-1, 1, 0>, 0 } }", 1.5,
          2. / 3 },
        { "intersection { sphere { 0, 1 } plane { -y, -.5 } }", 1.2,
          PI * .25 * 2.5 / 3 },
        /* A ring of height 1 has the same volume for every ball. */
        { "difference { sphere { 0, 1 } cylinder { -2*y, 2*y, sqrt(.75) } }", 1.1,
          PI / 6 },
        { "difference { sphere { 0, 2 } cylinder { -3*y, 3*y, sqrt(3.75) open } }", 2.1,
          PI / 6 },
        { "difference { box { 0, 3 } box { <1, 1, -1>, <2, 2, 4> } "
          "box { <1, -1, 1>, <2, 4, 2> } box { <-1, 1, 1>, <4, 2, 2> } "
          "translate -1.5 }",
          2.8, 20 },
        { "intersection { box { -1, 1 } sphere { 0, 1 inverse } }", 1.8,
          8 - 4 * PI / 3 },
        { "difference { torus { 1, .25 } plane { <1, 2, 3>, 0 } }", 1.4, PI * PI / 16 },
        { "intersection { elliptical_torus { 1, .2, .4 } plane { x, 0 } "
          "plane { z, 0 } }",
          1.5, PI * PI * .08 / 2 },
        { "intersection { cone { -y, 1, y, .5 } plane { z, 0 } }", 1.6, PI * 1.75 / 3 },
        { "difference { quadric { <1, 4, 1>, 0, 0, -1 } plane { <1, 1, 0>, 0 } }", 1.2,
          PI / 3 },
        { "intersection { plane { x, 0 } quartic { <1,0,0,0,0,0,0,0,0,"
          "0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,1,0,0,0,-1> } }",
          1.8, 4 * pow(tgamma(1.25), 3) / tgamma(1.75) },
        { "intersection { box { -1, 1 } quadric { <-1, -1, 0>, 0, 0, .25 } }", 1.8,
          8 - PI / 2 },
        /* De Morgan's rule: a point in neither part is outside of both. */
        { "difference { box { -3, 3 } union " TWO_BALLS "} }", 5.2,
          216 - 4 * PI / 3 * 1.512 + both },
        { "intersection { box { -3, 3 } intersection " TWO_BALLS "inverse } }", 5.2,
          216 - both },
        { "difference { sphere { 0, 1 } difference { sphere { .9*x, .8 } "
          "box { -4, 4 scale <1, 1, .001> } } }",
          1.2, 4 * PI / 3 - both + .008 * PI * .36 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(solid) solid = solid_of(rows[i].text);
        double found = volume(&solid, rows[i].size);
        FAIL_IF(!(fabs(found - rows[i].volume) <= .002 * rows[i].volume),
                "%s: volume %.6g, expected %.6g", rows[i].text, found, rows[i].volume);
    }
}

/* ---- Surfaces that coincide ---------------------------------------------- */

#define EYE "camera { location -z } "

#define CUBE "box { -1, 1 } "

TEST(coincident_faces)
{
    static const struct {
        const char *text;
        double x, y;
        int events;
        double length;
    } rows[] = {
        { "difference { " CUBE CUBE "}", .3, .2, 0, 0 },
        { "intersection { " CUBE CUBE "}", .3, .2, 2, 2 },
        { "merge { " CUBE CUBE "}", .3, .2, 2, 2 },
        { "merge { " CUBE "box { <-1, -1, 1>, <1, 1, 3> } }", .3, .2, 2, 4 },
        { "intersection { " CUBE "box { <-1, -1, 1>, <1, 1, 3> } }", .3, .2, 0, 0 },
        { "difference { " CUBE "box { <-.5, -.5, -1>, <.5, .5, 1> } }", .3, .2, 0, 0 },
        { "difference { " CUBE "box { <-.5, -.5, -1>, <.5, .5, 1> } }", .6, .2, 2, 2 },
        { "difference { " CUBE "box { <-.5, -.5, -1>, <.5, .5, 0> } }", .3, .2, 2, 1 },
        { "difference { " CUBE "box { -1.00000003, .99999998 } }", .3, .2, 0,
          0 }, /* at a distance below delta */
        { "merge { " CUBE "box { <-1, -1, 1.00000002>, <1, 1, 3> } }", .3, .2, 2, 4 },
        { EYE "intersection { plane { z, 5e-8 } plane { -z, 0 } }", 0, 0, 0, 0 },
        { EYE "intersection { plane { z, 1e-6 } plane { -z, 0 } }", 0, 0, 2, 1e-6 },
        { "difference { sphere { 0, 1 } sphere { 0, 1 } }", .3, .2, 0, 0 },
        { "difference { torus { 1, .3 } torus { 1, .3 } }", .9, .1, 0, 0 },
        { "intersection { sphere { -.5*z, .5 } sphere { .5*z, .5 } }", 0, 0, 0, 0 },
        { "merge { sphere { -.5*z, .5 } sphere { .5*z, .5 } }", 0, 0, 2, 2 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(solid) solid = solid_of(rows[i].text);
        const struct ray ray = { { rows[i].x, rows[i].y, -5 }, { 0, 0, 1 } };
        struct passage is = pass(&solid, &ray);
        FAIL_IF(is.events != rows[i].events
                    || !(fabs(is.length - rows[i].length) <= PLAIN_DELTA),
                "%s: %d events, inside for %.9g", rows[i].text, is.events, is.length);
    }
}

/* Two adjacent boxes. Every ray only crosses the outer surface. */
TEST(joined_boxes)
{
    SCOPED_VALUE(solid) pair = solid_of("merge { box { -1, 1 } "
                                        "box { <1, -1, -1>, <2, 1, 1> } "
                                        "rotate <10, 20, 30> }");
    SCOPED_VALUE(solid) whole = solid_of("box { -1, <2, 1, 1> rotate <10, 20, 30> }");
    uint64_t random = RANDOM_SEED;
    for (int i = 0; i < 2000; i++) {
        struct ray ray;
        for (int k = 0; k < 3; k++) {
            ray.origin[k] = (double)(xorshift(&random) >> 11) * 0x1p-51 - 2;
            ray.direction[k] = (double)(xorshift(&random) >> 11) * 0x1p-52 - 1;
        }
        normalise(ray.direction);
        struct passage a = pass(&pair, &ray), b = pass(&whole, &ray);
        assert_int_equal(a.events, b.events);
        assert_close(a.length, b.length, 1e-6);
    }
}

/* ---- Surfaces without inside --------------------------------------------- */

/* A patch in z = 0, and an open cylinder about z from -1 to 1. */
#define PATCH \
    "steiner_patch { <-2, -2, 0>, <2, -2, 0>, <0, 3, 0>, " \
    "<0, -2, 0>, <1, .5, 0>, <-1, .5, 0> }"
#define TUBE "cylinder { -z, z, .5 open }"
#define BALL " sphere { 0, .5 }"

TEST(open_surfaces)
{
    static const struct {
        const char *text;
        double x;
        int count;
        size_t reports; /* a patch cannot be cut like a solid */
    } rows[] = {
        { PATCH, 0, 1, 0 },
        { "merge { " PATCH BALL " }", 0, 2, 0 }, /* the patch is hidden in the ball */
        { "merge { " PATCH BALL " }", .7, 1, 0 },
        { "intersection { " PATCH BALL " }", 0, 1, 1 },
        { "intersection { " PATCH BALL " }", .7, 0, 1 },
        { "difference { " PATCH BALL " }", 0, 0, 1 },
        { "difference { " PATCH BALL " }", .7, 1, 1 },
        { "difference { box { -2, 2 } " TUBE " }", 0, 2, 0 }, /* the cylinder has no
                                                               * discs */
        { "difference { box { <-2, -2, 0>, 2 } " TUBE " }", 0, 1, 0 },
        { "intersection { box { <-2, -2, 0>, 2 } " TUBE " }", 0, 1, 0 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(solid) solid = solid_with(rows[i].text, rows[i].reports);
        const struct ray ray = { { rows[i].x, 0, -5 }, { 0, 0, 1 } };
        struct plain_hit hit;
        double last = -1e6;
        int count = 0;
        plain_cross_region(solid.crossings, solid.scene, solid.scene->regions, &ray);
        for (; plain_next_hit(solid.crossings, last, 1e6, &hit); count++)
            last = hit.distance;
        FAIL_IF(count != rows[i].count, "%s: not %d crossings", rows[i].text,
                rows[i].count);
    }
}
