/* test_bounds.c - the bounding spheres and boxes of random solids are compared with
 * points of the solids. A bound that excludes a point, or is much larger than
 * necessary, fails here. */
#include "tests/unit/scene_reading.h"

#include "rt/layout/bounds.h"
#include "rt/shapes/shape_bound.h"
#include "rt/scene/transform.h"
#include "rt/shapes/shape_bound.h"
#include "tests/oracle/plain_shapes.h"
#include "tests/unit/draw.h"

static struct bound first_bound(const char *text)
{
    SCOPED(scene) *scene = read_scene(text);
    FREED struct bound *bounds = calloc(scene->node_count, sizeof *bounds);
    assert_true(bound_nodes(scene, bounds));
    return bounds[0];
}

/* Shapes with the centre and radius of their smallest sphere, or without bound. */
TEST(known)
{
    static const struct {
        const char *text;
        double x, y, z, radius;
        double slack; /* allowed relative excess of the radius */
    } rows[] = {
        { "sphere { <1, 2, 3>, 2 }", 1, 2, 3, 2, .002 },
        { "sphere { x, 1 scale <1, 3, 1> }", 1, 0, 0, 3, .002 },
        { "box { 0, <2, 4, 4> }", 1, 2, 2, 3, .002 },
        { "box { -1, 1 scale <2, 4, 4> rotate <20, 30, 40> translate x }", 1, 0, 0, 6,
          .002 },
        { "cylinder { -4*y, 4*y, 3 }", 0, 0, 0, 5, .02 },
        { "cylinder { -y, y, 3 open scale <1, 4, 1> rotate 30 }", 0, 0, 0, 5, .02 },
        { "cone { 0, 3, 4*y, 0 }", 0, .875, 0, 3.125, .03 },
        { "torus { 3, 1 rotate 33 }", 0, 0, 0, 4, .002 },
        { "torus { 3, 1 scale <1, 2, 1> }", 0, 0, 0, 5, .002 },
        { "elliptical_torus { 3, .5, 2 translate z }", 0, 0, 1, 5, .002 },
        { "steiner_patch { 0, 2*x, <1, 1, 0>, x, <1.5, .5, 0>, <.5, .5, 0> }", 1, 0, 0,
          1, .03 },
        { "prism { -4, 4, 4, <3, 0>, <0, 3>, <-3, 0>, <0, -3> }", 0, 0, 0, 5, .02 },
        { "lathe { 4, <0, -4>, <3, -4>, <1, 0>, <3, 4> }", 0, 0, 0, 5, .02 },
        { "lathe { 3, <0, 0>, <3, 0>, <1, 1> }", 0, 0, 0, 3.06, .02 },
        { "blob { sphere { -3*x, 1, 2 } cylinder { x, 2*x, 2, 1 }"
          " sphere { 0, 9, -1 } }",
          0, 0, 0, 4, .002 },
        { "mesh { triangle { 0, 2*x, <1, 1, 0> }"
          " triangle { <1, 1, 0>, 0, <1, -1, 0> } }",
          1, 0, 0, 1, .03 },
        { "smooth_triangle { 0, y, 2*x, x, <1, 1, 0>, y scale 2 }", 2, 0, 0, 2, .03 },
        { "plane { y, 1 }", 0, 0, 0, BOUND_NONE, 0 },
        { "quadric { 1, 0, 0, -1 }", 0, 0, 0, BOUND_NONE, 0 },
        { "sphere { 0, 1e100 }", 0, 0, 0, BOUND_NONE, 0 },
        { "box { -1e100, 1e100 }", 0, 0, 0, BOUND_NONE, 0 },
        { "merge { sphere { -3*x, 1 } sphere { 2*x, 2 } }", 0, 0, 0, 4, .002 },
        { "merge { sphere { 0, 5 } sphere { 2*x, 2 } }", 0, 0, 0, 5, .002 },
        { "merge { sphere { 0, 5 } plane { y, 2 } }", 0, 0, 0, BOUND_NONE, 0 },
        { "intersection { sphere { 0, 5 } plane { y, 2 } sphere { x, 2 } }", 1, 0, 0, 2,
          .002 },
        { "difference { sphere { 0, 5 } sphere { x, 2 } }", 0, 0, 0, 5, .002 },
        { "disc { x, y, 2, 1 scale 2 }", 2, 0, 0, 4, .03 },
        { "intersection { disc { 0, y, 2 } sphere { 0, 5 } }", 0, 0, 0, 5, .002 },
        { "merge { disc { 0, y, 2 } sphere { 0, 5 } }", 0, 0, 0, BOUND_NONE, 0 },
        { "sphere { 0, 1 inverse }", 0, 0, 0, BOUND_NONE, 0 },
        { "intersection { plane { y, 1 } plane { x, 1 } }", 0, 0, 0, BOUND_NONE, 0 },
        { "intersection { merge { sphere { -3*x, 1 } sphere { 2*x, 2 } }"
          " difference { box { -9, 9 } sphere { 0, 1 } } }",
          0, 0, 0, 4, .002 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        struct bound bound = first_bound(rows[i].text);
        const double center[] = { rows[i].x, rows[i].y, rows[i].z };
        double within = rows[i].slack * rows[i].radius;
        for (int k = 0; k < 3; k++)
            assert_close(bound.center[k], center[k], within);
        FAIL_IF(bound.radius < rows[i].radius
                    || bound.radius > rows[i].radius * (1 + rows[i].slack),
                "%s: radius %.9g, expected %.9g", rows[i].text, bound.radius,
                rows[i].radius);
    }
}

TEST(known_boxes)
{
    static const struct {
        const char *text;
        double box[6]; /* the low corner, then the high corner */
    } rows[] = {
        { "sphere { <1, 2, 3>, 2 }", { -1, 0, 1, 3, 4, 5 } },
        { "box { <-1, 0, 2>, <3, 4, 5> rotate 90*y }", { 2, 0, -3, 5, 4, 1 } },
        { "cylinder { -4*y, 4*y, 1 rotate 90*z translate x }",
          { -3, -1, -1, 5, 1, 1 } },
        { "torus { 3, 1 scale <1, 2, 1> }", { -4, -2, -4, 4, 2, 4 } },
        { "mesh { triangle { <-1, 0, 2>, <3, 0, 2>, <0, 4, 5> }"
          " triangle { 0, y, z } translate x }",
          { 0, 0, 0, 4, 4, 5 } },
        { "merge { box { 0, 1 } box { <2, -1, 0>, <3, 1, 2> } }",
          { 0, -1, 0, 3, 1, 2 } },
        { "intersection { box { 0, 4 } box { <2, -1, 0>, <6, 1, 2> } }",
          { 2, 0, 0, 4, 1, 2 } },
        { "difference { box { 0, <4, 4, 1> } box { 1, 3 } }", { 0, 0, 0, 4, 4, 1 } },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        struct bound bound = first_bound(rows[i].text);
        for (int k = 0; k < 3; k++) {
            double slack = .02 * bound.radius;
            assert_true(bound.low[k] < rows[i].box[k]);
            assert_true(bound.high[k] > rows[i].box[3 + k]);
            assert_close(bound.low[k], rows[i].box[k], slack);
            assert_close(bound.high[k], rows[i].box[3 + k], slack);
        }
    }
}

/* Computes the crossings of a random line with a shape, in the shape's space, and
 * compares them in world space with the shape's bound. Returns their number. */
static size_t count_crossings(const struct primitive *primitive,
                              const struct bound *bound)
{
    struct crossing crossings[MAX_CROSSINGS];
    struct ray ray;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = between(-3, 3);
        ray.direction[i] = between(-3, 3) - ray.origin[i];
    }
    size_t count = plain_crossings(primitive, &ray, crossings);
    for (size_t i = 0; i < count; i++) {
        double point[3];
        point_on(&ray, crossings[i].distance, point);
        transform_point(&primitive->to_world, point);
        for (int k = 0; k < 3; k++)
            assert_true(bound->low[k] <= point[k] && point[k] <= bound->high[k]);
        add_scaled(point, point, -1, bound->center);
        assert_true(sqrt(dot(point, point)) <= bound->radius);
    }
    return count;
}

TEST(crossings)
{
    static const char *const shapes[] = {
        "sphere { <1, .5, 0>, 1.5",
        "box { <-1, 0, -2>, 1",
        "cylinder { -x, <1, 2, .5>, .8",
        "cylinder { 0, .1*y, 3 open",
        "cone { -x, 1.5, <0, 2, 1>, .2",
        "cone { 0, 0, z, 2 open",
        "torus { 1.5, .4",
        "torus { .5, 1",
        "elliptical_torus { 1.2, .3, 1",
        "elliptical_torus { 1.2, 1, .3",
        "prism { -1, 2, 5, <0, 0>, <2, 1>, <1, -1>, <-1, -2>, <0, 2> open",
        "prism { -1, 1, 3, <-2, 0>, <3, 0>, <3, 2>",
        ("prism { quadratic_spline -1, 1, 6, <1, -1>, <-2, 0>, <1, -2>,"
         " <1.5, .5>, <0, 2>, <-2, 0>"),
        "lathe { 5, <0, -2>, <1, -1>, <.3, .5>, <1.5, 1>, <0, 2>",
        "lathe { 3, <2, 0>, <.5, .1>, <.5, 1>",
        ("blob { threshold .1 sphere { 0, 1, 2 scale <1, 2, .5> rotate 40 }"
         " cylinder { -2*x, <1, 2, 1>, 1, 1 } sphere { y, 2, -.5 }"),
        ("mesh { triangle { <-2, 0, 1>, <2, -1, 0>, <0, 2, -1> }"
         " smooth_triangle { -y, y, 2*z, z, 2*x, x }"),
        ("steiner_patch { -2*x, 2*y, 2*x, <-2, 2, 1>, <2, 2, -1>, -2*y"
         " weights 1, 2, 1, .5, 3, 1"),
    };
    enum { PLACES = 20, LINES = 400 };
    for (size_t i = 0; i < COUNT(shapes) * PLACES; i++) {
        size_t count = 0;
        char text[400];
        snprintf(text, sizeof text,
                 "%s scale <%f, %f, %f> rotate <%f, %f, %f>"
                 " matrix <1, %f, 0, 0, 1, %f, 0, 0, 1, %f, 9, -5> }",
                 shapes[i % COUNT(shapes)], between(.2, 3), between(.2, 3),
                 between(-3, -.2), between(0, 360), between(0, 360), between(0, 360),
                 between(-2, 2), between(-2, 2), between(-9, 9));
        SCOPED(scene) *scene = read_scene(text);
        struct bound bound;

        bound_primitive(scene->primitives, &bound);
        assert_false(bound_is_none(&bound));
        for (int line = 0; line < LINES; line++)
            count += count_crossings(scene->primitives, &bound);
        FAIL_IF(count == 0, "no line crosses %s", text);
    }
}

/* The enclosing sphere contains all parts. Each pair of parts gives a lower bound of
 * the radius. The radius is at most 1.25 times this bound. */
TEST(enclose)
{
    enum { PARTS = 20, TRIES = 1000 };
    for (int try = 0; try < TRIES; try++) {
        struct bound parts[PARTS], whole;
        size_t count = 1 + xorshift(&random_state) % PARTS;
        double least = 0;
        for (size_t i = 0; i < count; i++) {
            parts[i].radius = between(0, 2);
            for (int k = 0; k < 3; k++) {
                parts[i].center[k] = between(-5, 5);
                parts[i].low[k] = parts[i].center[k] - parts[i].radius;
                parts[i].high[k] = between(parts[i].low[k], 7);
            }
        }
        bound_enclose(parts, count, &whole);
        for (size_t i = 0; i < count; i++) {
            double way[3];
            add_scaled(way, parts[i].center, -1, whole.center);
            assert_true(sqrt(dot(way, way)) + parts[i].radius <= whole.radius);
            for (int k = 0; k < 3; k++)
                assert_true(whole.low[k] <= parts[i].low[k]
                            && parts[i].high[k] <= whole.high[k]);
            for (size_t j = 0; j < count; j++) {
                add_scaled(way, parts[i].center, -1, parts[j].center);
                least = fmax(least,
                             (sqrt(dot(way, way)) + parts[i].radius + parts[j].radius)
                                 / 2);
            }
        }
        assert_true(whole.radius <= 1.25 * least);
    }
}
