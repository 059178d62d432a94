/* test_scene_size.c - scenes that are scaled by 10^-8 to 10^8 are compared with the
 * scene of size 1. Frames in every form are compared, and areas, volumes and moments,
 * divided by a power of the scale. A tolerance that does not scale with the scene fails
 * here. */
#define SMALL_FRAMES
#include "rt/heat/heat.h"
#include "rt/mass/mass.h"
#include "tests/unit/traced_frame.h"

enum { DECADES = 8, STEP = 6, MAX_OTHERS = 2 };

/* Shapes around the origin that fill a picture. Each shape is in a separate scene. */
static const char *const shapes[] = {
    "sphere { <-.6, .3, 0>*S, .9*S pigment { rgbf .9 } interior { ior 1.5 } }"
    "sphere { <.8, 0, 1>*S, S pigment { rgb .5 } finish { reflection .6 } }",
    "box { <-1, -1, -1>*S, <0, .5, .5>*S pigment { rgbt .8 } }"
    "difference { box { <0, -1, -1>*S, S } cylinder { -2*S*z, 2*S*z, .4*S }"
    " rotate 30*y pigment { rgb <1, .4, .2> } finish { reflection .3 } }",
    "cylinder { -S*y, .5*S*y, S open }"
    "cone { <.5, -1, -1>*S, .8*S, <.5, 1, -1>*S, .1*S pigment { rgbf .8 } }",
    "torus { .9*S, .35*S rotate -50*x pigment { rgb <.3, .6, 1> } finish {"
    " reflection .3 } }",
    "torus { .9, .35 rotate -50*x pigment { checker rgb 1, rgb .2 scale .3 }"
    " finish { specular .7 } scale S }",
    "quadric { <1, 2, 1>/(S*S), <.3, 0, 0>/(S*S), <0, .2, 0>/S, -1 }",
    "quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -2*S*S, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, "
    "0, 2, 0, 1.5*S*S, 0, 0, 0, 0, 1, 0, -2*S*S, 0, .6*S*S*S*S> rotate 60*x }",
    "mesh { triangle { <-1, -1, 0>*S, <1, -1, .3>*S, <0, 1, .5>*S }"
    " smooth_triangle { <-1, -1, 0>*S, <-1, -1, -1>, <0, -.5, -1>*S,"
    " <0, 0, -1>, <-.2, .6, -.3>*S, <0, 1, -1> } }",
    "blob { threshold .6 sphere { 0, S, 1 } sphere { <.8, .4, 0>*S, .9*S, 1 }"
    " cylinder { -S, <-.5, .5, 0>*S, .6*S, 1 } pigment { rgb <.8, .8, .2> } }",
    "prism { -.4*S, .4*S, 5, <-1, -1>*S, <1, -1>*S, <.6, 1>*S, <-.4, .5>*S,"
    " <-1, -1>*S rotate -70*x pigment { rgbf .7 } interior { ior 1.3 } }",
    "prism { quadratic_spline -.4*S, .4*S, 6, <-1, -2>*S, <-1, -1>*S,"
    " <1, -1>*S, <.6, 1>*S, <-.4, .5>*S, <-1, -1>*S rotate -70*x }",
    "lathe { linear_spline 4, <.2, -1>*S, <.9, -.5>*S, <.5, .5>*S, <.1, 1>*S"
    " pigment { gradient y color_map { [0 rgb 1] [1 rgb .3] } scale .4*S } }",
    "disc { <0, 0, 0>, <.3, .4, -1>, 1.2*S, .4*S }"
    "polygon { 4, <-1, -1, .5>*S, <1, -1, .5>*S, <1, 1, .5>*S, <-1, 1, .5>*S"
    " normal { onion .7 scale .2*S } }",
    "sphere { -.9*x, .8 normal { onion .7 scale .1 } scale S }"
    "sphere { .9*S*x, .8*S normal { average normal_map { [1 leopard .7 scale "
    ".1] [1 quilted .5 scale .3] } scale <2, 1, 1>*S } }",
    "bicubic_patch { type 1 flatness 0 u_steps 2 v_steps 2 <-1, -1, 0>*S, <-.3, -1, "
    "-1>*S, <.3, -1, 1>*S, <1, -1, 0>*S <-1, -.3, 0>*S, <-.3, -.3, -1>*S, <.3, -.3, "
    "1>*S, <1, -.3, 0>*S <-1, .3, 0>*S, <-.3, .3, -1>*S, <.3, .3, 1>*S, <1, .3, 0>*S "
    "<-1, 1, 0>*S, <-.3, 1, -1>*S, <.3, 1, 1>*S, <1, 1, 0>*S }",
    "height_field { function 5, 5 { x*y } smooth translate <-.5, -.5, -.5>"
    " scale 2*S rotate -60*x }",
};
static const char *const lights[] = {
    "light_source { <6, 12, -9>*S, 1 }",
    "light_source { <6, 12, -9>*S, 1 area_light 3*S*x, 3*S*z, 2, 3"
    " fade_distance 9*S fade_power 2 }",
    "light_source { <6, 12, -9>*S, 1 spotlight point_at 0 radius 5 falloff 12 }"
    "light_source { <-3, 9, -9>*S, .6 cylinder point_at 0 radius S falloff 2*S }",
    "light_source { <6, 12, -9>*S, 1 parallel point_at 0 } fog { distance 30*S"
    " color rgb .4 }",
};
static const char *const cameras[] = {
    "camera { location <1.5, 2.5, -7>*S look_at <0, -.1, 0>*S angle 32 }",
    "camera { orthographic location <1.5, 2.5, -7>*S look_at 0"
    " right 3.6*S*x up 3*S*y }",
};

static struct words *frame_of(size_t shape, size_t light, int decade, double *unit)
{
    static char text[1 << 14];
    snprintf(text, sizeof text,
             "#version 3.7; global_settings { assumed_gamma 1 }\n"
             "#declare S = pow(10, %d);\n%s\n%s\n%s\n"
             "plane { y, -1.4*S pigment { checker rgb 1, rgb .5 scale S } }\n",
             decade, cameras[shape % 2], lights[light], shapes[shape]);
    SCOPED(scene) *scene = read_text(text);
    struct words *words = same_frame_of(scene, text);
    *unit = ldexp(1, scene->unit_log);
    return words;
}

static double difference(const struct words *one, const struct words *other,
                         size_t pixel, double scale)
{
    double most = 0;
    for (int i = 0; i <= CHANNEL_NORMAL_Z; i++)
        most = fmax(most, fabs(c205_to_double(one->channel[i][pixel])
                               - c205_to_double(other->channel[i][pixel])
                                     * (i == CHANNEL_DEPTH ? scale : 1)));
    return most;
}

static void compare_frames(const struct words *same, size_t shape, size_t light,
                           int decade)
{
    double unit;
    FREED struct words *words = frame_of(shape, light, decade, &unit);
    size_t others = 0;
    unit *= pow(10, -decade);
    for (size_t pixel = 0; pixel < PIXELS; pixel++)
        others += difference(same, words, pixel, unit) > 1e-4;
    FAIL_IF(others > MAX_OTHERS, "shape %zu, light %zu, 10^%d: %zu pixels of %d differ",
            shape, light, decade, others, PIXELS);
}

TEST(pictures)
{
    traced.reported = true;
    memcpy(traced.queues, (const size_t[]){ 40, 0 }, 2 * sizeof(size_t));
    for (size_t i = 0; i < COUNT(shapes); i++) {
        size_t light = (i + i / 4) % (COUNT(lights));
        double unit;
        FREED struct words *same = frame_of(i, light, 0, &unit);
        assert_true(unit == 1);
        for (int decade = (int)(i % STEP) - DECADES; decade <= DECADES; decade += STEP)
            compare_frames(same, i, light, decade);
    }
}

#define BODIES \
    "#declare S = pow(10, %d); sphere { 0, S } torus { 2*S, .3*S }\n" \
    "box { <3, 0, 0>*S, <4, 1, 2>*S rotate 20*y }\n"

static struct scene *bodies_of(int decade)
{
    return read_text(formatted(BODIES, decade));
}

/* Returns the figures of all bodies. The reference point is not the origin. */
static struct mass_figures figures_of(int decade)
{
    const char *densities[] = { "default=2" };
    struct mass_request request = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 2000,
                                           .densities = densities, .density_count = 1,
                                           .about = { 0, pow(10, decade), 0 },
                                           .points = POINTS_LATTICE, .rays = 2048,
                                           .repeats = 8, .seed = 1, .jobs = 1);
    SCOPED(scene) *scene = bodies_of(decade);
    struct diagnostics reports = { 0 };
    SCOPED_VALUE(mass) mass;
    REQUIRE(mass_begin(scene, &request, &mass, &reports, &failure)
            && mass_find(&mass, &failure));
    return mass.rows[mass.row_count - 1].figures;
}

static void assert_near(double value, double expected, double power, int decade)
{
    expected *= pow(10, decade * power);
    assert_true(fabs(value - expected) <= .02 * fabs(expected));
}

TEST(masses)
{
    struct mass_figures same = figures_of(0);
    for (int decade = -DECADES; decade <= DECADES; decade += STEP - 1) {
        struct mass_figures found = figures_of(decade);
        assert_near(found.value[FIGURE_VOLUME], same.value[FIGURE_VOLUME], 3, decade);
        assert_near(found.value[FIGURE_AREA], same.value[FIGURE_AREA], 2, decade);
        assert_near(found.value[FIGURE_MASS], same.value[FIGURE_MASS], 3, decade);
        assert_near(found.value[FIGURE_CENTROID], same.value[FIGURE_CENTROID], 1,
                    decade);
        assert_near(found.value[FIGURE_INERTIA], same.value[FIGURE_INERTIA], 5, decade);
        assert_near(found.value[FIGURE_PRINCIPAL + 2], same.value[FIGURE_PRINCIPAL + 2],
                    5, decade);
    }
}

/* Computes the area of the sphere, its factor to the torus and its heat loss. */
static void heat_of(int decade, double found[3])
{
    const char *temperatures[] = { "default=300", "line 1=900" };
    struct heat_request request = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 2000,
                                           .by = BY_PRIMITIVE, .drawn = 256,
                                           .repeats = 4, .lattice = true, .seed = 1,
                                           .exchange = true,
                                           .temperatures = temperatures,
                                           .temperature_count = 1);
    SCOPED(scene) *scene = bodies_of(decade);
    SCOPED_VALUE(heat) heat;
    REQUIRE(heat_begin(scene, &request, &heat, &failure) && heat_find(&heat, &failure));
    found[0] = heat.surfaces.list[0].area.value;
    found[1] = heat.surfaces.list[0].factor[1].value;
    found[2] = heat.thermal.exchange.flow[0];
}

TEST(heat)
{
    double same[3], found[3];
    heat_of(0, same);
    for (int decade = -DECADES; decade <= DECADES; decade += STEP - 1) {
        heat_of(decade, found);
        assert_near(found[0], same[0], 2, decade);
        assert_near(found[1], same[1], 0, decade);
        assert_near(found[2], same[2], 2, decade);
    }
}
