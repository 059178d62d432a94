/* Tori and quartic surfaces: both forms of the tracer agree, and meet them
 * where geometry says. */
#include "tests/unit/traced_frame.h"

/* A torus with a tube from half of its thickness to twice. */
static void add_torus(char *text, size_t size)
{
    bool elliptical = xorshift(&traced.random) % 2;

    add_text(text, size, "%storus { %.9f, %.9f",
             elliptical ? "elliptical_" : "", between(.5, 1.2),
             between(.1, .6));
    if (elliptical)
        add_text(text, size, ", %.9f", between(.1, .6));
}

/* Closed, since x^4 + y^4 + z^4 are there; the others by chance, many 0. */
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

static void add_shape(char *text, size_t size)
{
    if (xorshift(&traced.random) % 3 == 0)
        add_quartic(text, size);
    else
        add_torus(text, size);
    add_text(text, size, " rotate <%.2f, %.2f, %.2f> translate ",
             between(-90, 90), between(-90, 90), between(-90, 90));
    add_point(text, size, 2);
    add_text(text, size, " ");
}

TEST(random_scenes)
{
    check_random_scenes(add_shape, 8);
}

TEST(tori)
{
    check_middle(AHEAD "torus { 1, .5 }", 1, 3.5);
    check_middle(AHEAD "torus { 1, .5 rotate 90*x }", 0, 0);
    check_middle(AHEAD "torus { 1, .5 translate -4*z }", 1, .5);
    check_middle(AHEAD "torus { 5, .25 }", 1, .25);
    check_middle(AHEAD "torus { 1, .5 scale <1, 1, 2> }", 1, 2);
    check_middle(AHEAD "torus { 1, .5 translate .6*y }", 0, 0);
    check_middle(AHEAD "torus { .5, 1 rotate 90*x }", 1, 5 - sqrt(.75));
    check_middle(AHEAD "elliptical_torus { 1, .5, .1 }", 1, 3.5);
    check_middle(AHEAD "elliptical_torus { 1, .5, .1 rotate 90*x"
                       " translate x }",
                 1, 4.9);
}

/* From the middle of the tube, from its surface, from the hole. */
TEST(starts)
{
    check_middle(AHEAD "torus { 1, .5 translate <0, 0, -4> }", 1, .5);
    check_middle(AHEAD "torus { 1, .5 translate <0, 0, -3.5> }", 1, 1);
    check_middle(AHEAD "torus { 1, .5 translate <0, 0, -5> }", 1, .5);
    check_middle(AHEAD "torus { 1, .5 scale 2 translate <0, 0, -2> }", 1, 2);
    check_middle(AHEAD "torus { 1, .5 translate <0, 0, -7> }", 0, 0);
}

/* Objects behind the eye: the unit of length is the world's, whatever else is
 * small. */
#define ORDINARY AHEAD "#declare Far = sphere { -9*z, 1 }\n"
#define FAR " object { Far } object { Far translate -z }"

/* The nearest crossing beyond 1e-6 of the world, whatever the scale: just
 * before the eye at that distance or behind it at half of it. */
TEST(least_distance)
{
    check_middle(ORDINARY "torus { 1, .5 scale 1000"
                          " translate (1500 - 5 + 2e-6)*z }" FAR,
                 1, 2e-6);
    check_middle(ORDINARY "torus { 1, .5 scale 1000"
                          " translate (1500 - 5 + .5e-6)*z }" FAR,
                 1, 1000 + .5e-6);
    check_middle(ORDINARY "torus { 1, .5 scale .001"
                          " translate (.0015 - 5 + 2e-6)*z }" FAR,
                 1, 2e-6);
    check_middle(ORDINARY "torus { 1, .5 scale .001"
                          " translate (.0015 - 5 + .5e-6)*z }" FAR,
                 1, .0010005);
}

/* Coefficients in POV-Ray's order, of which only a few are not 0. */
#define Z4 \
    "<0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, " \
    "0,0,0,0,0, 1,"

TEST(quartic_surfaces)
{
    check_middle(AHEAD "quartic { " Z4 "0,0,0,-1> }", 1, 4);
    check_middle(AHEAD "quartic { " Z4 "0,-5,0,4> }", 1, 3);
    check_middle(AHEAD "quartic { " Z4 "0,-5,0,4> translate -5*z }", 1, 1);
    check_middle(AHEAD "quartic { " Z4 "0,0,0,1> }", 0, 0);
    check_middle(AHEAD "quartic { <0,0,0,1,0, 0,0,0,0,0, 0,0,0,0,0,"
                       " 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 0,0,0,1,-3> }",
                 1, 8);
    check_middle(AHEAD "quartic { <0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0,"
                       " 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 0,1,0,0,-8> }",
                 1, 7);
}

GROUP(set_up_frames, tear_down_model);
