/* test_scene_invisible.c - invisible shapes. The reports and the frames are compared
 * with the scene without the shapes. A shape that is reported twice, or is not the
 * empty set in a solid, fails here. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

#include "tests/unit/scene_reading.h"

#define ZEROS_10 "0, 0, 0, 0, 0, 0, 0, 0, 0, 0"

/* Shapes that are invisible, without the last brace. P and Q are points, and R is a
 * positive number. */
static const struct {
    enum primitive_kind kind;
    const char *text;
} invisible_shapes[] = {
    { PRIMITIVE_SPHERE, "sphere { P, 0" },
    { PRIMITIVE_BOX, "box { P, P" },
    { PRIMITIVE_BOX, "box { P, P + R*y" },
    { PRIMITIVE_CYLINDER, "cylinder { P, Q, 0" },
    { PRIMITIVE_CYLINDER, "cylinder { P, P, R" },
    { PRIMITIVE_CYLINDER, "cylinder { P, P, R open" },
    { PRIMITIVE_DISC, "disc { P, Q, 0" },
    { PRIMITIVE_DISC, "disc { P, 0, R" },
    { PRIMITIVE_DISC, "disc { P, Q, R, R + 1" },
    { PRIMITIVE_CONE, "cone { P, 0, Q, 0" },
    { PRIMITIVE_CONE, "cone { P, R, P, 0" },
    { PRIMITIVE_CONE, "cone { P, -R, Q, 1" },
    { PRIMITIVE_CONE, "cone { P, -R, Q, -R open" },
    { PRIMITIVE_CONE, "cone { P, R, P, R open" },
    { PRIMITIVE_QUADRIC, "quadric { 0, 0, 0, 0" },
    { PRIMITIVE_QUADRIC, "quadric { 0, 0, 0, R" },
    { PRIMITIVE_QUADRIC, "poly { 2, <" ZEROS_10 ">" },
    { PRIMITIVE_TORUS, "torus { -R, .2" },
    { PRIMITIVE_TORUS, "torus { R, 0" },
    { PRIMITIVE_TORUS, "torus { R, -.2" },
    { PRIMITIVE_ELLIPTICAL_TORUS, "elliptical_torus { 0, R, R" },
    { PRIMITIVE_ELLIPTICAL_TORUS, "elliptical_torus { R, 0, R" },
    { PRIMITIVE_ELLIPTICAL_TORUS, "elliptical_torus { R, R, 0" },
    { PRIMITIVE_QUARTIC, "cubic { <" ZEROS_10 ", " ZEROS_10 ">" },
    { PRIMITIVE_QUARTIC, "poly { 3, <" ZEROS_10 ", " ZEROS_10 ">" },
    { PRIMITIVE_QUARTIC,
      "quartic { <" ZEROS_10 ", " ZEROS_10 ", " ZEROS_10 ", 0, 0, 0, 0, R>" },
    { PRIMITIVE_STEINER_PATCH, "steiner_patch { P, P, P, P, P, P" },
    { PRIMITIVE_PRISM, "prism { R, R, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> open" },
    { PRIMITIVE_PRISM, "prism { 0, R, 3, <1, 2>, <1, 2>, <1, 2>" },
    { PRIMITIVE_PRISM, "prism { 0, R, 4, <R, 2>, <1, 2>, <R, 2>, <1, 2>" },
    { PRIMITIVE_PRISM, "text { ttf \"timrom.ttf\" \" \" 1, 0" },
    { PRIMITIVE_QUADRATIC_PRISM, "prism { quadratic_spline R, R, 5, <0, 1>,"
                                 " <0, 0>, <1, 0>, <1, 1>, <0, 0> open" },
    { PRIMITIVE_BLOB, "blob { threshold .5" },
    { PRIMITIVE_BLOB, "blob { threshold .5 sphere { P, 0, 1 }" },
    { PRIMITIVE_BLOB, "blob { threshold .5 sphere { P, R, 0 }" },
    { PRIMITIVE_BLOB, "blob { threshold .5 cylinder { P, Q, R, -1 }" },
    { PRIMITIVE_BLOB, "blob { threshold .5 component .2, R, P sphere { Q, R, .2 }" },
    { PRIMITIVE_BLOB, "blob { threshold -.5 sphere { P, R, 1 }" },
    { PRIMITIVE_BLOB, "blob { threshold 0 sphere { P, R, 1 }" },
    { PRIMITIVE_MESH, "mesh { triangle { P, P, Q } inside_vector y" },
    { PRIMITIVE_MESH, "mesh {" },
    { PRIMITIVE_MESH, "mesh { triangle { 0, x, 2*x }" },
    { PRIMITIVE_MESH,
      "mesh2 { vertex_vectors { 3 0 x 2*x } face_indices { 1 <0, 1, 2> }" },
    { PRIMITIVE_MESH, "triangle { 0, x, 2*x" },
    { PRIMITIVE_MESH, "bicubic_patch { type 1 0,0,0,0 0,0,0,0 0,0,0,0 0,0,0,0" },
    { PRIMITIVE_MESH,
      "bicubic_patch { type 1 x,x,x,x y,y,y,y x,x,x,x y,y,y,y scale 9" },
    { PRIMITIVE_MESH, "polygon { 4, 0, 0, 0, 0" },
    { PRIMITIVE_MESH, "mesh2 { vertex_vectors { 3, P, Q, P }"
                      " face_indices { 1, <0, 1, 2> }" },
    { PRIMITIVE_MESH, "triangle { P, Q, P" },
    { PRIMITIVE_MESH, "smooth_triangle { P, x, Q, y, P, z" },
    { PRIMITIVE_MESH, "polygon { 4, P, Q, 2*Q - P, P" },
    { PRIMITIVE_MESH, "bicubic_patch { type 1 flatness 0 u_steps 2 v_steps 2"
                      " P P P P P P P P P P P P P P P P" },
    { PRIMITIVE_MESH, "bicubic_patch { type 0 P Q P P P P P P Q P P P P P P "
                      "(P + Q)/2" },
    { PRIMITIVE_MESH, "height_field { function 3, 3 { .2 } water_level .5" },
    { PRIMITIVE_LATHE, "lathe { 3, <0, 0>, <0, 1>, <0, R>" },
    { PRIMITIVE_LATHE, "lathe { 3, <R, 1>, <R, 1>, <R, 1>" },
    { PRIMITIVE_LATHE, "lathe { 2, <R, 0>, <-R, 1>" },
};

#define VIEW HEAD "camera { location <1, 2, -4> look_at 0 }\n"
#define GROUND "plane { y, -1 pigment { rgb .5 } }\n"
#define BALL "sphere { 0, 1 pigment { rgb 1 }"

/* Texts before and after a shape. `ball` is true if the ball is visible. */
static const struct {
    const char *before, *after;
    bool ball;
} places[] = {
    { "", "}", false },
    { "", "inverse rotate 20*x }", false },
    { "union { " BALL "}", "} }", true },
    { "union { ", "} " BALL "} rotate 30*y }", true },
    { "merge { " BALL "}", "} }", true },
    { "difference { " BALL "}", "pigment { rgb x } } }", true },
    { "difference { ", "}" BALL "} }", false },
    { "intersection { " BALL "}", "} }", false },
    { "intersection { " BALL "} object { ", "} inverse } }", true },
    { "difference { " BALL "} object { ", "} inverse } }", false },
    { "#declare D = ", "} object { D } union { object { D } " BALL "} }", true },
    { "#declare D = difference { " BALL "}", "} } object { D inverse }", true },
    { "#declare D = intersection { " BALL "}",
      "} } difference { " BALL "} object { D } }", true },
    { "union { " BALL "} intersection { box { -1, 2 } union {",
      "} sphere { 0, .2 translate 9*x } } } }", true },
    { "light_source { <3, 9, -5>, 0 looks_like { ", "} } } " BALL "}", true },
};

static void scene_text(char *text, size_t size, size_t shape, size_t place)
{
    snprintf(text, size,
             VIEW GROUND "#declare P = <%g, %g, %g>; #declare Q = P + <%g, .3, %g>; "
                         "#declare R = %g;\n%s%s %s\n",
             between(-1, 1), between(-1, 1), between(-1, 1), between(.1, 1),
             between(-1, 1), between(.2, 1), places[place].before,
             invisible_shapes[shape].text, places[place].after);
}

static size_t count_reports(const struct diagnostics *reports)
{
    size_t count = 0;
    for (size_t i = 0; i < reports->count; i++)
        count += strstr(reports->items[i].message, "the shape is ignored") != NULL;
    return count;
}

static void check(size_t shape, size_t place, const struct words *expected)
{
    char text[2000];
    SCOPED_VALUE(diagnostics) reports = { 0 };
    scene_text(text, sizeof text, shape, place);
    SCOPED(scene) *scene = scene_read_text("invisible.pov", text, &reading_options,
                                           &reports);
    FAIL_IF(!scene, "is not read: %s\n%s", reports.items[0].message, text);
    FAIL_IF(count_reports(&reports) != 1 || (place == 0 && reports.count != 1),
            "%zu reports that the shape is ignored:\n%s", count_reports(&reports),
            text);
    FREED struct words *words = same_frame_of(scene, text);
    FAIL_IF(memcmp(words, expected, sizeof *words) != 0,
            "the frame is not that of the scene without:\n%s", text);
}

TEST(invisible)
{
    struct words *without[2];
    bool drawn[PRIMITIVE_KINDS] = { [PRIMITIVE_PLANE] = true }; /* an error */
    memcpy(traced.queues, (const size_t[]){ 40, 0 }, 2 * sizeof(size_t));
    for (int ball = 0; ball < 2; ball++)
        without[ball] = same_frame(ball ? VIEW GROUND BALL "}\n" : VIEW GROUND);
    for (size_t i = 0; i < COUNT(invisible_shapes); i++) {
        drawn[invisible_shapes[i].kind] = true;
        for (size_t place = 0; place < COUNT(places); place++)
            check(i, place, without[places[place].ball]);
    }
    for (int kind = 0; kind < PRIMITIVE_KINDS; kind++)
        assert_true(drawn[kind]);
    free(without[0]);
    free(without[1]);
}

/* Shapes without height or without a ring that are visible, and equal shapes. */
TEST(without_height)
{
    static const struct {
        const char *flat, *other;
    } rows[] = {
        { "torus { 0, .7", "sphere { 0, .7" },
        { "prism { .2, .2, 4, <-1, -1>, <1, -1>, <0, 1>, <-1, -1>",
          "triangle { <-1, .2, -1>, <1, .2, -1>, <0, .2, 1>" },
        { "prism { quadratic_spline .2, .2, 5, <0, 1>, <0, 0>, <1, 0>, <1, 1>, <0, 0>",
          "prism { quadratic_spline .2, .20001, 5, <0, 1>, <0, 0>, <1, 0>, "
          "<1, 1>, <0, 0>" },
        { "text { ttf \"timrom.ttf\" \"ab\" 0, 0 scale 3 translate -x",
          "text { ttf \"timrom.ttf\" \"ab\" 1e-5, 0 scale 3 translate -x" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        size_t seen[2];
        for (int k = 0; k < 2; k++) {
            FREED struct words *words = same_frame(
                formatted(VIEW "%s rotate <10, 20, 0> pigment { rgb 1 } }\n",
                          k ? rows[i].other : rows[i].flat));
            seen[k] = hits(words);
        }
        FAIL_IF(seen[0] != seen[1] || seen[0] == 0, "%zu pixels, not %zu: %s", seen[0],
                seen[1], rows[i].flat);
    }
}

/* As in POV-Ray, a scale of 0 counts as a scale of 1. */
TEST(flat)
{
    static const char *const rows[] = {
        "sphere { 0, 1 scale <1, 0, 1> }",
        "sphere { 0, 1 matrix <1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0> }",
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_with(rows[i], 1);
        assert_false(scene->primitives[0].transformed);
    }
}
