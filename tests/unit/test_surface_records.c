/* test_surface_records.c - the finishes, bodies and levels in a machine's memory are
 * compared with the words of the scene. A wrong field, weight or index fails here. */
#include "tests/unit/scene_fixture.h"

#include "rt/layout/pigment.h"

TEST(surfaces)
{
    static const char text[] =
        "sphere { 0, 1 pigment { rgbft <.8, .4, .2, .5, .1> }\n"
        "  finish { reflection <.1, .3, .2> } interior { ior 1.6 } }\n"
        "sphere { 0, 1 pigment { checker rgb <1, .5, 0>, rgbt <0, 1, 1, .25> } }\n"
        "sphere { 0, 1 pigment { rgb .5 } }";
    static const double passing[8] = { .5, .3, .2, .5, 0, 0, 0, -1 };
    static const double checker[8] = { 0, 0, 0, -1, .25, .25, .25, .25 };
    static const double colors[6] = { 1, .5, 0, 0, .75, .75 };
    static const double reflection[4] = { .1, .3, .2, .3 };
    static const double index[2] = { 1.6, .625 };
    SCOPED_VALUE(stage) stage = stage_of(text, BOUNDING_FLAT);
    check_numbers(&stage, 0, "P_TRANSMITTED", passing, 8);
    check_numbers(&stage, 0, "P_REFLECTION", reflection, 4);
    check_numbers(&stage, 0, "P_INDEX", index, 2);
    check_numbers(&stage, 1, "P_TRANSMITTED", checker, 8);
    check_numbers(&stage, 1, "P_COLOR", colors, 6);
    check_numbers(&stage, 2, "P_COLOR", (const double[]){ .5, .5, .5 }, 3);
    for (size_t i = 0; i < 3; i++) {
        assert_integer(primitive(&stage, i, "P_MIRROR"), i == 0);
        assert_integer(primitive(&stage, i, "P_CLEAR"), i < 2);
    }
}

/* The ambient term includes the ambient light. 1 / roughness is stored. */
TEST(finish)
{
    static const char text[] =
        "global_settings { ambient_light rgb <.5, 1, 2> }\n"
        "sphere { 0, 1 finish { ambient .5 diffuse .25 phong .5\n"
        "  phong_size 10 specular .75 roughness .125 } }";
    static const double finish[8] = { .25, .5, 1, .25, .5, 10, .75, 8 };
    SCOPED_VALUE(stage) stage = stage_of(text, BOUNDING_FLAT);
    check_numbers(&stage, 0, "P_FINISH", finish, 8);
}

/* These finishes depend on the angle. The opacity of a metal is part of its finish. */
TEST(gloss)
{
    static const char text[] =
        "sphere { 0, 1 pigment { rgbf <.8, .4, .2, .5> }\n"
        "  finish { ambient .5 emission .25 diffuse .5 phong .5 metallic .75\n"
        "    brilliance 2 reflection { .25, rgb <.5, .25, 1> falloff 3 } } }\n"
        "sphere { 0, 1 pigment { rgb .5 } finish { reflection { 1 fresnel } }\n"
        "  interior { ior 2 } }\n"
        "sphere { 0, 1 pigment { checker rgbt <1, 1, 1, .5> rgb 1 }\n"
        "  finish { reflection { .5 metallic } } }\n"
        "sphere { 0, 1 pigment { rgb .5 } finish { reflection .5 } }";
    static const double gloss[][7] = {
        { 2, .75, .25, 0, .75, 3, 0 },
        { 1, 0, 1, 1, 1, 1, 0 },
        { 1, 0, 0, 0, 0, 1, 1 },
        { 1, 0, 0, 0, 0, 1, 0 },
    };
    static const int kinds[] = { 1, 2, 1, 0 };
    static const double checker[] = { .5, .5, .5, 1, 1, 1 };
    static const double reflection[] = { .25, .25, .25, 1 };
    SCOPED_VALUE(stage) stage = stage_of(text, BOUNDING_FLAT);
    for (size_t i = 0; i < COUNT(gloss); i++) {
        check_numbers(&stage, i, "P_GLOSS", gloss[i], 7);
        assert_integer(primitive(&stage, i, "P_REFLECTION_KIND"), kinds[i]);
    }
    check_numbers(&stage, 0, "P_COLOR", (const double[]){ .8, .4, .2 }, 3);
    check_numbers(&stage, 0, "P_FINISH", (const double[]){ .375, .375, .375, .25 }, 4);
    check_numbers(&stage, 0, "P_REFLECTION", reflection, 4);
    check_numbers(&stage, 2, "P_COLOR", checker, 6);
}

/* As in POV-Ray, opacity is not clamped to 0 .. 1, a colour is weighted by its
 * brightness, and light that is too dim in total is not traced. */
TEST(odd_surfaces)
{
    static const char text[] =
        "sphere { 0, 1 pigment { rgbft <.5, 1, 0, .75, .75> } }\n"
        "sphere { 0, 1 pigment { rgbt <.5, 1, 0, -.5> }\n"
        "  finish { reflection <.25, -.5, 0> } }\n"
        "sphere { 0, 1 pigment { rgbf <0, 0, .25, .125> } }\n"
        "sphere { 0, 1 pigment { rgbf <0, 0, 1, .125> } }\n"
        "sphere { 0, 1 pigment { rgbft <-1, 1, 0, 1, 0> } }";
    static const double numbers[][4] = {
        { 1.125, 1.5, .75, 1.5 }, { -.5, -.5, -.5, -1 }, { 0, 0, .03125, -1 },
        { 0, 0, .125, .125 },     { -1, 1, 0, 1 },
    };
    SCOPED_VALUE(stage) stage = stage_of(text, BOUNDING_FLAT);
    check_numbers(&stage, 0, "P_COLOR", (const double[]){ -.25, -.5, 0 }, 3);
    check_numbers(&stage, 1, "P_COLOR", (const double[]){ .75, 1.5, 0 }, 3);
    check_numbers(&stage, 1, "P_REFLECTION", (const double[]){ .25, -.5, 0, .5 }, 4);
    for (size_t i = 0; i < COUNT(numbers); i++)
        check_numbers(&stage, i, "P_TRANSMITTED", numbers[i], 4);
}

/* Two lists share their steps only if they also have the same waves. */
TEST(stops)
{
    static const char text[] =
        "#declare B = pigment { brick rgb x rgb y }\n"
        "#declare O = pigment { onion color_map { [0 rgb x] } }\n"
        "sphere { 0, 1 pigment { B } } sphere { 0, 1 pigment { B scale 2 } }\n"
        "sphere { 0, 1 pigment { B triangle_wave } }\n"
        "sphere { 0, 1 pigment { B frequency .5 } }\n"
        "sphere { 0, 1 pigment { B onion } } sphere { 0, 1 pigment { O } }\n"
        "sphere { 0, 1 pigment { O triangle_wave frequency 2 } }";
    static const bool same[] = { true, false, false, false, false, true };
    SCOPED(scene) *scene = read_scene(text);
    const struct primitive *p = scene->primitives;
    for (size_t i = 0; i < COUNT(same); i++)
        assert_int_equal(has_stops_of(&p[i + 1].pigment, &p[i].pigment), same[i]);
    assert_int_equal(stop_count(&p[0].pigment), 4);
    assert_int_equal(stop_count(&p[4].pigment), 2);
    assert_int_equal(stop_count(&p[5].pigment), 1);
}

static void check_interiors(const char *text, size_t bodies, double base, double full)
{
    SCOPED_VALUE(stage) stage = stage_of(text, BOUNDING_FLAT);
    uint64_t first = symbol(&stage, "scene_interiors");
    c205_word table = stage_word(&stage, first);
    assert_number(stage_word(&stage, table), 1);
    for (size_t i = 1; i <= bodies; i++)
        assert_number(stage_word(&stage, table + 64 * i), 1 + (double)i / 64);
    assert_number(stage_word(&stage, first + 64), base);
    assert_number(stage_word(&stage, first + 2 * 64), 1 / base);
    assert_number(stage_word(&stage, first + 3 * 64), full);
    assert_number(stage_word(&stage, first + 4 * 64), full > 0 ? 1 / full : 0);
    assert_number(stage_word(&stage, first + 5 * 64), 9);
}

/* The interiors that can contain rays, in order, up to a limited number. */
TEST(interiors)
{
    static const char few[] =
        "global_settings { max_trace_level 9 }\n"
        "#default { pigment { rgbt .5 } }\n"
        "sphere { 0, 1 interior { ior 1 + 1/64 } }\n"
        "sphere { 0, 1 pigment { rgb 1 } interior { ior 3 } }\n"
        "sphere { 0, 1 pigment { rgb 1 } interior { ior 1 + 2/64 }\n"
        "    finish { reflection { 1 fresnel } } }\n"
        "union { sphere { 0, 1 } sphere { 0, 2 } interior { ior 1 + 3/64 } }";
    static const int numbers[] = { 1, 0, 2, 3, 3 };
    static const char many[] = "global_settings { max_trace_level 9 }\n"
                               "#for (I, 1, %d) sphere { 0, 1 pigment { rgbt .5 }\n"
                               "    interior { ior 1 + I/64 } } #end";
    static const struct {
        int bodies;
        double base, full;
    } rows[] = {
        { 11, 16, 0 }, { 12, 16, 0x1p40 }, { 16, 32, 0x1p40 }, { 31, 32, 0x1p40 }
    };
    SCOPED_VALUE(stage) stage = stage_of(few, BOUNDING_FLAT);
    for (size_t i = 0; i < COUNT(numbers); i++)
        assert_number(primitive(&stage, i, "P_INTERIOR"), numbers[i]);
    check_interiors(few, 3, 4, 0);
    for (size_t i = 0; i < COUNT(rows); i++) {
        const char *text = formatted(many, rows[i].bodies);
        check_interiors(text, (size_t)rows[i].bodies, rows[i].base, rows[i].full);
    }
}

TEST(levels)
{
    static const struct {
        const char *text;
        int levels;
    } rows[] = {
        { "sphere { 0, 1 }", 1 },
        { "sphere { 0, 1 finish { reflection rgb <0, 0, .1> } }", 7 },
        { "sphere { 0, 1 } sphere { 0, 1 pigment { rgbt <0, 0, 0, .1> } }", 7 + 64 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        char text[200];
        c205_word word;
        snprintf(text, sizeof text,
                 "global_settings { max_trace_level 7 adc_bailout .125 } %s",
                 rows[i].text);
        SCOPED_VALUE(stage) stage = stage_of(text, BOUNDING_FLAT);
        assert_integer(scene_word(&stage, "scene_level_count"), rows[i].levels);
        assert_number(scene_word(&stage, "scene_bailout"), .125);
        assert_true(c205_read(stage.machine,
                              scene_word(&stage, "scene_levels")
                                  + 64 * 10 * (uint64_t)rows[i].levels - 64,
                              &word, 1));
    }
}
