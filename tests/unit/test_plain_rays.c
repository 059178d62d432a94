/* test_plain_rays.c - colours of the plain tracer's mirrors, glass and shadows are
 * compared with values computed by hand, for scenes with luminous objects. A wrong
 * index, level or weight of a ray fails here. */
#include "tests/unit/plain_ray.h"

#define HEAD \
    "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 10 } " \
    "#default { finish { ambient 0 diffuse 0 } } "

/* Compares the colour of a ray through a scene, whose text printf formats. */
#define check(look, red, green, blue, ...) \
    check_text(look, red, green, blue, formatted(__VA_ARGS__))

static void check_text(const struct look *look, double red, double green, double blue,
                       const char *text)
{
    double color[FRAME_CHANNELS];
    trace_ray(look, HEAD, text, color);
    FAIL_IF(!(fabs(color[0] - red) < CLOSE && fabs(color[1] - green) < CLOSE
              && fabs(color[2] - blue) < CLOSE),
            "%s: %.15g %.15g %.15g", text, color[0], color[1], color[2]);
}

#define LAMP "finish { ambient 1 } "

static const struct look onto_floor = { { -4, 3, 0 }, { 4, -3, 0 } };
static const struct look ahead = { { 0, 0, -5 }, { 0, 0, 1 } };

/* ---- Colours ------------------------------------------------------------ */

#define DARK \
    "background { rgb 1 } " \
    "global_settings { adc_bailout .5 } plane { -z, 0 pigment { "

TEST(colors)
{
    const struct look onto_ball = { { -3, 4, 0 }, { 3, -3, 0 } };
    const struct look near_axis = { { 0, 1e-4, -5 }, { 0, 0, 1 } };
    const struct {
        const struct look *look;
        double red, green, blue;
        const char *text;
    } rows[] = {
        /* Seen from <-4, 3, 0>, a floor shows the lamp at <4, 3, 0> in the origin,
         * tinted only by the mirror. */
        { &onto_floor, .45, .25, .1,
          "plane { y, 0 pigment { rgb 1 } finish { reflection <.9, .5, .2> } } "
          "sphere { <4, 3, 0>, 1e-6 pigment { rgb .5 } " LAMP "}" },
        { &onto_floor, .1 + .25, .2 + .25, .3 + .25,
          "plane { y, 0 pigment { rgb <.1, .2, .3> } "
          "finish { ambient 1 reflection .5 } } background { rgb .5 }" },
        { &onto_floor, 0, 0, 0,
          "plane { y, 0 finish { reflection .5 } } "
          "sphere { <4, 3.00001, 0>, 1e-6 pigment { rgb .5 } " LAMP "}" },
        /* The ray hits the ball where camera and lamp are mirror images of each other.
         * The normal there is halfway between them. */
        { &onto_ball, .7, .7, .7,
          "sphere { 0, 1 finish { reflection 1 } } "
          "sphere { <3, 4, 0>, 1e-6 pigment { rgb .7 } " LAMP "}" },
        /* A ball of index n focuses rays near its axis at n / (2 (n - 1)) radii from
         * its centre. */
        { &near_axis, .6, .6, .6,
          "sphere { 0, 1 pigment { rgbt 1 } interior { ior 1.5 } } "
          "sphere { 1.5*z, 1e-6 pigment { rgb .6 } " LAMP "}" },
        /* Transmitted light, and the remaining colour and highlights of the surface. */
        { &ahead, .65, .5, .35,
          "background { rgb 1 } plane { -z, 0 "
          "pigment { rgbft <.8, .5, .2, .5, .25> } }" },
        { &ahead, .65 + .2, .5 + .125, .35 + .05,
          "background { rgb 1 } plane { -z, 0 "
          "pigment { rgbft <.8, .5, .2, .5, .25> } finish { ambient 1 } }" },
        { &ahead, .375, .375, .375,
          "background { rgb .5 } plane { -z, 0 "
          "pigment { rgbt <.5, .5, .5, .5> } finish { reflection .25 } }" },
        { &ahead, .3, .3, .3, /* .5 (.5 .8 .25 + .5) */
          "light_source { -9*z, .5 } plane { -z, 0 pigment { rgbt <.8, .8, .8, .75> } "
          "finish { diffuse .5 specular .5 } }" },
        { &ahead, .5, .5, .5,
          "background { rgb 1 } plane { -z, 0 pigment { "
          "checker rgbt <0, 0, 0, .5> rgb 0 translate -.5 } }" },
        /* A ray whose weight or brightness is below the threshold is not traced. */
        { &ahead, .9, .9, 0, DARK "rgbf <.9, .9, 0, 1> } }" },
        { &ahead, 0, 0, 0, DARK "rgbf <.9, 0, 0, 1> } }" }, /* brightness .267 */
        { &ahead, 0, 0, 0, DARK "rgbt <0, 0, 0, .5> } }" },
    };
    for (size_t i = 0; i < COUNT(rows); i++)
        check(rows[i].look, rows[i].red, rows[i].green, rows[i].blue, "%s",
              rows[i].text);
}

/* The reflections between two facing mirrors form a geometric series. It ends at the
 * largest level, or at the threshold of the weight. */
static void check_series(int level, double bailout, int terms)
{
    static const struct look look = { { 0, 0, 1 }, { 0, 0, 1 } };
    double sum = 0;
    for (int i = 0; i < terms; i++)
        sum += .1 * pow(.5, i);
    check(&look, sum, sum, sum,
          "global_settings { max_trace_level %d adc_bailout %.17g } "
          "box { 0, <9, 9, 2> translate <-4, -4, 0> "
          "pigment { rgb 1 } finish { ambient .1 reflection .5 } }",
          level, bailout);
}

TEST(levels)
{
    check_series(1, 0, 1);
    check_series(2, 0, 2);
    check_series(7, 0, 7);
    check_series(20, .25, 3); /* a ray whose weight equals the threshold is traced */
    check_series(20, .2500001, 2);
    check_series(20, 1. / 255, 8);
}

/* ---- Glass -------------------------------------------------------------- */

/* Returns the lateral shift of a ray at 45 degrees in a layer of index n. */
static double aside(double n, double depth)
{
    double s = sqrt(.5) / n;
    return depth * s / sqrt(1 - s * s);
}

/* A ray enters objects at z = 0 at 45 degrees. It leaves them at this depth, with this
 * displacement, in its original direction. */
static void check_behind(const char *things, double shift, double depth)
{
    const struct look look = { { 0, 2, -2 }, { 0, -1, 1 } };
    check(&look, .8, .8, .8,
          "%s sphere { <0, %.17g, %.17g>, 1e-6 pigment { rgb .8 } " LAMP "}", things,
          -shift - 1, depth + 1);
}

static void check_slab(double n, double depth)
{
    const char *text = formatted("box { <-9, -9, 0>, <9, 9, %.17g> "
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

/* From inside glass, below y = 0, the ray reaches a blue sky. From 41.81 degrees on, it
 * returns to the red ground. Total reflection returns all light, and the surface's own
 * reflection then has no effect. */
static void check_from_below(double degrees, double red, double blue)
{
    double angle = degrees * 3.14159265358979323846 / 180;
    const struct look look = { { 0, -1, 0 }, { sin(angle), cos(angle), 0 } };
    check(&look, red, 0, blue,
          "background { rgb z } plane { y, 0 pigment { rgbt .25 } "
          "finish { reflection .5 } interior { ior 1.5 } } "
          "plane { y, -9 pigment { rgb x } finish { ambient 1 } }");
}

TEST(total_reflection)
{
    check_from_below(0, .5, .25);
    check_from_below(41.8, .5, .25);
    check_from_below(41.82, 1, 0);
    check_from_below(80, 1, 0);
}

/* ---- Glass in glass ----------------------------------------------------- */

#define GLASS "pigment { rgbt 1 } interior { ior 1.5 } "
#define WATER "pigment { rgbt 1 } interior { ior 1.33 } "
#define SLAB(low, high) "box { <-9, -9, " #low ">, <9, 9, " #high "> "

/* For concentric balls, n times the ray's distance from the centre is the same in all
 * media. It determines the sine of the angle at each surface. The ray is refracted four
 * times, and passes the centre at the same distance as without the balls. */
TEST(ball_in_water)
{
    double b = .3;
    const struct look look = { { 0, b, -5 }, { 0, 0, 1 } };
    double turned = asin(b / 2) - asin(b / 1.33 / 2) + asin(b / 1.33) - asin(b / 1.5);
    check(&look, .6, .6, .6,
          "sphere { 0, 2 " WATER "} sphere { 0, 1 " GLASS "} "
          "sphere { %.17g*z, 1e-6 pigment { rgb .6 } " LAMP "}",
          b / sin(2 * turned));
}

/* The medium that was entered last counts until it is left. If the ray leaves the other
 * medium before, nothing changes. */
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

/* The camera is inside a ball. A mirror in it does not change the ray's medium. */
static void check_from_within(double along, const char *things)
{
    double b = .5, radius = 2;
    const struct look look = { { 0, b, 0 }, { 0, 0, along } };
    double turned = asin(1.5 * b / radius) - asin(b / radius);
    check(&look, .6, .6, .6,
          "sphere { 0, 2 " GLASS "} %s"
          "sphere { %.17g*z, 1e-6 pigment { rgb .6 } " LAMP "}",
          things, 1.5 * b / sin(turned));
}

TEST(eye_within)
{
    check_from_within(1, "");
    check_from_within(-1, SLAB(-.6, -.5) "scale <.1, .1, 1> "
                                         "finish { reflection 1 } } ");
}

/* The ray enters the front of a block, hits a side at 62 degrees, where it is totally
 * reflected, and leaves through the back. */
TEST(total_keeps)
{
    const struct look look = { { -1.5, 0, -3 }, { 1, 0, 1 } };
    check(&look, .7, .7, .7,
          "box { -1, 1 " GLASS "} "
          "sphere { <%.17g, 0, 2>, 1e-6 pigment { rgb .7 } " LAMP "}",
          2 - (.5 + aside(1.5, 2)) - 1);
}

/* A ray continues straight and keeps the level of its parent if the indices on both
 * sides are equal. At the last level no ray is transmitted. */
static void check_level(int level, const char *things, double seen)
{
    check(&ahead, seen, seen, seen,
          "global_settings { max_trace_level %d } background { rgb .6 } %s", level,
          things);
}

#define PANES \
    "#for (I, 1, 8) box { <-1, -1, I>, <1, 1, I + .5> pigment { rgbt 1 } } #end "

TEST(straight_levels)
{
    static const struct {
        const char *text;
        int level; /* level at which the ray arrives */
        double seen;
    } rows[] = {
        { PANES, 2, .6 },
        { PANES "plane { -z, -20 finish { reflection .5 } } ", 3, .3 },
        { SLAB(0, 1) GLASS "} " SLAB(.5, 1.5) GLASS "} ", 3, .6 },
        { SLAB(0, 1) GLASS "} " SLAB(.5, 1.5) WATER "} ", 4, .6 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        check_level(rows[i].level - 1, rows[i].text, 0);
        check_level(rows[i].level, rows[i].text, rows[i].seen);
    }
}

/* Returns the Fresnel reflectance at normal incidence. */
static double straight_share(double index)
{
    return (index - 1) * (index - 1) / ((index + 1) * (index + 1));
}

/* Returns the Fresnel reflectance at 45 degrees, where the reflectance of one
 * polarisation is the square of the other. */
static double slanted_share(double index)
{
    double inside = sqrt(index * index - .5), across = sqrt(.5);
    double share = pow((across - inside) / (across + inside), 2);
    return (share + share * share) / 2;
}

/* In water the reflectance of glass is lower. In an opaque body each surface reflects
 * as seen from the side of the ray. The second one reflects totally. */
TEST(fresnel)
{
#define FRESNEL "finish { reflection { 0, 1 fresnel } } interior { ior 1.5 } "
    const struct look slanted = { { 0, 0, 0 }, { 1, 0, 1 } };
    double in_air = straight_share(1.5), in_water = straight_share(1.5 / 1.33);
    double once = slanted_share(1.5);
    check(&ahead, in_air, in_air, in_air,
          "background { rgb 1 } " SLAB(1, 2) FRESNEL "} ");
    check(&ahead, in_water, in_water, in_water,
          "global_settings { adc_bailout 1/1000 } "
          "background { rgb 1 } plane { -z, 0 " WATER "} " SLAB(1, 2) FRESNEL "} ");
    check(&slanted, once, once, once,
          "plane { -z, -4 " FRESNEL "} plane { -z, 4 " FRESNEL "} "
          "sphere { <14, 0, -2>, .1 pigment { rgb 1 } " LAMP "} ");
}

/* ---- Shadows ------------------------------------------------------------ */

/* Checks the colour of the floor below a light, with an object between them. */
static void check_shadow(const char *between, double red, double green)
{
    const struct look look = { { 1, 1, 0 }, { -1, -1, 0 } };
    check(&look, red, green, 0,
          "light_source { 10*y, rgb <1, 1, 0> } "
          "plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } } %s",
          between);
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
