/* test_scene_shapes.c - the scene language. The fields of spheres, discs, tori,
 * quadrics, quartics, patches, prisms and lathes, and the conditions of a text, are
 * compared with expected values. A wrong field, or an error at another position, fails
 * here. */
#include "tests/unit/scene_reading.h"

/* ---- Shapes ------------------------------------------------------------- */

/* Writes the name, the first `count` numbers and the flags of a primitive. */
static void describe(const struct primitive *primitive, size_t count, char *to)
{
    const double *numbers = (const double *)&primitive->shape;
    enum primitive_kind kind = primitive->kind;
    to += sprintf(to, "%s", primitive_kind_name(kind));
    for (size_t i = 0; i < count; i++)
        to += sprintf(to, " %.17g", numbers[i] + 0); /* -0 becomes 0 */
    if ((kind == PRIMITIVE_CYLINDER && primitive->shape.cylinder.open)
        || (kind == PRIMITIVE_CONE && primitive->shape.cone.open))
        to += sprintf(to, " open");
    sprintf(to, "%s%s%s", primitive->transformed ? " moved" : "",
            primitive->no_shadow ? " no_shadow" : "",
            primitive->inverted ? " inverted" : "");
}

/* Each row has a text, and the name, numbers and flags of its primitive. */
TEST(shapes)
{
    static const struct {
        size_t numbers;
        const char *text, *shape;
    } rows[] = {
        { 4, "sphere { <1, 2, 3>, -2 }", "sphere 1 2 3 2" },
        { 6, "box { <1, -1, 1>, <-1, 1, -2> }", "box -1 -1 -2 1 1 1" },
        { 7, "cylinder { 0, 2*y, .5 open }", "cylinder 0 0 0 0 2 0 0.5 open" },
        { 7, "cylinder { 0, 2*y, .5 no_shadow }",
          "cylinder 0 0 0 0 2 0 0.5 no_shadow" },
        { 8, "cone { <1, 2, 3>, 2, 5*y, 0 }", "cone 1 2 3 2 0 5 0 0" },
        { 8, "cone { 0, 0, x, .5 open no_shadow scale 2 }",
          "cone 0 0 0 0 1 0 0 0.5 open moved no_shadow" },
        /* equal radii */
        { 7, "cone { -x, 1.5, x, 1.5 open }", "cylinder -1 0 0 1 0 0 1.5 open" },
        { 8, "disc { <1, 2, 3>, -2*z, 2, .5 }", "disc 1 2 3 0 0 -1 2 0.5" },
        { 8, "disc { y x, -1 scale 2 }", "disc 0 1 0 1 0 0 1 0 moved" },
        { 8, "disc { 0, y, 1, -.5 inverse }", "disc 0 0 0 0 1 0 1 0.5 inverted" },
        { 2, "torus { 2, .5 sturm rotate 90*x }", "torus 2 0.5 moved" },
        { 2, "torus { .5 1 sturm off pigment { rgb 1 } }", "torus 0.5 1" },
        { 3, "elliptical_torus { 3, .4, .2 }",
          "elliptical_torus 3 0.40000000000000002 0.20000000000000001" },
        { 10, "quadric { <1, 2, 3>, <4, 5, 6>, <7, 8, 9>, -1 translate x }",
          "quadric 1 2 3 4 5 6 7 8 9 -1 moved" },
        { 35,
          "quartic { <1, 2 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,"
          " 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, -2*sqrt(4)> sturm }",
          "quartic 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27"
          " 28 29 30 31 32 33 34 -4" },
        { 24, "steiner_patch { <4, 0, 1>, 2*y, 0, <1, 2, 3>, y, x }",
          "steiner_patch 4 0 1 0 2 0 0 0 0 1 2 3 0 1 0 1 0 0 1 1 1 1 1 1" },
        { 24,
          "#declare A = <4, 0, 1>; steiner_patch { A, 2*y, 0, <1, 2, 3>, y, x"
          " weights 1, 2, 3 .5, 1/4, 6 scale 2 }",
          "steiner_patch 4 0 1 0 2 0 0 0 0 1 2 3 0 1 0 1 0 0 1 2 3 0.5 0.25 6 moved" },
    };
    char text[4000] = "", found[500];
    for (size_t i = 0; i < COUNT(rows); i++)
        strcat(strcat(text, rows[i].text), "\n");
    SCOPED(scene) *scene = read_scene(text);
    assert_int_equal(scene->primitive_count, COUNT(rows));
    for (size_t i = 0; i < COUNT(rows); i++) {
        describe(&scene->primitives[i], rows[i].numbers, found);
        assert_string_equal(found, rows[i].shape);
        assert_int_equal(scene->primitives[i].line, i + 1);
    }
}

/* The distance of a plane is measured along its unit normal. */
TEST(planes)
{
    SCOPED(scene) *scene = read_scene("plane { <0, 3, 4>, 2 }");
    assert_vector(scene->primitives->shape.plane.normal, 0, .6, .8);
    assert_close(scene->primitives->shape.plane.distance, 2, 0);
}

/* Heights are sorted. Loops are closed, without repeats. Empty loops are omitted. */
TEST(prisms)
{
    SCOPED(scene) *scene = read_scene(
        "prism { linear_spline linear_sweep 2, -1, 12, <0, 0>, <1, 0>, <1, 0>, <0, 1>, "
        "<0, 1e-11>, <5, 5>, <6, 5>, <5, 5>, <2, 2>, <3, 2>, <3, 3>, <2, 3> }\n"
        "prism { 0, 1, 3, <0, 0> <1, 0> <0, 1> open translate x }\n"
        "#declare P = prism { 0, 1, 4, x, 2*x, <2, 2>, x }\n"
        "object { P } object { P scale 2 }");
    const struct primitive *p = scene->primitives;
    const struct outline *path = &p[0].shape.prism.path;
    static const double expected[][2] = {
        { 0, 0 }, { 1, 0 }, { 0, 1 }, { 0, 0 }, { 2, 2 },
        { 3, 2 }, { 3, 3 }, { 2, 3 }, { 2, 2 },
    };
    assert_int_equal(scene->primitive_count, 4);
    assert_int_equal(p[0].kind, PRIMITIVE_PRISM);
    assert_close(p[0].shape.prism.low, -1, 0);
    assert_close(p[0].shape.prism.high, 2, 0);
    assert_false(p[0].shape.prism.open);
    assert_int_equal(path->count, COUNT(expected));
    assert_numbers("path", path->points[0], expected[0], 2 * path->count, 0);
    assert_true(p[1].shape.prism.open && p[1].transformed);
    assert_int_equal(p[1].shape.prism.path.count, 4);
    assert_int_equal(p[2].shape.prism.path.count, 4);
    assert_close(p[3].shape.prism.path.points[1][0], 2, 0);
}

/* The first point of a loop only defines a direction. Between two further points is the
 * handle of their parabola. As in POV-Ray, a last point alone is ignored. */
TEST(quadratic_prisms)
{
    SCOPED(scene) *scene = read_scene(
        "prism { quadratic_spline linear_sweep 1, -1, 11, <0, 4>, <0, 0>, <4, 0>, <4, "
        "4>, <1e-11, 0>, <7, 1>, <5, 5>, <9, 5>, <5, 9>, <5, 5>, <8, 8> }\n"
        "prism { linear_sweep quadratic_spline 0, 1, 5, x, 0, x, x + y, 0 open }\n");
    const struct primitive *p = scene->primitives;
    const struct outline *path = &p[0].shape.quadratic_prism.path;
    static const double expected[][2] = {
        { 0, 0 }, { 1, -1 },  { 4, 0 }, { 5, 1 }, { 4, 4 }, { 3, 4 }, { 0, 0 },
        { 5, 5 }, { 5.5, 6 }, { 9, 5 }, { 9, 6 }, { 5, 9 }, { 4, 9 }, { 5, 5 },
    };
    assert_int_equal(scene->primitive_count, 2);
    assert_int_equal(p[0].kind, PRIMITIVE_QUADRATIC_PRISM);
    assert_close(p[0].shape.quadratic_prism.low, -1, 0);
    assert_false(p[0].shape.quadratic_prism.open);
    assert_int_equal(path->count, COUNT(expected));
    assert_numbers("path", path->points[0], expected[0], 2 * path->count, 0);
    assert_int_equal(p[1].kind, PRIMITIVE_QUADRATIC_PRISM);
    assert_true(p[1].shape.quadratic_prism.open);
}

/* Repeated points are omitted. A last point near the first is set to it. */
TEST(lathes)
{
    SCOPED(scene) *scene = read_scene(
        "lathe { linear_spline 6, <1, 0>, <1, 1e-11>, <2, 0>, <2, 1>,"
        " <2, 1>, <1, 1e-12> }\n"
        "lathe { 2.7 <1, 0> <0, 1> sturm translate x }\n");
    const struct primitive *p = scene->primitives;
    const struct outline *path = &p[0].shape.lathe.path;
    static const double expected[][2] = { { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 0 } };
    assert_int_equal(scene->primitive_count, 2);
    assert_int_equal(p[0].kind, PRIMITIVE_LATHE);
    assert_int_equal(path->count, COUNT(expected));
    assert_numbers("path", path->points[0], expected[0], 2 * path->count, 0);
    assert_true(p[1].transformed);
    assert_int_equal(p[1].shape.lathe.path.count, 2);
}

/* Texts with one error each, its column and a part of its message. */
static const struct line_error errors[] = {
    { "cone { 0, 1, y }", 16, "expected a number" },
    { "cone { 0, 1, y, 0 opened }", 19, "found 'opened'" },
    { "disc { 0, y }", 13, "expected a number" },
    { "disc { 0, y, 2, 1, 1 }", 18, "found ','" },
    { "torus { 1 }", 11, "expected a number" },
    { "torus { 1, y }", 12, "found 3" },
    { "elliptical_torus { 1, 1 }", 25, "expected a number" },
    { "quadric { x, y, 1 }", 19, "expected a number" },
    { "quadric { <1, 2, 3, 4>, 0, 0, 1 }", 11, "a vector of 3" },
    { "quartic { <1, 2, 3> }", 11, "expected 35 coefficients, found 3" },
    { "quartic { 1, 2, 3 }", 11, "expected '<'" },
    { "quartic { <1, 2, y> }", 18, "found 3" },
    { "quartic { <0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,"
      "0,0,0,0,0,0,0,0,0,0,1> }",
      11, "35 coefficients, found 36" },
    { "prism { 0, 1, 2, <0, 0>, <1, 0> }", 15, "three points" },
    { "prism { 0, 1, 3, <0, 0>, <1, 0> }", 33, "expected a number" },
    { "prism { 0, 1, 2001, <0, 0> }", 15, "more than 2000 points" },
    { "prism { conic_sweep 0, 1, 3, <0, 0>, <1, 0>, <0, 1> }", 9,
      "'conic_sweep' is not supported" },
    { "prism { linear_sweep bezier_spline 0, 1, 4, x, y, z, 0 }", 22,
      "'bezier_spline' is not supported" },
    { "prism { quadratic_spline 0, 1, 4, <0, 1>, <0, 0>, <1, 0>, <0, 0> }", 9,
      "five points" },
    { "prism { quadratic_spline 0, 1, 5, <0, 1>, <0, 0>, <1, 0>, <1, 1>, <0, 1> }", 9,
      "does not return" },
    { "prism { quadratic_spline 0, 1, 7, <0, 1>, <0, 0>, <1, 0>, <1, 1>,"
      " <0, 0>, <2, 2>, <3, 3> }",
      9, "does not return" },
    { "prism { quadratic_spline conic_sweep 0, 1, 3, x, y, z }", 26,
      "'conic_sweep' is not supported" },
    { "prism { linear_sweep cubic_spline 0, 1, 4, x, y, z, 0 }", 22,
      "'cubic_spline' is not supported" },
    { "lathe { 1, <1, 0> }", 9, "two points" },
    { "lathe { linear_spline 3, <0, 0>, <1, 0> }", 41, "expected a number" },
    { "lathe { 2001, <0, 0> }", 9, "more than 2000 points" },
    { "lathe { quadratic_spline 3, <0, 0>, <1, 0>, <1, 1> }", 9,
      "'quadratic_spline' is not supported" },
    { "lathe { cubic_spline 4, x, y, z, 0 }", 9, "'cubic_spline' is not supported" },
    { "lathe { bezier_spline 4, x, y, z, 0 }", 9, "'bezier_spline' is not supported" },
    { "lathe { 2, <1, 0>, <1, 1> open }", 27, "" },
    { "steiner_patch { x, y, z, 0, 0 }", 31, "expected a number" },
    { "steiner_patch { x, y, z, 0, 0, 0 weights 1, 1, 1, 1, 1 }", 56,
      "expected a number" },
    { "steiner_patch { x, y, z, 0, 0, 0 weights 1, 1, 1, 1, 0, 1 }", 54,
      "the weight must be above 0" },
    { "#declare steiner_patch = 1;", 10, "a keyword, not a name" },
    { "#ifdef A sphere { 0, } #end", 8, "expected '('" },
    { "#ifdef (1) sphere { 0, } #end", 9, "expected a name" },
    { "#ifndef (A sphere { 0, } #end", 12, "expected ')'" },
    { "#ifdef (A) #elseif 1 #end", 20, "expected '('" },
    { "#ifdef (A) #else #elseif (1) #end", 18, "'#elseif' without a" },
    { "sphere { 0, 1 } #else", 17, "'#else' without a matching '#if'" },
    { "#ifndef (A) #end #end", 18, "'#end' without a matching directive" },
    { "#ifdef (A) #else #else #end", 18, "'#else' without a matching" },
    { "sphere { 0, 1 } #ifdef (A) #else", 17, "has no matching '#end'" },
    { "#ifndef (A) sphere { 0, 1 }", 1, "'#ifndef' has no matching '#end'" },
    { "sphere { 0, #ifdef (A) 1 #end }", 31, "expected a number" },
};

TEST_CALL(errors, assert_errors(errors, COUNT(errors)))

/* ---- Conditions --------------------------------------------------------- */

/* Text that is skipped may contain all tokens of the language. */
TEST(conditions)
{
    static const struct {
        const char *text;
        double radius;
    } rows[] = {
        { "#ifdef (A) sphere { 0, 1 } #else sphere { 0, 2 } #end", 1 },
        { "#ifndef (A) sphere { 0, 1 } #else sphere { 0, 2 } #end", 2 },
        { "#ifdef (B) wibble { ( #else sphere { 0, 3 } #end", 3 },
        { "#ifndef (B) sphere { 0, 3 } #else } #end", 3 },
        { "#ifdef (steiner_patch) sphere { 0, 4 } #end", 4 },
        { "#ifdef (elliptical_torus) sphere { 0, 5 } #end", 5 },
        { "#ifdef (sphere) wibble #else sphere { 0, 6 } #end", 6 },
        { "#ifndef (B) #ifdef (A) sphere { 0, 7 } #end #else { #end", 7 },
        { "#ifdef (B) #ifdef (A) { #else { #end { #else sphere { 0, 8 } #end", 8 },
        { "#ifdef (B) #macro M(x) #if (x) { #end #end #while (1) #end #else\n"
          "sphere { 0, 9 } #end",
          9 },
        { "sphere { #ifdef (B) x, #end 0, 2 #ifdef (A) scale 5 #end }", 2 },
        { "union { #ifdef (A) sphere { 0, 2 } #else box { 0, 1 } #end "
          "light_source { 0, 1 } }",
          2 },
        { "#ifdef (B) #declare C = 1; #else #declare C = 2; #end\n"
          "sphere { 0, C }",
          2 },
        { "#undef A #ifdef (A) sphere { 0, 1 } #end sphere { 0, 2 }", 2 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_format("#declare A = 1;\n%s", rows[i].text);
        assert_int_equal(scene->primitive_count, 1);
        assert_close(scene->primitives->shape.sphere.radius, rows[i].radius, 0);
    }
}

TEST(many_conditions)
{
    FREED char *text = repeated("", "#ifndef (A) ", 550);
    assert_refused(text, 201, "more than 500");
}
