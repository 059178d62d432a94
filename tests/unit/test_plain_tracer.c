/* test_plain_tracer.c - the plain tracer's colours of scenes with a single ray are
 * compared with values computed by hand, and frames with each other. A missing term of
 * the lighting fails here. */
#include "tests/oracle/compare_pictures.h"
#include "tests/unit/plain_ray.h"

/* White surfaces with only diffuse light. */
#define HEAD \
    "global_settings { assumed_gamma 1 max_trace_level 1 ambient_light <2, 1, 1> }\n" \
    "#default { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"

/* ---- Shapes ------------------------------------------------------------ */

#define SPHERE "sphere { 0, 1 }"
#define BOX "box { -2, 2 }"
#define TUBE "cylinder { -z, z, 1 }"
#define OPEN_TUBE "cylinder { -z, z, 1 open }"
#define FLOOR "plane { y, -1 }"

/* A sheared, flattened sphere at height 3, where x / 2 + z replaces z. Its top is at y
 * = 3 + 1 / 2. There the shear has no effect. */
#define SHEARED "sphere { 0, 1 matrix <1, 0, -.5, 0, .5, 0, 0, 0, 1, 0, 3, 0> }"
#define THREE "box { -1, 1 } sphere { -z, 1 } plane { y, 5 }"

/* The number of the object, the distance and the normal: all 0 without a hit. */
TEST(hits)
{
    double length = sqrt(1.25);
    const struct {
        const char *text;
        struct look look;
        double expected[5];
    } rows[] = {
        { SPHERE, { { 0, 0, -5 }, { 0, 0, 1 } }, { 1, 4, 0, 0, -1 } },
        { SPHERE, { { .6, 0, -5 }, { 0, 0, 9 } }, { 1, 4.2, .6, 0, -.8 } },
        { SPHERE, { { 0, 0, 0 }, { 0, 3, 0 } }, { 1, 1, 0, -1, 0 } },
        { SPHERE, { { 0, 0, -5 }, { 0, 0, -1 } }, { 0 } },
        { SPHERE, { { 1.001, 0, -5 }, { 0, 0, 1 } }, { 0 } },
        { BOX, { { 0, 1, -5 }, { 0, 0, 1 } }, { 1, 3, 0, 0, -1 } },
        { BOX, { { 1, 0, 0 }, { 1, 0, 0 } }, { 1, 1, -1, 0, 0 } },
        { BOX, { { 5, 5, 0 }, { -3, -4, 0 } }, { 1, 5, 1, 0, 0 } },
        { BOX, { { 0, 2.001, -5 }, { 0, 0, 1 } }, { 0 } },
        { BOX, { { 0, 5, -5 }, { 0, 1, 1 } }, { 0 } },
        { TUBE, { { .5, 0, -5 }, { 0, 0, 1 } }, { 1, 4, 0, 0, -1 } },
        { TUBE, { { .6, 5, 0 }, { 0, -1, 0 } }, { 1, 4.2, .6, .8, 0 } },
        { TUBE, { { 0, 0, 0 }, { 0, 0, 1 } }, { 1, 1, 0, 0, -1 } },
        { TUBE, { { 1.5, 0, -5 }, { 0, 0, 1 } }, { 0 } },
        { TUBE, { { 0, 5, 1.5 }, { 0, -1, 0 } }, { 0 } },
        { OPEN_TUBE, { { .5, 0, -5 }, { 0, 0, 1 } }, { 0 } },
        { OPEN_TUBE, { { 0, -2, -3 }, { 0, 3, 4 } }, { 1, 5, 0, -1, 0 } },
        { OPEN_TUBE, { { 0, -.5, -2 }, { 0, 3, 4 } }, { 1, 2.5, 0, -1, 0 } },
        { FLOOR, { { 0, 2, 0 }, { 4, -3, 0 } }, { 1, 5, 0, 1, 0 } },
        { FLOOR, { { 0, -4, 0 }, { 4, 3, 0 } }, { 1, 5, 0, -1, 0 } },
        { FLOOR, { { 0, 2, 0 }, { 1, 0, 0 } }, { 0 } },
        { FLOOR, { { 0, 2, 0 }, { 0, 1, 0 } }, { 0 } },
        { SHEARED, { { 0, 9, 0 }, { 0, -2, 0 } }, { 1, 5.5, 0, 1, 0 } },
        { SHEARED,
          { { 0, 3, -9 }, { 0, 0, 1 } },
          { 1, 8, -.5 / length, 0, -1 / length } },
        { THREE, { { 0, 0, -5 }, { 0, 0, 1 } }, { 2, 3, 0, 0, -1 } },
        { THREE, { { 0, 0, 5 }, { 0, 0, -1 } }, { 1, 4, 0, 0, 1 } },
        { THREE, { { 0, 9, 0 }, { 0, -1, 0 } }, { 3, 4, 0, 1, 0 } },
    };
    static const enum frame_channel channels[] = { CHANNEL_ID, CHANNEL_DEPTH,
                                                   CHANNEL_NORMAL_X, CHANNEL_NORMAL_Y,
                                                   CHANNEL_NORMAL_Z };
    for (size_t i = 0; i < COUNT(rows); i++) {
        double values[FRAME_CHANNELS];
        trace_ray(&rows[i].look, HEAD, rows[i].text, values);
        for (size_t k = 0; k < COUNT(channels); k++)
            FAIL_IF(!(fabs(values[channels[k]] - rows[i].expected[k]) <= CLOSE),
                    "row %zu, %s: channel %d is %.17g", i, rows[i].text, channels[k],
                    values[channels[k]]);
    }
}

/* ---- The camera -------------------------------------------------------- */

TEST(pixel_centres)
{
    SCOPED_VALUE(frame) frame;
    SCOPED(scene) *scene = read_scene(
        "camera { location y direction -y right 4*x up 2*z } plane { y, 0 }");
    assert_true(plain_trace(scene, 4, 2, &frame));
    for (size_t i = 0; i < 8; i++) {
        double x = (double)(i % 4) - 1.5, z = i < 4 ? .5 : -.5;
        assert_close(frame.channel[CHANNEL_DEPTH][i], sqrt(1 + x * x + z * z), CLOSE);
    }
}

/* ---- Shading ----------------------------------------------------------- */

static double red(const struct look *look, const char *text)
{
    double values[FRAME_CHANNELS];
    trace_ray(look, HEAD, text, values);
    return values[CHANNEL_RED];
}

#define BALL "sphere { <1.5, 2, 0>, 1 }"
#define DARK_BALL "sphere { <1.5, 2, 0>, 1 no_shadow }"

/* A floor at y = 0, seen at the origin from <-3, 4, 0>. The light at <3, 4, 0> is in
 * the mirror direction of the camera ray. */
TEST(shading)
{
    static const struct look onto_floor = { { -3, 4, 0 }, { 3, -4, 0 } };
    double lit = .5 * .8 * .8;
    const struct {
        const char *place, *light, *finish, *others;
        double expected;
    } rows[] = {
        { "<3, 4, 0>", "", "", "", lit },
        { "<3, 4, 0>", "", "ambient .1", "", lit + .1 * 2 * .8 },
        { "<3, -4, 0>", "", "ambient .1", "", .1 * 2 * .8 },
        { "<3, 4, 0>", "", "diffuse 0 phong .5", "", .5 * .5 },
        { "<3, 4, 0>", "", "diffuse 0 phong .5 specular .25", "", .5 * (.5 + .25) },
        /* cosine .8; half the angle for specular */
        { "<0, 4, 0>", "", "diffuse 0 phong .5 specular .25", "",
          .5 * (.5 * pow(.8, 40) + .25 * pow(sqrt(.9), 20)) },
        { "<0, 4, 0>", "shadowless", "diffuse 0 phong .5 specular .25", "", 0 },
        { "<3, 4, 0>", "", "", BALL, 0 },
        { "<3, 4, 0>", "shadowless", "", BALL, lit },
        { "<3, 4, 0>", "", "", DARK_BALL, lit },
        { "<.75, 1, 0>", "", "", BALL, lit }, /* in front of the sphere */
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        const char *text =
            formatted("light_source { %s, rgb <.5, 1, 1> %s }\n"
                      "plane { y, 0 pigment { rgb <.8, 1, 1> } finish { %s } } %s",
                      rows[i].place, rows[i].light, rows[i].finish, rows[i].others);
        FAIL_IF(!(fabs(red(&onto_floor, text) - rows[i].expected) <= CLOSE),
                "%.17g is not %.17g: %s", red(&onto_floor, text), rows[i].expected,
                text);
    }
}

TEST(background)
{
    static const struct look up = { { 0, 1, 0 }, { 0, 1, 0 } };
    assert_close(red(&up, "background { rgb <.25, 0, 0> } plane { y, 0 }"), .25, CLOSE);
}

/* The squares have the width 2 in x. The light has parallel rays. */
TEST(checker)
{
    for (int x = -3; x < 4; x++)
        for (int z = -3; z < 4; z++) {
            const struct look down = { { 2 * x + 1, 1, z + .5 }, { 0, -1, 0 } };
            bool odd = (x + z) % 2 != 0;
            assert_close(red(&down, "light_source { 9*y, rgb 1 parallel point_at 0 }"
                                    "plane { y, 0 pigment"
                                    " { checker rgb 1, rgb 0 scale <2, 1, 1> } }"),
                         !odd, CLOSE);
        }
}

/* ---- Frames compared --------------------------------------------------- */

TEST(compare)
{
    struct frame a, b;
    const struct comparison all = { "colour", CHANNEL_RED, 3, 1, false, .1, .05 };
    assert_true(frame_allocate(&a, 8, 5) && frame_allocate(&b, 8, 5));
    for (size_t i = 0; i < 40; i++)
        a.channel[CHANNEL_ID][i] = i % 8 < 4;
    FREED bool *inner = inner_pixels(&a);
    b.channel[CHANNEL_RED][3] = 9;    /* on the edge: ignored */
    b.channel[CHANNEL_GREEN][15] = 9; /* counts as 1 */
    b.channel[CHANNEL_BLUE][0] = .05; /* within the tolerance */
    struct picture_difference is = compare_pictures(&all, &a, &b, inner);
    assert_int_equal(is.compared, 30);
    assert_int_equal(is.ignored, 10);
    assert_int_equal(is.beyond, 1);
    assert_int_equal(is.worst_x, 7);
    assert_int_equal(is.worst_y, 1);
    assert_close(is.greatest, 1, CLOSE);
    assert_close(is.mean, 1.05 / 90, CLOSE);
    assert_true(within(&all, &is));
    b.channel[CHANNEL_RED][16] = NAN;
    is = compare_pictures(&all, &a, &b, inner);
    assert_int_equal(is.beyond, 2);
    assert_false(within(&all, &is));
    frame_free(&a);
    frame_free(&b);
}
