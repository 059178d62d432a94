/* test_scene.c - the scene language. The fields of scenes are compared with expected
 * values. Values that are marked POV-Ray were printed by POV-Ray 3.7 for the same text.
 * A wrong default, operator, transform or inherited material fails here. */
#include "tests/unit/scene_reading.h"

#include "base/file.h"
#include "tests/oracle/plain_regions.h"

TEST(defaults)
{
    SCOPED(scene) *scene = read_scene("sphere { 0, 1 }");
    const struct primitive *sphere = scene->primitives;
    assert_vector(scene->camera.location, 0, 0, 0);
    assert_vector(scene->camera.direction, 0, 0, 1);
    assert_vector(scene->camera.right, 1.33, 0, 0); /* measured in POV-Ray */
    assert_vector(scene->camera.up, 0, 1, 0);
    assert_vector(scene->background, 0, 0, 0);
    assert_vector(scene->ambient_light, 1, 1, 1);
    assert_true(scene->assumed_gamma == 0);
    assert_int_equal(scene->max_trace_level, 5);
    assert_close(scene->adc_bailout, 1. / 255, 0);
    assert_vector(sphere->finish.ambient, .1, .1, .1);
    assert_close(sphere->finish.diffuse, .6, CLOSE);
    assert_close(sphere->finish.phong, 0, CLOSE);
    assert_close(sphere->finish.phong_size, 40, CLOSE);
    assert_close(sphere->finish.specular, 0, CLOSE);
    assert_close(sphere->finish.roughness, .05, CLOSE);
    assert_close(sphere->finish.brilliance, 1, CLOSE);
    assert_close(sphere->finish.metallic, 0, CLOSE);
    assert_vector(sphere->finish.emission, 0, 0, 0);
    assert_int_equal(sphere->pigment.kind, PIGMENT_COLOR);
    assert_vector(sphere->pigment.color[0], 0, 0, 0);
    assert_false(sphere->transformed);
    assert_false(sphere->no_shadow);
}

TEST(expressions)
{
    static const struct {
        const char *text;
        double value;
    } rows[] = {
        { "1 + 2*3 - 4/2", 5 },
        { "-1 - 1", -2 },
        { "-2*-3", 6 },
        { "--1", 1 },
        { "!0", 1 },
        { "(1 = 1 + 1e-12)", 1 },
        { "(1 != 2)", 1 },
        { "(1 <= 1)", 1 },
        { "(2 > 1 ? 5 : 6)", 5 },
        { "(2 < 1 ? 5 : 6)", 6 },
        { "(1 | 1 & 0)", 0 }, /* POV-Ray: both operators have the same precedence, from
                               * left to right */
        { "(1 & 0 | 1)", 1 },
        { "(3 > 2 = 1)", 1 },
        { "yes + true + on - no", 3 },
        { "mod(-7, 3)", -1 },
        { "div(-7, 2)", -3 },
        { "int(-2.7)", -2 },
        { "strlen(str(int(-.5), 0, 1))", 3 }, /* the text is 0.0 */
        { "strlen(str(div(-1, 2), 0, 1))", 3 },
        { "strlen(str(ceil(-.5), 0, 1))", 4 }, /* the text is -0.0, as in POV-Ray */
        { "ceil(-2.2)", -2 },
        { "floor(-2.2)", -3 },
        { "max(1, 5, 3)", 5 },
        { "min(4, 2, 3)", 2 },
        { "select(0, 1, 2)", 2 },
        { "select(-1, 1, 2)", 1 },
        { "select(0, 1, 2, 3)", 2 },
        { "select(1, 1, 2, 3)", 3 },
        { "log(100)", 2 },
        { "ln(exp(2))", 2 },
        { "pow(2, -3)", .125 },
        { "sqrt(9) + abs(-1)", 4 },
        { "sin(pi/2) + cos(0) + tan(0)", 2 },
        { "degrees(asin(1))", 90 },
        { "degrees(acos(0)) - degrees(atan2(1, 1))", 45 },
        { "radians(180) - pi", 0 },
        { "<1, 2, 3>.z", 3 },
        { "(<1, 2, 3> + x).x", 2 },
        { "(<1, 2> + <1, 1, 1>).z", 1 },
        { "vcross(x, y).z", 1 },
        { "vdot(<1, 2, 3>, <4, 5, 6>)", 32 },
        { "vlength(<3, 4>)", 5 },
        { "vnormalize(<0, 9, 0>).y", 1 },
        { "2*-x.x", -2 },
        { "t.t + u.u + v.v", 3 },
        { "1e3 + .5e1 + 2.", 1007 },
        { "image_width/image_height", 4. / 3 },
        { "F.red", .1 },
        { "F.gray", .1817 },
        { "F.transmit", .5 },
        { "vlength(G)", 0 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene =
            read_format("#declare F = rgbft <.1, .2, .3, .4, .5>; #local G = 0*x;"
                        "plane { y, %s }",
                        rows[i].text);
        assert_close(scene->primitives->shape.plane.distance, rows[i].value, CLOSE);
    }
}

struct vector_row {
    const char *text;
    double vector[3];
};

/* The values come from POV-Ray. Rotations are left-handed. */
TEST(rotations)
{
    static const struct vector_row rows[] = {
        { "vrotate(V, <30, 0, 0>)", { 1.000000, 0.232051, 3.598076 } },
        { "vrotate(V, <0, 30, 0>)", { 2.366025, 2.000000, 2.098076 } },
        { "vrotate(V, <0, 0, 30>)", { -0.133975, 2.232051, 3.000000 } },
        { "vrotate(V, <10, 20, 30>)", { 1.067425, 2.289059, 2.760581 } },
        { "vaxis_rotate(V, <1, 1, 0>, 30)", { 2.127647, 0.872353, 2.951630 } },
        { "vcross(V, <4, 5, 7>)", { -1, 5, -3 } },
        { "2*V/<4, 5, 6>", { .5, .8, 1 } },
        { "V + 1", { 2, 3, 4 } },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_format("#declare V = <1, 2 3>; sphere { %s 1 }",
                                           rows[i].text);
        assert_numbers(rows[i].text, scene->primitives->shape.sphere.center,
                       rows[i].vector, 3, PRINTED);
    }
}

/* The values come from POV-Ray. */
TEST(colors)
{
    static const struct vector_row rows[] = {
        { "rgb <1, 2, 3>*.5", { .5, 1, 1.5 } },
        { "color 2", { 2, 2, 2 } },
        { "<1, 2, 3>", { 1, 2, 3 } },
        { "colour red .5 green .25", { .5, .25, 0 } },
        { "W*.5 red 3", { 3, .5, .5 } },
        { "color rgb W", { 1, 1, 1 } },
        { "W*<.5, .4>", { .5, .4, 0 } },
        { "W + x", { 2, 1, 1 } },
        { "rgbt <1, 2, 3>", { 1, 2, 3 } },
        { "srgb <.5, .2, .1>", { 0.214041, 0.033105, 0.010023 } },
        { "srgb <.04, .02, 0>", { .04 / 12.92, .02 / 12.92, 0 } },
        { "Firebrick", { 0.556863, 0.137255, 0.137255 } },
        { "Gray35", { .35, .35, .35 } },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_format(
            "#include \"colors.inc\"\n#declare W = rgb 1; background { %s }",
            rows[i].text);
        assert_numbers(rows[i].text, scene->background, rows[i].vector, 3, PRINTED);
    }
}

TEST(camera)
{
    static const struct {
        const char *text;
        double vectors[4 * 3]; /* location, direction, right and up */
    } rows[] = {
        { "camera { look_at 0 angle 90 right x*4/3 location <0, 0, -5> }",
          { 0, 0, -5, 0, 0, 2. / 3, 4. / 3, 0, 0, 0, 1, 0 } },
        /* The camera is right-handed, with x up. */
        { "camera { right -2*x sky x up 3*y direction 2*z location 4*z look_at 0 }",
          { 0, 0, 4, 0, 0, -2, 0, -2, 0, 3, 0, 0 } },
        { "#declare C = camera { perspective location -z }"
          "camera { C rotate 90*y translate 5*y scale 2 }",
          { -2, 10, 0, 2, 0, 0, 0, 0, -2.66, 0, 2, 0 } },
    };
    static const char *const reported[] = {
        "camera { look_at y }", /* along the sky */
        "camera { } camera { location x }",
        "camera { aperture 1 blur_samples 257 focal_point y }",
        "camera { aperture 1 blur_samples 4 }",
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_scene(rows[i].text);
        const double *vectors[] = { scene->camera.location, scene->camera.direction,
                                    scene->camera.right, scene->camera.up };
        for (size_t k = 0; k < COUNT(vectors); k++)
            assert_numbers(rows[i].text, vectors[k], rows[i].vectors + 3 * k, 3, CLOSE);
    }
    for (size_t i = 0; i < COUNT(reported); i++)
        scene_free(read_with(reported[i], 1));
}

TEST(fogs)
{
    SCOPED(scene) *scene = read_scene(
        "fog { distance 20 color rgbft <.5, .6, .7, .1, .2> fog_type 1 }"
        "fog { color rgb 1 } fog { rgb <1, 2, 3> distance 1e3 fog_offset 3 }"
        "#declare B = rgb <.5, 1, 2>; fog { B*.5 + B distance 5 }"
        "#declare F = fog { distance 7 rgb x }; fog { F } fog { F distance 8 }");
    assert_int_equal(scene->fog_count, 5);
    assert_close(scene->fogs[0].distance, 20, CLOSE);
    assert_vector(scene->fogs[0].color, .5, .6, .7);
    assert_close(scene->fogs[0].filter, .1, CLOSE);
    assert_close(scene->fogs[0].transmit, .2, CLOSE);
    assert_close(scene->fogs[1].distance, 1000, CLOSE);
    assert_vector(scene->fogs[1].color, 1, 2, 3);
    assert_vector(scene->fogs[2].color, .75, 1.5, 3);
    assert_vector(scene->fogs[3].color, 1, 0, 0);
    assert_close(scene->fogs[3].distance, 7, CLOSE);
    assert_vector(scene->fogs[4].color, 1, 0, 0);
    assert_close(scene->fogs[4].distance, 8, CLOSE);
}

/* The area that an orthographic camera shows, measured in pictures of POV-Ray 3.7. */
TEST(orthographic)
{
    static const struct {
        const char *words;
        double right, up;
    } rows[] = {
        { "location -5*z look_at 0", 1.33 * 5, 5 },
        { "location -5*z look_at 0 direction 2*z", 1.33 * 5 / 2, 5. / 2 },
        { "location -5*z look_at 0 right 4*x up 3*y", 4, 3 },
        { "location -5*z look_at 0 right 4*x", 4, 1 },
        { "location -5*z look_at 0 up 3*y", 1.33, 3 },
        { "location -5*z look_at 0 right 2*x up y angle 90", 10, 5 },
        { "location -5*z angle 90", 12, 12 / 1.33 },
        { "location -5*z", 1.33 * 6, 6 },
        { "location z", 1.33, 1 },
    };
    static const char *const forms[] = {
        "camera { orthographic %s }",
        "#declare C = camera { orthographic %s } camera { C }",
        "#declare C = camera { orthographic %s }\n"
        "#declare D = camera { C } camera { D translate x }",
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        for (size_t form = 0; form < COUNT(forms); form++) {
            SCOPED(scene) *scene = read_format(forms[form], rows[i].words);
            assert_true(scene->camera.orthographic);
            assert_vector(scene->camera.right, rows[i].right, 0, 0);
            assert_vector(scene->camera.up, 0, rows[i].up, 0);
        }
    }
}

TEST(transforms)
{
    static const struct vector_row rows[] = {
        /* images of the point <1, 2, 3> */
        { "translate <1, 0, 2>", { 2, 2, 5 } },
        { "scale <2, 3, -1>", { 2, 6, -3 } },
        { "scale 2", { 2, 4, 6 } },
        { "rotate 90*z", { -2, 1, 3 } },
        { "rotate <90, 90, 0>", { 2, -3, -1 } },
        { "translate x rotate 90*y", { 3, 2, -2 } },
        { "rotate 90*y translate x", { 4, 2, -1 } },
        { "matrix <1,0,0, 0,1,0, 0,0,1, 5,6,7>", { 6, 8, 10 } },
        { "matrix <1,2,3, 0,1,0, 0,0,1, 0,0,0>", { 1, 4, 6 } },
        { "transform T", { 2, 4, 2 } },
        { "transform { T scale 2 }", { 4, 8, 4 } },
        { "transform { T inverse }", { 0, 1, 4 } },
        { "transform { translate x scale 2 }", { 4, 4, 6 } },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        const double point[3] = { 1, 2, 3 };
        double image[3], back[3];
        SCOPED(scene) *scene = read_format(
            "#declare T = transform { translate <1, 0, -1> scale <1, 2, 1> }"
            "sphere { 0, 1 %s }",
            rows[i].text);
        to_other_space(&scene->primitives->to_world, point, image);
        to_other_space(&scene->primitives->to_local, image, back);
        assert_numbers(rows[i].text, image, rows[i].vector, 3, CLOSE);
        assert_numbers(rows[i].text, back, point, 3, CLOSE);
        assert_true(scene->primitives->transformed);
    }
}

TEST(no_transform)
{
    SCOPED(scene) *scene =
        read_with("sphere { 0, 1 translate x translate -x } sphere { 0, 1 scale 0 }",
                  3);
    assert_false(scene->primitives[0].transformed);
    assert_false(scene->primitives[1].transformed); /* the scale 0 became 1 */
}

/* Fails unless the pattern's x coordinate at a world point is as expected. */
static void assert_pattern_at(const struct pigment *pigment, double world_x,
                              double pattern_x)
{
    const double world[3] = { world_x, 0, 0 };
    double local[3];
    to_other_space(&pigment->to_local, world, local);
    assert_close(local[0], pattern_x, CLOSE);
}

TEST(textures_move)
{
    SCOPED(scene) *scene = read_scene(
        "#declare P = pigment { checker rgb 1 rgb 0 scale 2 }\n"
        "sphere { 0, 1 pigment { P translate x } scale 3 translate 4*x }\n"
        "sphere { 0, 1 scale 3 translate 4*x pigment { P translate x } }\n"
        "sphere { 0, 1 texture { pigment { P } translate x } scale 3 }\n"
        "sphere { 0, 1 scale 3 pigment { checker } }\n");
    const struct primitive *p = scene->primitives;
    assert_pattern_at(&p[0].pigment, 4 + 3 * (1 + 2), 1);
    assert_pattern_at(&p[1].pigment, 1 + 2, 1);
    assert_pattern_at(&p[2].pigment, 3 * (1 + 2), 1);
    assert_pattern_at(&p[3].pigment, 1, 1);
    assert_int_equal(p[3].pigment.kind, PIGMENT_CHECKER);
    assert_vector(p[0].pigment.color[0], 1, 1, 1);
    assert_vector(p[3].pigment.color[0], 0, 0, 1); /* default of POV-Ray */
    assert_vector(p[3].pigment.color[1], 0, 1, 0);
}

TEST(unions)
{
    SCOPED(scene) *scene = read_scene(
        "#default { finish { ambient 0 } }\n"
        "#declare U = union {\n"
        "    sphere { 0, 1 pigment { checker } translate x }\n"
        "    union { sphere { 0, 2 translate y } sphere { 0, 3 }\n"
        "            scale 2 no_shadow }\n"
        "    light_source { x, rgb 1 shadowless }\n"
        "    rotate 90*z\n"
        "}\n"
        "object { U pigment { rgb <1, 0, 0> } finish { phong .5 } }\n"
        "object { U translate 9*z }\n");
    const struct primitive *p = scene->primitives;
    const double origin[3] = { 0, 0, 0 };
    double image[3];
    assert_int_equal(scene->primitive_count, 6);
    assert_int_equal(scene->light_count, 2);
    assert_vector(scene->lights[0].position, 0, 1, 0);
    assert_vector(scene->lights[1].position, 0, 1, 9);
    assert_true(scene->lights[0].shadowless);
    to_other_space(&p[1].to_world, origin, image);
    assert_vector(image, -2, 0, 0);
    to_other_space(&p[4].to_world, origin, image);
    assert_vector(image, -2, 0, 9);
    assert_int_equal(p[0].pigment.kind, PIGMENT_CHECKER);
    assert_vector(p[1].pigment.color[0], 1, 0, 0);
    assert_vector(p[2].pigment.color[0], 1, 0, 0);
    assert_vector(p[4].pigment.color[0], 0, 0, 0); /* the default */
    assert_close(p[0].finish.phong, 0, 0);
    assert_close(p[1].finish.phong, .5, 0);
    assert_vector(p[1].finish.ambient, 0, 0, 0);
    assert_false(p[0].no_shadow);
    assert_true(p[1].no_shadow && p[2].no_shadow && p[4].no_shadow);
}

/* The last kind of a light is used. Its target moves with it. */
TEST(beams)
{
    static const struct {
        const char *text;
        /* Position, point_at, kind, radius, falloff, tightness, fade distance and fade
         * power, then whether it is parallel and shadowless. */
        double numbers[14];
    } rows[] = {
        { "#declare L = light_source { <0, 4, 0>, 1 spotlight point_at x radius 10"
          " falloff 20 tightness 3 }"
          " light_source { L scale 2 rotate 90*z translate <0, 0, 1> }",
          { -8, 0, 1, 0, 2, 1, BEAM_CONE, 10, 20, 3, 0, 0, false, false } },
        { "light_source { 2*y, 1 cylinder fade_distance 3 fade_power 2 }",
          { 0, 2, 0, 0, 0, 1, BEAM_CYLINDER, .75, 1, 0, 3, 2, true, false } },
        { "light_source { 2*y, 1 shadowless spotlight falloff 50 }",
          { 0, 2, 0, 0, 0, 1, BEAM_CONE, 30, 50, 0, 0, 0, false, false } },
        { "light_source { 2*y, 1 cylinder radius 2 shadowless }",
          { 0, 2, 0, 0, 0, 1, BEAM_NONE, 2, 1, 0, 0, 0, true, true } },
        { "light_source { 2*y, 1 parallel }",
          { 0, 2, 0, 0, 0, 1, BEAM_NONE, 0, 0, 0, 0, 0, true, false } },
        { "light_source { 2*y, 1 fade_distance 3 }",
          { 0, 2, 0, 0, 0, 1, BEAM_NONE, 0, 0, 0, 3, 0, false, false } },
        { "light_source { 2*y, 1 cylinder tightness 4 spotlight }",
          { 0, 2, 0, 0, 0, 1, BEAM_CONE, 30, 45, 0, 0, 0, true, false } },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_scene(rows[i].text);
        const struct light *l = scene->lights;
        const double rest[] = { l->beam,      l->radius,        l->falloff,
                                l->tightness, l->fade_distance, l->fade_power,
                                l->parallel,  l->shadowless };
        assert_int_equal(scene->light_count, 1);
        assert_numbers(rows[i].text, l->position, rows[i].numbers, 3, CLOSE);
        assert_numbers(rows[i].text, l->point_at, rows[i].numbers + 3, 3, CLOSE);
        assert_numbers(rows[i].text, rest, rows[i].numbers + 6, COUNT(rest), 0);
    }
}

TEST(areas)
{
    SCOPED(scene) *scene = read_scene(
        "#declare L = light_source { 0, 1 area_light x, 2*y 3, 2.9 }\n"
        "light_source { L scale 2 rotate 90*z translate <0, 0, 1> }\n"
        "light_source { y, 1 circular area_light z, y, 32768, 2 adaptive 2 }\n"
        "light_source { y, 1 spotlight }\n");
    const struct light *lights = scene->lights;
    assert_vector(lights[0].position, 0, 0, 1);
    assert_vector(lights[0].area_axes[0], 0, 2, 0);
    assert_vector(lights[0].area_axes[1], -4, 0, 0);
    assert_int_equal(lights[0].area_size[0], 3);
    assert_int_equal(lights[0].area_size[1], 2);
    assert_false(lights[0].circular);
    assert_int_equal(lights[1].area_size[0], MAX_AREA_POINTS / 2);
    assert_true(lights[1].circular);
    assert_int_equal(lights[2].area_size[0], 0);
}

TEST(declarations)
{
    SCOPED(scene) *scene = read_scene(
        "#version 3.7;\n"
        "#declare R = 1; #declare R = R + 1;\n"
        "#declare F = finish { phong .25 phong_size 10 }\n"
        "#declare P = pigment { rgb <0, 1, 0> }\n"
        "#declare T = texture { pigment { P } finish { F diffuse .3 } };\n"
        "#declare S = T #local S2 = S;\n"
        "#declare O = sphere { 0, R texture { S2 } }\n"
        "#undef P #undef T\n"
        "#declare O2 = object { O }\n"
        "object { O2 finish { F ambient rgb <1, 2, 3> } }\n"
        "sphere { 0, 1 material { texture { S } } }\n"
        "light_source { <1, 2, 3>, 2 shadowless translate x }\n");
    const struct primitive *p = scene->primitives;
    assert_close(p[0].shape.sphere.radius, 2, 0);
    assert_vector(p[0].pigment.color[0], 0, 1, 0);
    assert_close(p[0].finish.phong_size, 10, 0);
    assert_vector(p[0].finish.ambient, 1, 2, 3);
    assert_close(p[0].finish.diffuse, .6, CLOSE); /* F replaces the whole finish */
    assert_close(p[1].finish.diffuse, .3, 0);
    assert_vector(scene->lights[0].position, 2, 2, 3);
    assert_vector(scene->lights[0].color, 2, 2, 2);
}

TEST(settings)
{
    SCOPED(scene) *scene = read_scene(
        "global_settings { assumed_gamma 1 ambient_light rgb <.5, 1, 2>"
        " max_trace_level 7 adc_bailout 1/100 }");
    SCOPED(scene) *curved = read_with("global_settings { assumed_gamma srgb }", 1);
    assert_close(curved->assumed_gamma, 2.2, 0);
    assert_close(scene->assumed_gamma, 1, 0);
    assert_vector(scene->ambient_light, .5, 1, 2);
    assert_int_equal(scene->max_trace_level, 7);
    assert_close(scene->adc_bailout, .01, CLOSE);
}

/* The smallest and the largest level, and values outside of this range. */
TEST(trace_levels)
{
    static const int levels[] = { 1, 256 };
    for (size_t i = 0; i < COUNT(levels); i++) {
        SCOPED(scene) *scene = read_format("global_settings { max_trace_level %d }",
                                           levels[i]);
        assert_int_equal(scene->max_trace_level, levels[i]);
    }
    assert_refused("global_settings { max_trace_level 0 }", 1, "between 1 and 256");
    assert_refused("global_settings { max_trace_level 257 }", 1, "between 1 and 256");
}

/* As in POV-Ray 3.7, the version at the end of the text is used. */
TEST(gamma_of_versions)
{
    static const struct {
        const char *text;
        bool off;
    } rows[] = {
        { "", true },
        { "#version 3.1;", true },
        { "#version 3.6;", true },
        { "#version 3.6; global_settings { max_trace_level 5 }", true },
        { "#version 3.7;", false },
        { "global_settings { assumed_gamma 1 }", false },
        { "#version 3.6; global_settings { assumed_gamma 2.2 }", false },
        { "#version 3.7; #version 3.6;", true },
        { "#version 3.6; #version 3.7;", false },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(diagnostics) reports = { 0 };
        SCOPED(scene) *scene = NON_NULL(
            scene_read_text("test.pov", rows[i].text, &reading_options, &reports));
        size_t reported = 0;
        for (size_t k = 0; k < reports.count; k++)
            reported += strstr(reports.items[k].message, "gamma correction") != NULL;
        assert_int_equal(scene->gamma_off, rows[i].off);
        assert_int_equal(reported, rows[i].off);
    }
}

TEST(our_scenes)
{
    static const char *const paths[] = { "scenes/first.pov",       "scenes/bearing.pov",
                                         "scenes/pipe_flange.pov", "scenes/rings.pov",
                                         "scenes/hills.pov",       "scenes/roman.pov",
                                         "scenes/steiner.pov",     "scenes/car.pov",
                                         "scenes/flake.pov" };
    for (size_t i = 0; i < COUNT(paths); i++) {
        SCOPED_VALUE(diagnostics) reports = { 0 };
        SCOPED(scene) *scene = scene_read(paths[i], &strict_options, &reports);
        diagnostics_print(&reports, stderr);
        assert_non_null(scene);
        assert_int_equal(scene->light_count, 2);
    }
}

/* Reads every example of a page as a scene. Returns their number. */
static size_t read_examples(const char *page)
{
    static const char open[] = "\n```pov\n", close[] = "\n```\n";
    size_t length, count = 0;
    FREED char *text = NON_NULL(file_read(page, FILE_LARGEST, &length, &failure));
    char *end = text, *start = strstr(text, open);
    for (; start; start = strstr(end, open), count++) {
        start += strlen(open);
        end = NON_NULL(strstr(start, close));
        *end++ = '\0';
        scene_free(read_scene(start));
    }
    return count;
}

TEST(manual)
{
    static const struct {
        const char *page;
        size_t examples; /* least number of examples */
    } rows[] = {
        { "docs/scenes.md", 8 },
        { "docs/objects.md", 9 },
        { "docs/textures.md", 3 },
        { "docs/lighting.md", 4 },
    };
    for (size_t i = 0; i < COUNT(rows); i++)
        assert_true(read_examples(rows[i].page) >= rows[i].examples);
}
