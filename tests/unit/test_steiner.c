/* test_steiner.c - Steiner patches. The frames of both forms are compared with the
 * plain tracer and with geometry, also for patches of quadrics and planes, and for
 * special rays. A lost root or a gap at an edge fails here. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

static void add_shape(char *text, size_t size)
{
    add_steiner_patch(text, size, 3.5);
    add_text(text, size, " ");
}

TEST_CALL(random_scenes, check_random_scenes(add_shape, share_of(10)))

/* Small patches are seen from far away, where a loss of precision would be visible. */
TEST(distant_patches)
{
    for (int i = 0; i < 4; i++) {
        char text[4096] = HEAD "camera { location -1000*z look_at 0 angle .2 }\n";
        add_steiner_patch(text, sizeof text, 2);
        add_text(text, sizeof text, "}");
        free(plain_frame(text));
    }
}

/* The ray is parallel to the second difference of every curve. */
#define BOWL \
    "steiner_patch { <-2, -1, 1>, <2, -1, 1>, <0, 2, 1>, <0, -1, 0>, <1, .5, 0>," \
    " <-1, .5, 0> "

TEST(rays_along_the_differences)
{
    check_middle(STRAIGHT BOWL "}", 1, 5 + 1 / 3.);
    check_middle(STRAIGHT BOWL "weights 2, 2, 2, 2, 2, 2 }", 1, 5 + 1 / 3.);
}

/* Translation surfaces of two parabolas. A plane of rays crosses two curves s = const
 * at the same time, along lines of pixels. */
TEST(curves_in_planes_of_rays)
{
    static const char *const turns[] = { "", "rotate 120*z", "rotate 90*y",
                                         "rotate <30, 0, 90>" };
    for (size_t i = 0; i < COUNT(turns); i++) {
        char text[1024] = "";
        add_text(text, sizeof text,
                 "%ssteiner_patch { <2, 0, 1>, <0, 2, 1>, 0,"
                 " <1, 1, 0>, <0, 1, -1>, <1, 0, -1> translate <-.5, -.5, 0> %s }",
                 STRAIGHT, turns[i]);
        FREED struct words *words = plain_frame(text);

        assert_true(hits(words) > 0);
    }
}

/* A piece of the unit sphere about <6, 6, -7> / 11, turned towards the camera, by
 * stereographic projection. Its weights and points are polar forms. */
#define PIECE \
    "steiner_patch { <1, 0, 0>, <0, 1, 0>, <0, 0, -1>, <1, 1, -1>," \
    " <0, 1, -1>, <1, 0, -1> weights 2, 2, 1, 1, 1, 1" \
    " rotate 40.6*y rotate -33*x "

TEST(quadrics)
{
    check_middle(AHEAD PIECE "}", 1, 4);
    check_middle(AHEAD PIECE "rotate 180*y }", 1, 6);
    free(plain_frame(AHEAD PIECE "rotate 20 } " PIECE "scale 2 }"));
    /* Patches of a parabolic cylinder and of a saddle. */
    free(plain_frame(STRAIGHT "steiner_patch { <-2, -1, 1>, <2, -1, 1>,"
                              " <-2, 2, 1>, <0, -1, -1>, <0, .5, -1>, <-2, .5, 1> }"));
    free(plain_frame(STRAIGHT "steiner_patch { <1, 0, 0>, <0, 1, 0>, <0, 0, 0>,"
                              " <.5, .5, .5>, <0, .5, 0>, <.5, 0, 0> }"));
}

/* Flat patches with straight and curved edges, also seen along their plane. */
#define FLAT \
    "steiner_patch { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0>, <0, -1, 0>," \
    " <.5, 0, 0>, <-.5, 0, 0> "
#define LEAF \
    "steiner_patch { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0>, <0, -1.5, 0>," \
    " <1, .2, 0>, <-1, .2, 0> "

TEST(planes)
{
    check_middle(STRAIGHT FLAT "}", 1, 5);
    check_middle(STRAIGHT FLAT "translate -y }", 1, 5);
    check_middle(STRAIGHT FLAT "rotate 180*y }", 1, 5);
    check_middle(STRAIGHT FLAT "rotate 90*z }", 1, 5);
    check_middle(STRAIGHT FLAT "rotate 120*z }", 1, 5);
    check_middle(STRAIGHT FLAT "rotate 240*z }", 1, 5);
    check_middle(STRAIGHT FLAT "weights 1, 2, 3, 1.5, 2.5, 2 }", 1, 5);
    check_middle(STRAIGHT LEAF "}", 1, 5);
    check_middle(STRAIGHT LEAF "rotate 75*x }", 1, 5);
    check_middle(STRAIGHT FLAT "rotate 90*y translate x }", 0, 0);
}

/* Patches share edges. No ray passes through the seam. */
TEST(no_gap_at_an_edge)
{
    FREED struct words *words = same_frame(
        AHEAD "steiner_patch { <-9, -9, 0>, <9, -9, 0>, <0, 0, 1>,"
              " <0, -5, .3>, <4, -5, 2>, <-5, -4, 1> }"
              "steiner_patch { <-9, -9, 0>, <0, 0, 1>, <-9, 9, 0>,"
              " <-5, -4, 1>, <-4, 5, .2>, <-6, 0, -.3> }"
              "steiner_patch { <9, -9, 0>, <9, 9, 0>, <0, 0, 1>,"
              " <6, 0, .3>, <5, 4, -1>, <4, -5, 2> }"
              "steiner_patch { <9, 9, 0>, <-9, 9, 0>, <0, 0, 1>,"
              " <0, 6, .3>, <-4, 5, .2>, <5, 4, -1> }");
    assert_int_equal(hits(words), PIXELS);
}

TEST(starts)
{
    check_middle(STRAIGHT FLAT "translate -5*z }", 0, 0);
    check_middle(STRAIGHT FLAT "translate -4*z }", 1, 1);
    check_middle(STRAIGHT FLAT "translate -6*z }", 0, 0);
    check_middle(STRAIGHT FLAT "translate -.01*z scale 1000 translate 6*z }", 1, 1);
}

/* A piece of the Roman surface with the weights of s^2 + t^2 + u^2. */
#define ROMAN \
    "steiner_patch { <1, 2, 2> / 6, <2, 1, 2> / 6, <2, 2, 1> / 6," \
    " <.3, .3, .5>, <.5, .3, .3>, <.3, .5, .3>" \
    " weights 6, 6, 6, 5, 5, 5 "
/* Another piece of the Roman surface, about one of the double lines through its triple
 * point. */
#define ROMAN_MIDDLE \
    "steiner_patch { <-2, -5, 10> / 30, <-2, 10, -5> / 30," \
    " <1, -5, -5> / 27, <2.5, 2.5, 2.5> / 21, <-.5, 2.5, -5> / 24," \
    " <-.5, -5, 2.5> / 24 weights 30, 30, 27, 21, 24, 24 "
#define DIAGONAL "rotate -45*y rotate 35.264389682754654*x "

/* The middle ray passes through the triple point of the surface, where the implicit
 * quartic is 0. The hit is at the triple point or after it. */
TEST(the_triple_point)
{
    check_middle(STRAIGHT ROMAN DIAGONAL "}", 1, 5 + 1 / sqrt(3));
    check_middle(STRAIGHT ROMAN DIAGONAL "rotate 180*y }", 1, 5 - 1 / sqrt(3));
    check_middle(STRAIGHT ROMAN DIAGONAL "scale 3 }", 1, 5 + sqrt(3));
    check_middle(STRAIGHT ROMAN_MIDDLE "rotate <30, 40, 0> }", 1, 5);
    free(plain_frame(AHEAD ROMAN_MIDDLE "rotate <30, 40, 0> }"));
    free(plain_frame(AHEAD ROMAN DIAGONAL "translate <.3, .1, 0> }"));
}

TEST(the_way_of_1984)
{
    traced.historical = true;
    test_random_scenes(test_state);
    test_quadrics(test_state);
    test_planes(test_state);
    test_starts(test_state);
    test_the_triple_point(test_state);
    traced.historical = false;
}
