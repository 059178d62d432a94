/* test_scene_maps.c - the scene language. Colour maps, patterns and skies are compared
 * with expected entries. A stop out of order, a lost wave or transform fails here. */
#include "rt/scene/transform.h"
#include "tests/random.h"
#include "tests/unit/scene_reading.h"

static void check_map(const struct color_map *map, const char *expected)
{
    char found[1024], *to = found;
    *to = '\0';
    for (size_t i = 0; i < map->count; i++)
        to += sprintf(to, "%g:%g,%g,%g ", map->stops[i].at, map->stops[i].color[0],
                      map->stops[i].color[1], map->stops[i].color[2]);
    assert_string_equal(found, expected);
}

/* Checks a sphere's pigment, written directly, by name, and in a named texture. */
static void check_pigment(const char *words, enum pigment_kind kind,
                          const char *expected)
{
    static const char *const forms[] = {
        "sphere { 0, 1 pigment { %s } }",
        "#declare P = pigment { %s } sphere { 0, 1 pigment { P } }",
        "#declare T = texture { pigment { %s } } sphere { 0, 1 texture { T } }",
    };
    for (size_t i = 0; i < COUNT(forms); i++) {
        SCOPED(scene) *scene = read_format(forms[i], words);
        const struct pigment *pigment = &scene->primitives[0].pigment;
        assert_int_equal(pigment->kind, kind);
        check_map(&pigment->map, expected);
        assert_false(pigment_is_clear(pigment));
    }
}

#define TWO "0:1,0,0 0.5:0,0,1 "

static struct pattern pattern_of(const char *words)
{
    SCOPED(scene) *scene = read_format("sphere { 0, 1 pigment { %s } }", words);
    struct pattern pattern = scene->primitives[0].pigment.pattern;
    assert_int_equal(scene->primitives[0].pigment.kind, PIGMENT_PATTERN);
    return pattern;
}

TEST(patterns)
{
    static const struct {
        enum pigment_kind kind;
        const char *words, *map;
    } rows[] = {
        { PIGMENT_GRADIENT, "gradient x", "0:0,0,0 1:1,1,1 " },
        { PIGMENT_GRADIENT, "gradient x color_map { [0 rgb x] [.5 rgb z] }", TWO },
        { PIGMENT_GRADIENT, "gradient x, color_map { [0, rgb x], [.5, color rgb z] }",
          TWO },
        { PIGMENT_GRADIENT, "gradient x colour_map { [0 color red 1] [.5 blue 1] }",
          TWO },
        { PIGMENT_GRADIENT,
          "gradient x color_map { #for (I, 0, 1) [I/2 rgb <1 - I, 0, I>] #end }", TWO },
        /* The oldest form, a decreasing value, and values outside of 0 to 1. */
        { PIGMENT_GRADIENT,
          "gradient z color_map { [0, .5 color rgb x color rgb y]"
          " [.5, 1 color rgb z color rgb 1] }",
          "0:1,0,0 0.5:0,1,0 0.5:0,0,1 1:1,1,1 " },
        { PIGMENT_GRADIENT, "gradient y color_map { [.6 rgb x] [.4 rgb y] [.7 rgb z] }",
          "0.6:1,0,0 0.6:0,1,0 0.7:0,0,1 " },
        { PIGMENT_GRADIENT, "gradient y color_map { [-1 rgb x] [3 rgb y] }",
          "-1:1,0,0 3:0,1,0 " },
        { PIGMENT_GRADIENT, "gradient x frequency 1 ramp_wave", "0:0,0,0 1:1,1,1 " },
        { PIGMENT_GRADIENT, "checker gradient x phase .5", "0:0,0,1 1:0,1,0 " },
        { PIGMENT_GRADIENT, "hexagon rgb x rgb y rgb z gradient x",
          "0:1,0,0 1:0,1,0 2:0,0,1 " },
        { PIGMENT_PATTERN, "planar", "0:0,0,0 1:1,1,1 " },
        { PIGMENT_PATTERN, "spherical color_map { [0 rgb x] [.5 rgb z] }", TWO },
        { PIGMENT_PATTERN, "radial", "0:0,1,1 0.333:1,1,0 0.666:1,0,1 1:0,1,1 " },
        { PIGMENT_PATTERN, "radial color_map { [0 rgb x] [.5 rgb z] }", TWO },
        { PIGMENT_PATTERN, "gradient x sine_wave", "0:0,0,0 1:1,1,1 " },
        { PIGMENT_PATTERN, "gradient x frequency 2", "0:0,0,0 1:1,1,1 " },
        { PIGMENT_PATTERN, "gradient x phase .5", "0:0,0,0 1:1,1,1 " },
    };
    for (size_t i = 0; i < COUNT(rows); i++)
        check_pigment(rows[i].words, rows[i].kind, rows[i].map);
    struct pattern pattern = pattern_of("onion");
    assert_int_equal(pattern.function, PATTERN_ONION);
    assert_int_equal(pattern.wave, WAVE_RAMP);
    assert_close(pattern.frequency, 1, 0);
    pattern = pattern_of("boxed poly_wave 3 frequency 2 phase .25");
    assert_int_equal(pattern.function, PATTERN_BOXED);
    assert_int_equal(pattern.wave, WAVE_POLY);
    assert_close(pattern.exponent, 3, 0);
    assert_close(pattern.frequency, 2, 0);
    assert_close(pattern.phase, .25, 0);
    pattern = pattern_of("brick brick_size <1, 2, 3> mortar .1");
    assert_vector(pattern.own.brick_size, 1, 2, 3);
    assert_close(pattern.own.mortar, .1, 0);
    pattern = pattern_of("gradient y triangle_wave");
    assert_int_equal(pattern.function, PATTERN_GRADIENT);
}

/* Compares the colours of a list. They may have waves. */
static void check_list(const char *words, const char *expected)
{
    char found[512] = "", *to = found;
    SCOPED(scene) *scene = read_format("sphere { 0, 1 pigment { %s } }", words);
    const struct pigment *pigment = &scene->primitives[0].pigment;
    for (size_t i = 0; i < pigment_list_count(pigment); i++) {
        struct color_stop listed = pigment_listed(pigment, i);
        to += sprintf(to, "%g,%g,%g ", listed.color[0], listed.color[1],
                      listed.color[2]);
    }
    assert_string_equal(found, expected);
}

TEST(lists)
{
    check_list("onion", "");
    check_list("brick", "0.5,0.5,0.5 0.6,0.15,0.15 ");
    check_list("brick rgb x, rgb z", "1,0,0 0,0,1 ");
    check_list("brick pigment { rgb x } pigment { rgb z }", "1,0,0 0,0,1 ");
    check_list("hexagon rgb 0 rgb y", "0,0,0 0,1,0 1,0,0 ");
    check_list("checker rgb x", "1,0,0 0,1,0 ");
    check_list("brick rgb x, rgb z triangle_wave", "1,0,0 1,0,0 ");
    check_list("hexagon rgb x rgb y rgb z frequency .5", "1,0,0 0.5,0.5,0 0,1,0 ");
    check_list("brick rgb x, rgb z frequency -.25", "1,0,0 0.25,0,0.75 ");
    check_list("brick rgb x, rgb z frequency .5 sine_wave", "0.5,0,0.5 0.5,0,0.5 ");
    check_list("brick rgb x, rgb z frequency .5 scallop_wave", "1,0,0 0,0,1 ");
    check_list("brick rgb x, rgb z frequency .5 phase .25 cubic_wave",
               "0.84375,0,0.15625 0.15625,0,0.84375 ");
    check_list("brick rgb x, rgb z frequency .5 poly_wave 2", "1,0,0 0.75,0,0.25 ");
    check_list("hexagon rgb 0 rgb y color_map { [.5 rgb x] [2 rgb z] }",
               "1,0,0 0.666667,0,0.333333 0,0,1 ");
}

/* A pattern that replaces another pattern keeps the waves. A pattern that replaces a
 * list has no waves (frequency 0), unless it sets a frequency. */
TEST(waves_stay)
{
    struct pattern pattern = pattern_of(
        "leopard poly_wave 2 frequency 3 phase .5 boxed");
    assert_int_equal(pattern.function, PATTERN_BOXED);
    assert_int_equal(pattern.wave, WAVE_POLY);
    assert_close(pattern.exponent, 2, 0);
    assert_close(pattern.frequency, 3, 0);
    assert_close(pattern.phase, .5, 0);
    pattern = pattern_of("onion frequency 3 gradient x");
    assert_int_equal(pattern.function, PATTERN_GRADIENT);
    assert_close(pattern.frequency, 3, 0);
    pattern = pattern_of("hexagon onion phase .5");
    assert_close(pattern.frequency, 0, 0);
    pattern = pattern_of("checker onion phase .5");
    assert_close(pattern.frequency, 0, 0);
    pattern = pattern_of("brick onion frequency 2");
    assert_close(pattern.frequency, 2, 0);
    pattern = pattern_of("brick mortar .1 brick_size 1 brick");
    assert_close(pattern.own.mortar, .5, 0);
    assert_vector(pattern.own.brick_size, 8, 3, 4.5);
    SCOPED(scene) *scene = read_scene(
        "#declare H = pigment { hexagon rgb x rgb y rgb z frequency .5 }\n"
        "sphere { 0, 1 pigment { H gradient x } }\n"
        "sphere { 0, 1 pigment { checker rgb x rgbt <0, 0, 1, .5>\n"
        "    frequency .5 } }\n");
    check_map(&scene->primitives[0].pigment.map, "0:1,0,0 1:0,1,0 2:0,0,1 ");
    assert_vector(scene->primitives[1].pigment.color[0], 1, 0, 0);
    assert_vector(scene->primitives[1].pigment.color[1], .5, 0, .5);
    assert_close(scene->primitives[1].pigment.transmit[1], .25, 0);
}

TEST(named_maps)
{
    SCOPED(scene) *scene = read_scene(
        "#declare M = color_map { [0 rgb x] [.5 rgb z] }\n"
        "#declare G = pigment { gradient 2*y color_map { M } scale 2 }\n"
        "sphere { 0, 1 pigment { G } }\n"
        "sphere { 0, 1 pigment { G color_map { [0 rgb y] } rotate 90*z } }\n"
        "sphere { 0, 1 pigment { rgb x } }\n"
        "sphere { 0, 1 pigment { G rgb y } }\n");
    const struct primitive *p = scene->primitives;
    check_map(&p[0].pigment.map, TWO);
    assert_vector(p[0].pigment.axis, 0, 1, 0);
    assert_close(p[0].pigment.to_local.rows[1][1], .5, CLOSE);
    assert_vector(p[0].pigment.color[0], 1, 0, 0);
    check_map(&p[1].pigment.map, "0:0,1,0 ");
    assert_vector(p[1].pigment.axis, 0, 1, 0);
    assert_close(p[1].pigment.to_local.rows[1][0], -.5, CLOSE);
    assert_int_equal(p[2].pigment.kind, PIGMENT_COLOR);
    assert_int_equal(p[3].pigment.kind, PIGMENT_COLOR);
}

/* As in POV-Ray, a gradient that replaces a checker maps its colours from 0 to 1. */
TEST(gradients_after_checkers)
{
    static const struct {
        const char *words, *expected;
    } rows[] = {
        { "pigment { checker rgb x, rgb z } pigment { gradient x }",
          "0:1,0,0 1:0,0,1 " },
        { "pigment { checker rgb x } pigment { gradient x }", "0:1,0,0 1:0,1,0 " },
        { "pigment { checker } pigment { gradient x }", "0:0,0,1 1:0,1,0 " },
        { "pigment { checker rgb x } pigment { rgb 1 } pigment { gradient x }",
          "0:1,0,0 1:0,1,0 " },
        { "pigment { checker } pigment { gradient x color_map { [.5 rgb y] } }",
          "0.5:0,1,0 " },
        { "pigment { gradient x color_map { [.5 rgb y] } } pigment { checker } "
          "pigment { gradient y }",
          "0:0,0,1 1:0,1,0 " },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_format("sphere { 0, 1 %s }", rows[i].words);
        check_map(&scene->primitives[0].pigment.map, rows[i].expected);
    }
}

/* For an unsupported pattern, the first colour of its map is used. */
TEST(other_patterns)
{
    SCOPED(scene) *scene = read_with(
        "sphere { 0, 1 pigment { bozo color_map { [.2 rgb x] [1 rgb y] } } }\n"
        "sphere { 0, 1 pigment { gradient x pigment_map { [0 rgb z] } } }\n",
        2);
    const struct primitive *p = scene->primitives;
    assert_int_equal(p[0].pigment.kind, PIGMENT_COLOR);
    assert_vector(p[0].pigment.color[0], 1, 0, 0);
    assert_int_equal(p[1].pigment.kind, PIGMENT_COLOR);
    assert_vector(p[1].pigment.color[0], 0, 0, 1);
}

TEST(clear)
{
    SCOPED(scene) *scene =
        read_with("#declare G = pigment { gradient x color_map { [0 rgbt <1, 0, 0, .5>]"
                  " [1 rgb y] } }\n"
                  "sphere { 0, 1 pigment { G } }"
                  "sky_sphere { pigment { gradient x color_map { [0 rgb x]"
                  " [1 rgbf 1] } } }",
                  1);
    assert_false(pigment_is_clear(&scene->primitives[0].pigment));
    assert_int_equal(scene->sky.kind, PIGMENT_GRADIENT);
}

TEST(skies)
{
    static const char *const turned[] = {
        "sky_sphere { pigment { gradient y scale 2 } rotate x*90 scale 3 }",
        "#declare S = sky_sphere { pigment { gradient y } }"
        " sky_sphere { S scale 2 rotate x*90 scale 3 }",
    };
    static const char *const several[] = {
        "#declare S = sky_sphere { pigment { gradient y } }"
        " sky_sphere { S pigment { gradient x } }",
        "sky_sphere { pigment { gradient y } pigment { gradient x }"
        " pigment { gradient z } }",
    };
    SCOPED(scene) *plain = read_scene(
        "background { rgb z } sky_sphere { pigment { rgb <1, .5, 0> } }");
    SCOPED(scene) *none = read_scene("sky_sphere { }");
    assert_int_not_equal(plain->sky.kind, PIGMENT_GRADIENT);
    assert_vector(plain->background, 1, .5, 0);
    assert_vector(none->background, 0, 0, 0);
    for (size_t i = 0; i < COUNT(turned); i++) {
        SCOPED(scene) *scene = read_scene(turned[i]);
        double up[3] = { 0, 1, 0 };
        transform_point(&scene->sky.to_local, up);
        assert_int_equal(scene->sky.kind, PIGMENT_GRADIENT);
        assert_vector(up, 0, 0, -1.0 / 6);
    }
    for (size_t i = 0; i < COUNT(several); i++) {
        SCOPED(scene) *scene = read_with(several[i], 1);
        assert_vector(scene->sky.axis, 0, 1, 0);
    }
    scene_free(read_with("#declare S = sky_sphere { pigment { bozo } }"
                         " sky_sphere { S scale 2 }",
                         1));
    scene_free(read_with("sky_sphere { pigment { checker } }", 1));
    scene_free(read_with("sky_sphere { pigment { rgbt .5 } emission 2 }", 2));
}

#define MAP "sphere { 0, 1 pigment { gradient x color_map { "

static const struct line_error errors[] = {
    { "sphere { 0, 1 pigment { gradient 0 } }", 25, "finite length above 0" },
    { "sphere { 0, 1 pigment { gradient } }", 34, "expected a number" },
    { MAP "} } }", 48, "expected '['" },
    { MAP "[rgb x] } } }", 49, "expected a number" },
    { MAP "[0] } } }", 50, "expected a colo" },
    { MAP "[0 rgb x } } }", 57, "expected ']'" },
    { MAP "[0 rgb x rgb y] } } }", 57, "expected ']'" },
    { MAP "#for (I, 0, 256) [0 rgb x] #end } } }", 73, "more than 256 entries" },
    { MAP "[0 rgb 1e101] } } }", 60, "out of range" },
    { "sky_sphere { gradient y }", 14, "expected a keyword of sky_sphere" },
    { "sky_sphere { pigment { gradient y } wibble }", 37,
      "expected a keyword of sky_sphere" },
    { "sky_sphere 3", 12, "expected '{'" },
};

TEST_CALL(errors, assert_errors(errors, COUNT(errors)))
