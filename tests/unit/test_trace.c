/* test_trace.c - the frames of the scalar and the vector form of the tracer are
 * compared bit for bit, with several queue lengths. The scenes are random scenes of all
 * shapes with a formula, and scenes with rays for which a kernel has a separate branch.
 * A branch that only one form takes, or that rounds in another order, fails here. */
#include "tests/unit/random_solids.h"

static void add_shape(char *text, size_t size)
{
    static const char *const shapes[] = {
        "sphere { @2@, ^9.2:1^ ",
        "box { @2@, @2@",
        "plane { @1@, ^9-5:-3^ ",
        "cylinder { @2@, @2@, ^9.2:.8^ $2[|open ]",
    };
    size_t which = below(5);
    add_random(text, size, shapes[which < 3 ? which : 3]);
}

static void add_quadric_or_cone(char *text, size_t size)
{
    if (below(3) == 0) {
        add_random(text, size,
                   "quadric { <^6-1:1^, ^6-1:1^, ^6-1:1^>, @.5@, @1@, ^6-1:.3^ ");
        return;
    }
    add_random(text, size, "cone { @2@, ");
    add_text(text, size, "%.9f, ", below(3) == 0 ? 0 : between(.2, .8));
    add_random(text, size, "@2@, ^9.2:.8^ $2[|open ]");
}

/* Adds a torus or an elliptical torus. */
static void add_torus(char *text, size_t size)
{
    bool elliptical = below(2);
    add_random(text, size,
               elliptical ? "elliptical_torus { ^9.5:1.2^, ^9.1:.6^$., ^9.1:.6^"
                          : "torus { ^9.5:1.2^, ^9.1:.6^");
}

/* Writes a quartic that is closed, because of the terms x^4 + y^4 + z^4. The other
 * terms are random, and many are 0. */
static void add_quartic(char *text, size_t size)
{
    static const int fourth_powers[] = { 0, 20, 30 };
    double terms[35];
    for (int i = 0; i < 35; i++)
        terms[i] = xorshift(&traced.random) % 3 == 0 ? between(-.5, .5) : 0;
    for (int i = 0; i < 3; i++)
        terms[fourth_powers[i]] = between(.9, 1.5);
    terms[34] = between(-1, 0);
    add_text(text, size, "quartic { <");
    for (int i = 0; i < 35; i++)
        add_text(text, size, "%s%.4f", i > 0 ? ", " : "", terms[i]);
    add_text(text, size, "> ");
}

static void add_quartic_or_torus(char *text, size_t size)
{
    if (xorshift(&traced.random) % 3 == 0)
        add_quartic(text, size);
    else
        add_torus(text, size);
    add_random(text, size, " rotate <^2-90:90^, ^2-90:90^, ^2-90:90^> translate @2@ ");
}

/* Adds a number of discs that is sufficient for a hierarchy. */
static void add_discs(char *text, size_t size)
{
    size_t count = 12 + below(40);
    add_text(text, size, "union { ");
    for (size_t i = 0; i < count; i++) {
        add_random(text, size, "disc { @1.2@, @1@");
        add_text(text, size, ", %.4f, %.4f }\n", between(.3, 1),
                 below(2) ? between(0, .3) : 0);
    }
    add_random(text, size, "scale <^3.6:1.4^, 1, ^3.6:1.4^> ");
}

TEST_CALL(random_simple_shapes, check_random_scenes(add_shape, share_of(12)))
TEST_CALL(random_quadrics, check_random_scenes(add_quadric_or_cone, share_of(12)))
TEST_CALL(random_quartics, check_random_scenes(add_quartic_or_torus, share_of(8)))
TEST_CALL(random_discs, check_random_scenes(add_discs, share_of(4)))

/* The ray and the light are almost in the plane, and the light is straight ahead of the
 * ray. The directions to the light and along the ray are almost equal, so the length of
 * their halfway vector rounds to zero. There must be no highlight. (A wrong highlight
 * would be visible: the power of an indefinite would be about 2^(28718 / roughness),
 * with an exponent truncated to 16 bits.) */
TEST(light_straight_behind)
{
    FREED struct words *words = same_frame(
        "#version 3.7; global_settings { assumed_gamma 1 }\n"
        "light_source { <1e-9, 1e-7, 1>, rgb 1 }\n"
        "camera { location <1e-9, 0, -1> direction <-1e-9, 5e-8, 1>\n"
        "right 4e-10*x up 1e-8*y }\n"
        "plane { x, 0 pigment { rgb 1 } finish { ambient .25 diffuse 0\n"
        "specular 1 roughness .33 } }\n");
    for (size_t i = 0; i < PIXELS; i++) {
        assert_int_equal(c205_to_integer(words->channel[CHANNEL_ID][i]), 1);
        assert_float_equal(c205_to_double(words->channel[CHANNEL_RED][i]), .25, 1e-3);
    }
}

static void check_normal_z(const char *text, double expected)
{
    FREED struct words *words = same_frame(text);
    size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
    assert_float_equal(c205_to_double(words->channel[CHANNEL_NORMAL_Z][middle]),
                       expected, 1e-12);
}

TEST(flat_boxes)
{
    check_normal_z(AHEAD "box { <-1, -1, 2>, <1, 1, 2> }", -1);
    check_normal_z(AHEAD "box { <-1, -1, 0>, <1, 1, 0>"
                         " rotate 60*x translate <.1, .3, 9> }",
                   -.5);
    check_normal_z(AHEAD "box { <-1, -1, 1000>, <1, 1, 1000 + 1e-9> }", -1);
}

/* The axis is tilted by 1e-7, so the ray is in the side from z = 5 to 15. */
TEST(ray_almost_along_a_cylinder)
{
    check_middle_within(STRAIGHT "cylinder { <-1.1e-5, 0, -100>,"
                                 " <9e-6, 0, 100>, 5e-7 open }",
                        1, 10, 1e-5);
}

/* A number of the scene has a reciprocal that exceeds the doubles. */
TEST(numbers_beyond_doubles)
{
    SCOPED(scene) *scene = read_text(AHEAD "sphere { 0, 1\ninterior { ior 1e-310 } }");
    struct trace_options options = { .width = 1, .height = 1, .model = prior_model };
    c205_error error = { "" };
    assert_null(trace_new(scene, &options, &error));
    assert_non_null(strstr(error.message, "line 5"));
}

/* A cone of 45 degrees with its apex at the origin, open at the top. */
#define FUNNEL "cone { 0, 0, 2*y, 2 "

/* The ray is parallel to a line of the surface rotated by 45 degrees: a = 0. */
TEST(rays_parallel_to_a_side)
{
    check_middle_within(AHEAD FUNNEL "translate -y rotate -45*x }", 1, 5 - sqrt(2),
                        1e-6);
    check_middle_within(AHEAD FUNNEL "open translate -y rotate -45*x }", 1,
                        5 + sqrt(.5), 1e-6);
}

TEST(apex_normals)
{
    free(same_frame(STRAIGHT "cone { 0, 0, z, 1 pigment { rgb 1 } }"));
    free(same_frame(STRAIGHT "quadric { <1, 1, -1>, 0, 0, 0 }"));
}

TEST(empty_scene)
{
    FREED struct words *words = same_frame(AHEAD "background { rgb <.5, .25, 1> }");
    assert_int_equal(hits(words), 0);
    assert_float_equal(c205_to_double(words->channel[CHANNEL_GREEN][7]), .25, 0);
}
