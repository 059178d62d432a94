/* test_cylinders.c - cylinders in every formulation of the kernels. Depths and normals
 * are compared with geometry and with the plain tracer, for hits from outside, from
 * inside and along the axis. A wrong root, a missing end or a normal that points inside
 * fails here. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

#include "rt/study/speedup.h"

/* Compares the middle ray's depth and normal. The normal faces the ray. */
static void check_hit(const char *text, double depth, double x, double y, double z)
{
    FREED struct words *words = same_frame(text);
    size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
    const double expected[] = { depth, x, y, z };
    assert_int_equal(c205_to_integer(words->channel[CHANNEL_ID][middle]), 1);
    for (int i = 0; i < 4; i++) {
        double found = c205_to_double(words->channel[CHANNEL_DEPTH + i][middle]);
        FAIL_IF(!(fabs(found - expected[i]) <= 5e-11 * (1 + fabs(expected[i]) / 100)),
                "%s: %d is %.15g, not %.15g", text, i, found, expected[i]);
    }
    check_paper_stage(text, words);
}

/* Adds the ends of an axis. A third of the axes point at the camera. */
static void add_axis(char *text, size_t size)
{
    static const char *const axes[] = { "<.4, .2, -1>, <.4, .2, 1.5>",
                                        "<-1, .3, 0>, <2, .3, 0>" };
    unsigned which = (unsigned)(xorshift(&traced.random) % 6);
    if (which < 2) {
        add_text(text, size, "%s", axes[which]);
        return;
    }
    add_point(text, size, 2.5);
    add_text(text, size, ", ");
    add_point(text, size, 2.5);
}

static void add_cylinder(char *text, size_t size)
{
    add_text(text, size, "cylinder { ");
    add_axis(text, size);
    add_text(text, size, ", %.6f %s ", between(.2, 1.2),
             xorshift(&traced.random) % 3 ? "" : "open");
}

static void check_scenes(void)
{
    char text[4096] = AHEAD;
    check_random_scenes(add_cylinder, share_of(3));
    for (int i = 0; i < 5; i++) {
        add_cylinder(text, sizeof text);
        add_text(text, sizeof text, "pigment { rgb <.3, .5, .%d> } }\n", i);
    }
    free(plain_frame(text));
}

/* The side and the ends are hit from outside, inside, along the axis and obliquely. */
#define SOLID "cylinder { <0, 0, -1>, <0, 0, 2>, .5 "
#define SLOPE "cylinder { <-.6, 0, -.8>, <.6, 0, .8>, .5 "

static void check_solids(void)
{
    check_hit(STRAIGHT SOLID "}", 4, 0, 0, -1);
    check_hit(STRAIGHT SOLID "rotate 180*y }", 3, 0, 0, -1);
    check_hit(STRAIGHT SOLID "rotate 90*y }", 4.5, 0, 0, -1);
    check_hit(STRAIGHT SOLID "rotate 90*x translate -.3*x }", 4.6, .6, 0, -.8);
    check_hit(STRAIGHT SOLID "translate <.2, .1, -5> }", 2, 0, 0, -1);
    check_hit(STRAIGHT SOLID "rotate 180*y translate -5*z }", 1, 0, 0, -1);
    check_hit(STRAIGHT SOLID "rotate 90*x translate -5*z }", .5, 0, 0, -1);
    check_hit(STRAIGHT SLOPE "}", 5 - .5 / .6, .8, 0, -.6);
    check_hit(STRAIGHT SLOPE "translate .4*x }", 4.05, -.6, 0, -.8);
    check_hit(STRAIGHT SLOPE "translate <.9, 0, 1.2> }", 5.625, -.6, 0, -.8);
    check_hit(STRAIGHT SLOPE "translate -5*z }", .5 / .6, .8, 0, -.6);
    check_hit(STRAIGHT SLOPE "translate <-.4, 0, -5> }", .95, -.6, 0, -.8);
    check_hit(STRAIGHT SLOPE "scale 1000 translate 4000*z }", 4005 - 500 / .6, .8, 0,
              -.6);
}

static void check_misses(void)
{
    check_middle(STRAIGHT SOLID "translate .6*x }", 0, 0);
    check_middle(STRAIGHT SOLID "translate <.36, .36, 0> }", 0, 0);
    check_middle(STRAIGHT SOLID "rotate 90*y translate .6*y }", 0, 0);
    check_middle(STRAIGHT SOLID "rotate 90*x translate -1.1*y }", 0, 0);
    check_middle(STRAIGHT SOLID "translate -8*z }", 0, 0);
    check_middle(STRAIGHT SLOPE "translate <1.4, 0, 1.2> }", 0, 0);
}

/* The ray enters a cylinder without ends at an open end and hits the inner side. */
static void check_tubes(void)
{
    check_middle(STRAIGHT SOLID "open }", 0, 0);
    check_middle(STRAIGHT SOLID "open translate .6*x }", 0, 0);
    check_hit(STRAIGHT SOLID "open rotate 90*y }", 4.5, 0, 0, -1);
    check_hit(STRAIGHT SLOPE "open }", 5 - .5 / .6, .8, 0, -.6);
    check_hit(STRAIGHT SLOPE "open translate .4*x }", 5.3, .8, 0, -.6);
    check_hit(STRAIGHT SLOPE "open translate -.4*x }", 4.7, .8, 0, -.6);
    check_hit(STRAIGHT SLOPE "open translate -5*z }", .5 / .6, .8, 0, -.6);
    check_middle(STRAIGHT SLOPE "open translate <-.4, 0, -5> }", 0, 0);
}

TEST(formulations)
{
    for (size_t i = 0; i < speedup_formulation_count; i++) {
        traced.historical = speedup_formulations[i].historical;
        traced.variant = speedup_formulations[i].variant;
        check_scenes();
        check_solids();
        check_misses();
        check_tubes();
    }
    traced.historical = false;
    traced.variant = NULL;
}

/* The historical formulation leaves transparent cylinders and trees unchanged. */
TEST(trees)
{
    static const char text[] = AHEAD "difference { " SOLID
                                     "rotate 40*y } sphere { -z, .8 } }"
                                     "cylinder { -2*y, 2*y, .4 translate 1.2*x"
                                     " pigment { rgbf <1, .5, .5, .6> } }";
    FREED struct words *today = plain_frame(text);
    traced.historical = true;
    FREED struct words *then = plain_frame(text);
    assert_memory_equal(today, then, sizeof *today);
    traced.historical = false;
}
