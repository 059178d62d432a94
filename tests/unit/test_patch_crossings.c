/* A patch that is a part of a tree, or clear, has all its crossings with a
 * ray: where the nearest is cut away, or lets light pass, the next is seen. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

#define BENT \
    "steiner_patch { <-1, 0, 0>, <0, 2, 0>, <1, 0, 0>, <-1, 1, -.2238>," \
    " <1, 1, .4063>, <0, -.5, -.7516> "
#define WEIGHTS "weights 1, 1, 1, 1.2, .5, 1 "
#define ABOUT "scale <.75, 1.18, 1.37> translate <-.337, -.273, -.257> "

/* Across the ray from the eye. */
#define CUT \
    "#version 3.7; global_settings { assumed_gamma 1 }\n" \
    "light_source { <9, 3, -3>, 1 shadowless }\n" \
    "camera { location <7, 3, -3> look_at <-.433, .05, -.548> angle 3 }\n"
#define AWAY "plane { <.8, .6, 0>, -.4 }"

#define GLASS "pigment { rgbft <.2, .8, .5, .4, .1> } "

/* Two sheets of a patch, and what is behind them. */
#define SHEETS \
    "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 6 }\n" \
    "background { rgb <.2, .3, .5> } light_source { <-1.9, 8, -7>, .7 }\n" \
    "light_source { <7, 3, -3>, rgb <.3, .2, .4> }\n" \
    "camera { location <-.637, -1.652, -5> look_at <-.06, -.116, 0>" \
    " angle 30 }\n" \
    "plane { <.6, -.68, -.75>, -.06 pigment { checker rgb .9 rgb .4 } }\n"

static void check_stages(const char *text)
{
    struct words *words = plain_frame(text);

    assert_true(hits(words) > 0);
    check_paper_stage(text, words);
    free(words);
}

static void test_holes_in_solids(void **state)
{
    (void)state;
    check_stages(CUT "intersection { " BENT ABOUT "} " AWAY " }");
    check_stages(CUT "intersection { " BENT WEIGHTS ABOUT "} " AWAY " }");
    check_stages(CUT "intersection { " AWAY " merge { box { -9, -8 } " BENT
                     "} " ABOUT "} }");
    check_stages(CUT "difference { " BENT ABOUT "} " AWAY " sphere { 0, .6 }"
                     " }");
}

static void test_shadows_and_glass(void **state)
{
    (void)state;
    check_stages(SHEETS BENT GLASS ABOUT "}");
    check_stages(SHEETS BENT WEIGHTS GLASS ABOUT "}");
    check_stages(SHEETS "merge { " BENT GLASS "} sphere { .5*y, .3 " GLASS
                        "} " ABOUT "}");
    /* few of the rays at hand come near it */
    check_stages(SHEETS "merge { " BENT GLASS
                        "scale .3 } sphere { -2*z, .3 " GLASS
                        "} torus { 2, .1 rotate 60*x } " ABOUT "}");
    check_stages(SHEETS "intersection { " BENT WEIGHTS "} sphere { 0, 1.2 }"
                        " no_shadow " ABOUT "}");
}

/* Rays in planes of curves s = const, which they meet twice. */
static void test_pairs_of_lines(void **state)
{
    static const char *const turns[] = { "", "rotate 120*z", "rotate 90*y",
                                         "rotate <30, 0, 90>" };

    (void)state;
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        char text[1024] = "";

        add_text(
            text, sizeof text,
            "%sintersection { plane { -z, .3 }"
            " steiner_patch { <2, 0, 1>, <0, 2, 1>, 0, <1, 1, 0>, <0, 1, -1>,"
            " <1, 0, -1> translate <-.5, -.5, 0> %s } }",
            STRAIGHT, turns[i]);
        check_stages(text);
    }
}

static void add_patch(char *text, size_t size)
{
    add_text(text, size, "steiner_patch { ");
    for (int i = 0; i < 6; i++) {
        add_text(text, size, "%s", i > 0 ? ", " : "");
        add_point(text, size, 3);
    }
    if (xorshift(&traced.random) % 2)
        for (int i = 0; i < 6; i++)
            add_text(text, size, "%s %.6f", i > 0 ? "," : " weights",
                     between(.4, 2.5));
    add_text(text, size, " } ");
}

/* Each cut by a plane; the second is clear. */
static void test_random_patches(void **state)
{
    (void)state;
    for (int i = 0; i < 6; i++) {
        char text[4096] = HEAD
            "light_source { <3, 9, -6>, .5 }\n"
            "camera { location <0, 1, -7> look_at 0 angle 50 }\n"
            "plane { z, 4 pigment { checker rgb .9 rgb .4 } }\n";

        for (int k = 0; k < 2; k++) {
            add_text(text, sizeof text, "intersection { ");
            add_patch(text, sizeof text);
            add_text(text, sizeof text, "plane { ");
            add_point(text, sizeof text, 1);
            add_text(text, sizeof text, ", %.3f } %s }\n", between(-.3, .6),
                     k ? GLASS : "pigment { rgb .8 }");
        }
        check_stages(text);
    }
}

static void test_the_way_of_1984(void **state)
{
    traced.historical = true;
    test_holes_in_solids(state);
    test_shadows_and_glass(state);
    test_random_patches(state);
    traced.historical = false;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_holes_in_solids),
        cmocka_unit_test(test_shadows_and_glass),
        cmocka_unit_test(test_pairs_of_lines),
        cmocka_unit_test(test_random_patches),
        cmocka_unit_test(test_the_way_of_1984),
    };

    traced.reported = true; /* that a patch has no inside */
    return cmocka_run_group_tests(tests, set_up_frames, tear_down_model);
}
