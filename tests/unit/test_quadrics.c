/* Cones and quadrics: both forms of the tracer agree, and meet them where
 * geometry says. */
#include "tests/unit/traced_frame.h"

static void add_quadric(char *text, size_t size)
{
    add_text(text, size, "quadric { <%.6f, %.6f, %.6f>, ", between(-1, 1),
             between(-1, 1), between(-1, 1));
    add_point(text, size, .5);
    add_text(text, size, ", ");
    add_point(text, size, 1);
    add_text(text, size, ", %.6f ", between(-1, .3));
}

static void add_shape(char *text, size_t size)
{
    if (xorshift(&traced.random) % 3 == 0) {
        add_quadric(text, size);
        return;
    }
    add_text(text, size, "cone { ");
    add_point(text, size, 2);
    add_text(text, size, ", %.9f, ",
             xorshift(&traced.random) % 3 == 0 ? 0 : between(.2, .8));
    add_point(text, size, 2);
    add_text(text, size, ", %.9f %s", between(.2, .8),
             xorshift(&traced.random) % 2 ? "open " : "");
}

TEST(random_scenes)
{
    check_random_scenes(add_shape, 12);
}

/* 45 degrees, the apex at the origin, opening upwards. */
#define FUNNEL "cone { 0, 0, 2*y, 2 "

TEST(cones)
{
    check_middle(AHEAD "cone { -y, 1.5, y, .5 }", 1, 4);
    check_middle(AHEAD "cone { -y, 1.5, y, .5 open }", 1, 4);
    check_middle(AHEAD "cone { -y, 0, y, 2 scale <1, 1, 2> }", 1, 3);
    check_middle(AHEAD FUNNEL "translate -y }", 1, 4);
    check_middle(AHEAD FUNNEL "translate .5*y }", 0, 0);
    check_middle(AHEAD "cone { <0, -3, 0>, 1, <0, -1, 0>, 2 }", 0, 0);
}

TEST(rays_along_a_cone)
{
    check_middle(AHEAD "cone { -z, 1, z, 2 }", 1, 4);
    check_middle(AHEAD "cone { -z, 1, z, 2 open }", 0, 0);
    check_middle(AHEAD "cone { -z, 0, z, 2 }", 1, 4);
    check_middle(AHEAD "cone { -z, 2, z, 0 }", 1, 4);
    check_middle(AHEAD "cone { -z, 2, z, 0 open }", 1, 6);
    check_middle(AHEAD "cone { -z, 2, z, 0 translate -5*z }", 1, 1);
    check_middle(AHEAD "cone { -z, .1, z, .3 translate .2*x }", 1, 5);
}

/* Along a line of the surface turned by 45 degrees: a = 0. */
TEST(rays_parallel_to_a_side)
{
    check_middle_within(AHEAD FUNNEL "translate -y rotate -45*x }", 1,
                        5 - sqrt(2), 1e-6);
    check_middle_within(AHEAD FUNNEL "open translate -y rotate -45*x }", 1,
                        5 + sqrt(.5), 1e-6);
    check_middle(STRAIGHT "quadric { 0, z, 0, 0 translate -y }", 1, 5);
    check_middle(STRAIGHT "quadric { <1, 1, 0>, 0, -z, 0 }", 1, 5);
    check_middle(STRAIGHT "quadric { <1, 1, 0>, 0, 0, -1 }", 0, 0);
    check_middle(STRAIGHT "quadric { <0, 0, 1>, 0, 0, -1 }", 1, 4);
}

TEST(quadrics)
{
    check_middle(AHEAD "quadric { 1, 0, 0, -1 }", 1, 4);
    check_middle(AHEAD "quadric { 1, 0, 0, -1 translate -5*z }", 1, 1);
    check_middle(AHEAD "quadric { 1, 0, -2*z, 0 }", 1, 5);
    check_middle(AHEAD "quadric { 1, 0, 0, 1 }", 0, 0);
    check_middle(AHEAD "quadric { <-1, -1, 1>, 0, 0, -1 }", 1, 4);
    check_middle(AHEAD "quadric { <1, 1, -1>, 0, 0, -1 }", 0, 0);
    check_middle(AHEAD "quadric { <1, 1, -1>, 0, 0, 1 }", 1, 4);
}

/* The eye inside, at the apex, within tmin of the surface. */
TEST(starts)
{
    check_middle(AHEAD "cone { <0, -1, -5>, 2, <0, 1, -5>, 2.5 }", 1, 2.25);
    check_middle(AHEAD "cone { -5*z, 0, 5*z, 1 }", 1, 10);
    check_middle(AHEAD "quadric { 1, 0, 0, -25 }", 1, 10);
    check_middle(AHEAD "quadric { <1, 1, -1>, 0, -10*z, -24 }", 1, 1);
}

TEST(apex_normals)
{
    free(same_frame(STRAIGHT "cone { 0, 0, z, 1 pigment { rgb 1 } }"));
    free(same_frame(STRAIGHT "quadric { <1, 1, -1>, 0, 0, 0 }"));
}

GROUP(set_up_frames, tear_down_model);
