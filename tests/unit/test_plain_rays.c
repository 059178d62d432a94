/* test_plain_rays.c - colours of the plain tracer's mirrors, glass and shadows are
 * compared with values computed by hand, for scenes with luminous objects. A wrong
 * index, level or weight of a ray fails here. */
#include "tests/oracle/plain_shapes.h"
#include "tests/oracle/plain_tracer.h"
#include "tests/unit/scene_reading.h"

/* Each picture is one ray through the middle of one pixel. */
#define HEAD \
    "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 10 } " \
    "#default { finish { ambient 0 diffuse 0 } } "

struct look {
    double from[3], along[3];
};

static void see(const struct look *look, const char *text, double color[3])
{
    char whole[4096];
    SCOPED_VALUE(frame) frame;
    snprintf(whole, sizeof whole, HEAD "%s", text);
    SCOPED(scene) *scene = read_scene(whole);
    scene->camera = (struct camera){ .location = { 0 } };
    copy(scene->camera.location, look->from);
    copy(scene->camera.direction, look->along);
    assert_true(plain_trace(scene, 1, 1, &frame));
    for (int i = 0; i < 3; i++)
        color[i] = frame.channel[i][0];
}

static void check(const struct look *look, const char *text, double red, double green,
                  double blue)
{
    double color[3];
    see(look, text, color);
    if (!(fabs(color[0] - red) < CLOSE && fabs(color[1] - green) < CLOSE
          && fabs(color[2] - blue) < CLOSE))
        fail_msg("%s: %.15g %.15g %.15g", text, color[0], color[1], color[2]);
}

#define LAMP "finish { ambient 1 } "
/* clang-format off */
#define ZAHEAD { { 0, 0, -5 }, { 0, 0, 1 } }
/* clang-format on */

/* ---- Mirrors ------------------------------------------------------------ */

/* From <-4, 3, 0>, a floor shows the lamp at <4, 3, 0> at the origin, tinted by the
 * mirror alone. */
TEST(mirror_image)
{
    const struct look look = { { -4, 3, 0 }, { 4, -3, 0 } };
    check(&look,
          "plane { y, 0 pigment { rgb 1 } "
          "finish { reflection rgb <.9, .5, .2> } } "
          "sphere { <4, 3, 0>, 1e-6 pigment { rgb .5 } " LAMP "}",
          .45, .25, .1);
    check(&look,
          "plane { y, 0 pigment { rgb <.1, .2, .3> } "
          "finish { ambient 1 reflection .5 } } background { rgb .5 }",
          .1 + .25, .2 + .25, .3 + .25);
    check(&look,
          "plane { y, 0 finish { reflection .5 } } "
          "sphere { <4, 3.00001, 0>, 1e-6 pigment { rgb .5 } " LAMP "}",
          0, 0, 0);
}

/* The ray hits the ball where eye and lamp are mirror images of each other; there the
 * normal is between them. */
TEST(mirror_ball)
{
    const struct look look = { { -3, 4, 0 }, { 3, -3, 0 } };
    check(&look,
          "sphere { 0, 1 finish { reflection 1 } } "
          "sphere { <3, 4, 0>, 1e-6 pigment { rgb .7 } " LAMP "}",
          .7, .7, .7);
}

/* Two facing mirrors form a geometric series, which ends at the maximum level or at the
 * threshold of the weight. */
static void check_series(int level, double bailout, int terms)
{
    static const struct look look = { { 0, 0, 1 }, { 0, 0, 1 } };
    char text[512];
    double sum = 0;
    for (int i = 0; i < terms; i++)
        sum += .1 * pow(.5, i);
    snprintf(text, sizeof text,
             "global_settings { max_trace_level %d "
             "adc_bailout %.17g } box { 0, <9, 9, 2> translate <-4, -4, 0> "
             "pigment { rgb 1 } finish { ambient .1 reflection .5 } }",
             level, bailout);
    check(&look, text, sum, sum, sum);
}

TEST(levels)
{
    check_series(1, 0, 1);
    check_series(2, 0, 2);
    check_series(7, 0, 7);
    check_series(20, .25, 3); /* a weight equal to the threshold is followed */
    check_series(20, .2500001, 2);
    check_series(20, 1. / 255, 8);
}

/* ---- Glass -------------------------------------------------------------- */

/* Returns the lateral displacement of a ray at 45 degrees in a layer of index n; the
 * sine inside is sin a / n. */
static double aside(double n, double depth)
{
    double s = sqrt(.5) / n;
    return depth * s / sqrt(1 - s * s);
}

/* A ray at 45 degrees that enters objects at z = 0 leaves them at this displacement and
 * depth, in its original direction. */
static void check_behind(const char *things, double shift, double depth)
{
    const struct look look = { { 0, 2, -2 }, { 0, -1, 1 } };
    char text[2048];
    snprintf(text, sizeof text,
             "%s sphere { <0, %.17g, %.17g>, 1e-6 pigment { rgb .8 } " LAMP "}", things,
             -shift - 1, depth + 1);
    check(&look, text, .8, .8, .8);
}

static void check_slab(double n, double depth)
{
    char text[512];
    snprintf(text, sizeof text,
             "box { <-9, -9, 0>, <9, 9, %.17g> "
             "pigment { rgbt 1 } interior { ior %.17g } } ",
             depth, n);
    check_behind(text, aside(n, depth), depth);
}

TEST(snell)
{
    check_slab(1.5, .7);
    check_slab(1.33, 2);
    check_slab(2.4, .1);
    check_slab(1, 1);
    check_slab(.8, 1);
}

/* A ball of index n focuses rays near its axis at n / (2 (n - 1)) radii from its
 * centre. */
TEST(ball_lens)
{
    const struct look look = { { 0, 1e-4, -5 }, { 0, 0, 1 } };
    check(&look,
          "sphere { 0, 1 pigment { rgbt 1 } interior { ior 1.5 } } "
          "sphere { 1.5*z, 1e-6 pigment { rgb .6 } " LAMP "}",
          .6, .6, .6);
}

/* From inside glass, below y = 0, the ray reaches a blue sky or, from 41.81 degrees on,
 * returns to the red ground. Total reflection returns all light; the surface's own
 * reflection has no effect then. */
static void check_from_below(double degrees, double red, double blue)
{
    double angle = degrees * 3.14159265358979323846 / 180;
    const struct look look = { { 0, -1, 0 }, { sin(angle), cos(angle), 0 } };
    check(&look,
          "background { rgb z } plane { y, 0 pigment { rgbt .25 } "
          "finish { reflection .5 } interior { ior 1.5 } } "
          "plane { y, -9 pigment { rgb x } finish { ambient 1 } }",
          red, 0, blue);
}

TEST(total_reflection)
{
    check_from_below(0, .5, .25);
    check_from_below(41.8, .5, .25);
    check_from_below(41.82, 1, 0);
    check_from_below(80, 1, 0);
}

/* Transmitted light, and the remaining colour and highlights of the surface. */
TEST(what_passes)
{
    struct look look = ZAHEAD;
    check(&look,
          "background { rgb 1 } plane { -z, 0 "
          "pigment { rgbft <.8, .5, .2, .5, .25> } }",
          .65, .5, .35);
    check(&look,
          "background { rgb 1 } plane { -z, 0 "
          "pigment { rgbft <.8, .5, .2, .5, .25> } finish { ambient 1 } }",
          .65 + .2, .5 + .125, .35 + .05);
    check(&look,
          "background { rgb .5 } plane { -z, 0 "
          "pigment { rgbt <.5, .5, .5, .5> } finish { reflection .25 } }",
          .375, .375, .375);
    check(&look,
          "light_source { -9*z, .5 } plane { -z, 0 pigment { rgbt <.8, .8, .8, .75> } "
          "finish { diffuse .5 specular .5 } }",
          .3, .3, .3); /* .5 (.5 .8 .25 + .5) */
    check(&look,
          "background { rgb 1 } plane { -z, 0 pigment { "
          "checker rgbt <0, 0, 0, .5> rgb 0 translate -.5 } }",
          .5, .5, .5);
}

/* If the transmitted weight, or its brightness, is below the threshold, the ray is not
 * followed. */
TEST(too_dark)
{
    struct look look = ZAHEAD;
    const char *text = "background { rgb 1 } "
                       "global_settings { adc_bailout .5 } plane { -z, 0 pigment { ";
    static const struct {
        const char *pigment;
        double red, green;
    } rows[] = {
        { "rgbf <.9, .9, 0, 1> } }", .9, .9 },
        { "rgbf <.9, 0, 0, 1> } }", 0, 0 }, /* brightness .267 */
        { "rgbt <0, 0, 0, .5> } }", 0, 0 },
    };
    char whole[512];
    for (size_t i = 0; i < COUNT(rows); i++) {
        snprintf(whole, sizeof whole, "%s%s", text, rows[i].pigment);
        check(&look, whole, rows[i].red, rows[i].green, 0);
    }
}

/* ---- Glass in glass ----------------------------------------------------- */

#define GLASS "pigment { rgbt 1 } interior { ior 1.5 } "
#define WATER "pigment { rgbt 1 } interior { ior 1.33 } "
#define SLAB(low, high) "box { <-9, -9, " #low ">, <9, 9, " #high "> "

/* For concentric balls, n times the ray's distance from the centre is the same in all
 * media; it determines the sine of the angle at each surface. The ray is refracted four
 * times, and passes the centre at the same distance as without the balls. */
TEST(ball_in_water)
{
    double b = .3;
    const struct look look = { { 0, b, -5 }, { 0, 0, 1 } };
    double turned = asin(b / 2) - asin(b / 1.33 / 2) + asin(b / 1.33) - asin(b / 1.5);
    char text[512];
    snprintf(text, sizeof text,
             "sphere { 0, 2 " WATER "} sphere { 0, 1 " GLASS "} "
             "sphere { %.17g*z, 1e-6 pigment { rgb .6 } " LAMP "}",
             b / sin(2 * turned));
    check(&look, text, .6, .6, .6);
}

/* The medium that was entered last counts until it is left. Leaving the other one
 * before that changes nothing. */
TEST(overlapping)
{
    double glass = aside(1.5, .5), water = aside(1.33, .5);
    check_behind(SLAB(0, 1) GLASS "} " SLAB(.5, 1.5) WATER "} ", glass + 2 * water,
                 1.5);
    check_behind(SLAB(0, 1.5) WATER "} " SLAB(.5, 1) GLASS "} ", glass + 2 * water,
                 1.5);
    check_behind(SLAB(0, 1.5) GLASS "} " SLAB(.5, 1) WATER "} ", 2 * glass + water,
                 1.5);
    check_behind(SLAB(0, 1.5) WATER
                 "} " SLAB(.5, 1) "pigment { rgbt 1 } interior { ior 1 } } ",
                 .5 + 2 * water, 1.5);
    check_behind(SLAB(0, 1) GLASS "} " SLAB(.5, 1.5) GLASS "} ", 3 * glass, 1.5);
    check_behind(SLAB(0, 1.5) GLASS "} " SLAB(.5, 2) WATER "} " SLAB(1, 2.5) GLASS "} ",
                 4 * glass + water, 2.5);
}

/* In a union with one interior, every second surface is an exit. */
TEST(shared_interior)
{
    double glass = aside(1.5, .5);
    check_behind("union { " SLAB(0, 1) "} " SLAB(.5, 1.5) "} " GLASS "} ",
                 glass + .5 + glass, 1.5);
    check_behind("merge { " SLAB(0, 1) "} " SLAB(.5, 1.5) "} " GLASS "} ", 3 * glass,
                 1.5);
}

/* The eye is inside a ball, off its centre. A mirror in the ball does not change the
 * medium of the ray. */
static void check_from_within(double along, const char *things)
{
    double b = .5, radius = 2;
    const struct look look = { { 0, b, 0 }, { 0, 0, along } };
    double turned = asin(1.5 * b / radius) - asin(b / radius);
    char text[512];
    snprintf(text, sizeof text,
             "sphere { 0, 2 " GLASS "} %s"
             "sphere { %.17g*z, 1e-6 pigment { rgb .6 } " LAMP "}",
             things, 1.5 * b / sin(turned));
    check(&look, text, .6, .6, .6);
}

TEST(eye_within)
{
    check_from_within(1, "");
    check_from_within(-1, SLAB(-.6, -.5) "scale <.1, .1, 1> "
                                         "finish { reflection 1 } } ");
}

/* The ray enters the front of a block, is totally reflected at a side, which it hits at
 * 62 degrees, and leaves through the back. */
TEST(total_keeps)
{
    const struct look look = { { -1.5, 0, -3 }, { 1, 0, 1 } };
    char text[512];
    snprintf(text, sizeof text,
             "box { -1, 1 " GLASS "} "
             "sphere { <%.17g, 0, 2>, 1e-6 pigment { rgb .7 } " LAMP "}",
             2 - (.5 + aside(1.5, 2)) - 1);
    check(&look, text, .7, .7, .7);
}

/* A ray that continues straight, because the indices on both sides are equal, keeps the
 * level of its parent. At the last level no ray is transmitted. */
static void check_level(int level, const char *things, double seen)
{
    struct look look = ZAHEAD;
    char text[1024];
    snprintf(text, sizeof text,
             "global_settings { max_trace_level %d } background { rgb .6 } %s", level,
             things);
    check(&look, text, seen, seen, seen);
}

TEST(straight_levels)
{
    static const char panes[] = "#for (I, 1, 8) box { <-1, -1, I>, <1, 1, "
                                "I + .5> pigment { rgbt 1 } } #end ";
    static const char same[] = SLAB(0, 1) GLASS "} " SLAB(.5, 1.5) GLASS "} ";
    static const char other[] = SLAB(0, 1) GLASS "} " SLAB(.5, 1.5) WATER "} ";
    char mirrored[512];
    check_level(1, panes, 0);
    check_level(2, panes, .6);
    snprintf(mirrored, sizeof mirrored,
             "%s plane { -z, -20 finish { reflection .5 } } ", panes);
    check_level(2, mirrored, 0);
    check_level(3, mirrored, .3);
    check_level(2, same, 0);
    check_level(3, same, .6);
    check_level(3, other, 0);
    check_level(4, other, .6);
}

/* Returns Fresnel reflectance at normal incidence. */
static double straight_share(double index)
{
    return (index - 1) * (index - 1) / ((index + 1) * (index + 1));
}

/* Returns Fresnel reflectance at 45 degrees, where the reflectance of one polarisation
 * is the square of the other's. */
static double slanted_share(double index)
{
    double inside = sqrt(index * index - .5), across = sqrt(.5);
    double share = pow((across - inside) / (across + inside), 2);
    return (share + share * share) / 2;
}

/* In water the reflectance of glass is lower. In an opaque body each surface reflects
 * as seen from the side of the ray; the second one here reflects totally, as from
 * inside glass. */
TEST(fresnel)
{
#define FRESNEL "finish { reflection { 0, 1 fresnel } } interior { ior 1.5 } "
    struct look look = ZAHEAD;
    const struct look slanted = { { 0, 0, 0 }, { 1, 0, 1 } };
    double in_air = straight_share(1.5), in_water = straight_share(1.5 / 1.33);
    double once = slanted_share(1.5);
    check(&look, "background { rgb 1 } " SLAB(1, 2) FRESNEL "} ", in_air, in_air,
          in_air);
    check(&look,
          "global_settings { adc_bailout 1/1000 } "
          "background { rgb 1 } plane { -z, 0 " WATER "} " SLAB(1, 2) FRESNEL "} ",
          in_water, in_water, in_water);
    check(&slanted,
          "plane { -z, -4 " FRESNEL "} plane { -z, 4 " FRESNEL "} "
          "sphere { <14, 0, -2>, .1 pigment { rgb 1 } " LAMP "} ",
          once, once, once);
}

/* ---- Shadows ------------------------------------------------------------ */

/* Checks the colour of the floor below a light, with an object in between. */
static void check_shadow(const char *between, double red, double green)
{
    const struct look look = { { 1, 1, 0 }, { -1, -1, 0 } };
    char text[1024];
    snprintf(text, sizeof text,
             "light_source { 10*y, rgb <1, 1, 0> } "
             "plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } } %s",
             between);
    check(&look, text, red, green, 0);
}

#define CLEAR "pigment { rgbf <.8, .5, .2, 1> } "

TEST(shadows)
{
    check_shadow("", 1, 1);
    check_shadow("sphere { 5*y, 1 }", 0, 0);
    check_shadow("sphere { 5*y, 1 no_shadow }", 1, 1);
    check_shadow("sphere { 15*y, 1 }", 1, 1);
    check_shadow("plane { y, 9.9995 }", 1, 1);
    check_shadow("plane { y, 9.998 }", 0, 0);
    check_shadow("plane { y, 5 " CLEAR "}", .8, .5);
    check_shadow("sphere { 5*y, 1 " CLEAR "}", .64, .25);
    check_shadow("sphere { 5*y, 1 " CLEAR "interior { ior 1.5 } "
                 "finish { reflection .5 } }",
                 .64, .25);
    check_shadow("sphere { 10*y, 1 " CLEAR "}", .8, .5);
    check_shadow("sphere { 5*y, 1 " CLEAR "} plane { y, 2 }", 0, 0);
    check_shadow("sphere { 5*y, 1 pigment { rgbf <0, 1, 0, 1> } }", 0, 1);
}

/* Coincident surfaces of a merge count once. */
TEST(shadows_of_solids)
{
    check_shadow("union { sphere { 5*y, 1 } sphere { 5*y, .5 } " CLEAR "}", .4096,
                 .0625);
    check_shadow("merge { sphere { 5*y, 1 } sphere { 5*y, .5 } " CLEAR "}", .64, .25);
    check_shadow("difference { sphere { 5*y, 1 } sphere { 5*y, .5 } " CLEAR "}", .4096,
                 .0625);
    check_shadow("merge { sphere { 5*y, 1 } sphere { 5*y, 1 } " CLEAR "}", .64, .25);
    check_shadow("merge { box { 4, 6 translate <-5, 0, -5> } box { <-1, 6, "
                 "-1>, <1, 7, 1> } " CLEAR "}",
                 .64, .25);
    check_shadow("difference { sphere { 5*y, 1 " CLEAR "} "
                 "box { <-1, 2, -1>, <1, 5, 1> } }",
                 0, 0);
}
