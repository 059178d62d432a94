/* The tracer's two forms: the same frame, bit for bit, on scenes that no one
 * has chosen, and on rays for which the kernels have cases of their own. */
#include "tests/unit/traced_frame.h"

static void add_shape(char *text, size_t size)
{
    switch (xorshift(&traced.random) % 5) {
    case 0:
        add_text(text, size, "sphere { ");
        add_point(text, size, 2);
        add_text(text, size, ", %.9f ", between(.2, 1));
        break;
    case 1:
        add_text(text, size, "box { ");
        add_point(text, size, 2);
        add_text(text, size, ", ");
        add_point(text, size, 2);
        break;
    case 2:
        add_text(text, size, "plane { ");
        add_point(text, size, 1);
        add_text(text, size, ", %.9f ", between(-5, -3));
        break;
    default:
        add_text(text, size, "cylinder { ");
        add_point(text, size, 2);
        add_text(text, size, ", ");
        add_point(text, size, 2);
        add_text(text, size, ", %.9f %s", between(.2, .8),
                 xorshift(&traced.random) % 2 ? "open " : "");
        break;
    }
}

TEST(random_scenes)
{
    check_random_scenes(add_shape, 12);
}

TEST(parallel_rays)
{
    check_middle(AHEAD "box { -1, 1 }", 1, 4);
    check_middle(AHEAD "box { <1, -1, -1>, <2, 1, 1> }", 0, 0);
    check_middle(AHEAD "cylinder { -z, z, 1 }", 1, 4);
    check_middle(AHEAD "cylinder { -z, z, 1 open } sphere { 0, .5 }", 2, 4.5);
    check_middle(AHEAD "cylinder { <2, 0, -1>, <2, 0, 1>, 1 }", 0, 0);
    check_middle(AHEAD "cylinder { -x, x, 1 }", 1, 4);
    check_middle(AHEAD "cylinder { <-1, 3, 0>, <1, 3, 0>, 1 open }", 0, 0);
    check_middle(AHEAD "plane { y, -1 }", 0, 0);
    check_middle(AHEAD "plane { y, 1 }", 0, 0);
    check_middle(AHEAD "plane { -z, 1 }", 1, 4);
    check_middle(AHEAD "plane { z, 3 }", 1, 8);
    check_middle(AHEAD "sphere { 0, 1 scale <1, 1, 2> }", 1, 3);
}

TEST(from_inside)
{
    check_middle(AHEAD "box { -8, 7 }", 1, 12);
    check_middle(AHEAD "sphere { <0, 0, -5>, 2 }", 1, 2);
    check_middle(AHEAD "cylinder { <0, -1, -5>, <0, 1, -5>, 3 }", 1, 3);
    check_middle(AHEAD "sphere { <0, 0, -5>, 1 scale <1, 1, 2> }", 0, 0);
    check_middle(AHEAD "sphere { <0, 0, -9>, 1 }", 0, 0);
}

TEST(touching_rays)
{
    check_middle(STRAIGHT "sphere { x, 1 }", 1, 5);
    check_middle(STRAIGHT "sphere { <.75, -1, 3>, 1.25 }", 1, 8);
}

TEST(open_cylinder_shows_its_inside)
{
    check_middle(AHEAD "cylinder { <0, .7, 0>, <0, 3, 0>, 1 open"
                       " rotate -30*x }",
                 0, 0);
    check_middle(AHEAD "cylinder { -y, y, 1 open }", 1, 4);
    check_middle(AHEAD "cylinder { -y, y, 1 open rotate 45*x translate -y }",
                 1, 5 + 1 - sqrt(2));
}

TEST(nearest_of_equals_is_the_first)
{
    check_middle(AHEAD "box { -1, 1 } box { -1, 1 } plane { z, 9 }", 1, 4);
    check_middle(AHEAD "plane { z, 9 } sphere { 0, 1 } box { -1, 1 }", 2, 4);
}

#define GLOSSY "no_shadow finish { phong .5 specular .5 } }"

/* L, then H, has no length. */
TEST(no_way_to_the_light)
{
    check_middle(STRAIGHT "light_source { -z, rgb 1 } box { -1, 1 " GLOSSY, 1,
                 4);
    check_middle(STRAIGHT "light_source { <0, 1e-9, 10>, rgb 1 }"
                          "box { -1, <1, 0, 1> " GLOSSY,
                 1, 4);
    check_middle(STRAIGHT "light_source { <0, 0, -5>, rgb 1 }"
                          "sphere { 0, 1 scale <1, 1, 1e-20> " GLOSSY,
                 1, 5);
}

/* The light lies behind a plane that is seen and lit along its surface: the
 * way to it is the ray's direction, half way between the two lies nowhere, and
 * there is no highlight.  (Of an indefinite the power would be about
 * 2^(28718 / roughness), its exponent cut to 16 bits: here a great one.) */
TEST(light_straight_behind)
{
    struct words *words = same_frame(
        "#version 3.7; global_settings { assumed_gamma 1 }\n"
        "light_source { <1e-9, 1e-7, 1>, rgb 1 }\n"
        "camera { location <1e-9, 0, -1> direction <-1e-9, 5e-8, 1>\n"
        "right 4e-10*x up 1e-8*y }\n"
        "plane { x, 0 pigment { rgb 1 } finish { ambient .25 diffuse 0\n"
        "specular 1 roughness .33 } }\n");

    for (size_t i = 0; i < PIXELS; i++) {
        assert_int_equal(c205_to_integer(words->channel[CHANNEL_ID][i]), 1);
        assert_float_equal(c205_to_double(words->channel[CHANNEL_RED][i]),
                           .25, 1e-3);
    }
    free(words);
}

static void check_normal_z(const char *text, double expected)
{
    struct words *words = same_frame(text);
    size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;

    assert_float_equal(c205_to_double(
                           words->channel[CHANNEL_NORMAL_Z][middle]),
                       expected, 1e-12);
    free(words);
}

TEST(flat_boxes)
{
    check_normal_z(AHEAD "box { <-1, -1, 2>, <1, 1, 2> }", -1);
    check_normal_z(AHEAD "box { <-1, -1, 0>, <1, 1, 0>"
                         " rotate 60*x translate <.1, .3, 9> }",
                   -.5);
    check_normal_z(AHEAD "box { <-1, -1, 1000>, <1, 1, 1000 + 1e-9> }", -1);
}

/* The axis leans by 1e-7: the ray is in the side from z = 5 to 15. */
TEST(ray_almost_along_a_cylinder)
{
    check_middle_within(STRAIGHT "cylinder { <-1.1e-5, 0, -100>,"
                                 " <9e-6, 0, 100>, 5e-7 open }",
                        1, 10, 1e-5);
}

/* Its reciprocal is no double. */
TEST(numbers_beyond_doubles)
{
    struct scene *scene = read_text(AHEAD "sphere { 0, 1\n"
                                          "interior { ior 1e-310 } }");
    struct trace_options options = { .width = 1,
                                     .height = 1,
                                     .model = prior_model };
    c205_error error = { "" };

    assert_null(trace_new(scene, &options, &error));
    assert_non_null(strstr(error.message, "line 5"));
    scene_free(scene);
}

TEST(empty_scene)
{
    struct words *words = same_frame(AHEAD "background { rgb <.5, .25, 1> }");

    assert_int_equal(hits(words), 0);
    assert_float_equal(c205_to_double(words->channel[CHANNEL_GREEN][7]), .25,
                       0);
    free(words);
}

GROUP(set_up_frames, tear_down_model);
