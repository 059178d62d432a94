/* test_text.c - the scene language: characters of fonts, which come with
 * POV-Ray's package. */
#include "rt/scene/font.h"
#include "rt/scene/transform.h"
#include "rt/shapes/primitive.h"
#include "tests/random.h"
#include "tests/unit/scene_reading.h"

#include <stdio.h>

/* Where the ink of a scene's prisms ends, in the world. */
static void extent_of(const struct scene *scene, double low[3],
                      double high[3])
{
    for (int k = 0; k < 3; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
    }
    for (size_t i = 0; i < scene->primitive_count; i++) {
        const struct primitive *primitive = &scene->primitives[i];
        const struct outline *path = &primitive->shape.prism.path;
        assert_int_equal(primitive->kind, PRIMITIVE_PRISM);
        for (size_t j = 0; j < 2 * path->count; j++) {
            double point[3] = { path->points[j / 2][0],
                                j % 2 ? primitive->shape.prism.low
                                      : primitive->shape.prism.high,
                                path->points[j / 2][1] };
            transform_point(&primitive->to_world, point);
            for (int k = 0; k < 3; k++) {
                low[k] = fmin(low[k], point[k]);
                high[k] = fmax(high[k], point[k]);
            }
        }
    }
}

/* Of the curves' edges: FLATNESS; POV-Ray's bounds are some 2e-5 too large. */
#define WITHIN 2e-4

/* POV-Ray's min_extent and max_extent of the same text: bearings, kerning,
 * offsets, blanks, characters that are no ASCII. */
static void test_extents(void **state)
{
    static const struct {
        const char *font, *string, *offset;
        double low[2], high[2];
    } rows[] = {
        { "cyrvetic", "C", "0", { 0, -.02102 }, { .63602, .74901 } },
        { "cyrvetic", "@", "0", { 0, -.15102 }, { .90602, .71602 } },
        { "cyrvetic", "CC", "0", { 0, -.02102 }, { 1.33402, .74902 } },
        { "cyrvetic",
          "CC",
          "<.1, .05, .2>",
          { 0, -.02102 },
          { 1.43402, .79903 } },
        { "cyrvetic", "Crystal @", "0", { 0, -.22302 }, { 4.23602, .74907 } },
        { "timrom", "A", "0", { 0, 0 }, { .73602, .69601 } },
        { "timrom", "AV", "0", { 0, -.01602 }, { 1.27802, .69602 } },
        { "timrom", "AVTo 205&gi", "0", { 0, -.21202 }, { 5.69102, .6961 } },
        { "timrom", "WAVE Tolstoy", "0", { 0, -.21202 }, { 6.00102, .6961 } },
        { "timrom", "\\u00c9\\u00fc", "0", { 0, 0 }, { 1.01202, .61802 } },
        { "crystal", "CDC", "0", { 0, -.00783 }, { 1.4048, .68704 } },
        { "crystal",
          "205, Cyber!",
          "<-.1, .2, 0>",
          { 0, .00096 },
          { 4.51564, 2.68514 } },
        { "povlogo", "P", "0", { 0, .00194 }, { .66994, 1.00196 } },
    };

    (void)state;
    for (size_t i = 0; i < COUNT(rows); i++) {
        struct scene *scene;
        double low[3], high[3];
        char text[200];
        snprintf(text, sizeof text, "text { ttf \"%s.ttf\" \"%s\" 1, %s }",
                 rows[i].font, rows[i].string, rows[i].offset);
        scene = read_scene(text);
        extent_of(scene, low, high);
        for (int k = 0; k < 2; k++) {
            assert_close(low[k], rows[i].low[k], WITHIN);
            assert_close(high[k], rows[i].high[k], WITHIN);
        }
        assert_close(low[2], 0, 0);
        assert_close(high[2], 1, 0);
        scene_free(scene);
    }
}

/* The dot of this font is round: its edges enclose as much as an ellipse. */
static void test_curves(void **state)
{
    struct scene *scene = read_scene(
        "text { ttf \"timrom.ttf\" \".\" 1, 0 }");
    const struct outline *path = &scene->primitives->shape.prism.path;
    double low[3], high[3], area = 0, ellipse;

    (void)state;
    extent_of(scene, low, high);
    ellipse = atan(1) * (high[0] - low[0]) * (high[1] - low[1]);
    for (size_t i = 0; i + 1 < path->count; i++)
        area += (path->points[i][0] * path->points[i + 1][1]
                 - path->points[i + 1][0] * path->points[i][1])
                / 2;
    assert_close(fabs(area) / ellipse, 1, .03);
    scene_free(scene);
}

/* Loops by chance on a small grid, so that they touch themselves: the same loop
 * from another point, which is there once if any is. */
static void test_touching_loops(void **state)
{
    enum { LOOPS = 2000, LONGEST = 12 };
    uint64_t random = RANDOM_SEED;

    (void)state;
    for (int i = 0; i < LOOPS; i++) {
        size_t count = (size_t)xorshift_between(&random, 1, LONGEST), begin;
        double before[LONGEST][2], after[LONGEST][2];
        size_t times[LONGEST] = { 0 };
        for (size_t j = 0; j < count; j++)
            for (int k = 0; k < 2; k++)
                before[j][k] = (double)xorshift_between(&random, 0, 2);
        for (size_t j = 0; j < count; j++)
            for (size_t k = 0; k < count; k++)
                times[j] += !memcmp(before[j], before[k], sizeof *before);
        memcpy(after, before, sizeof after);
        font_turn_loop(after, count);
        for (begin = 0; begin < count && times[begin] > 1; begin++)
            continue;
        if (begin == count)
            begin = 0;
        for (size_t j = 0; j < count; j++)
            assert_memory_equal(after[j], before[(begin + j) % count],
                                sizeof *after);
    }
}

static void test_modifiers(void **state)
{
    struct scene *scene = read_scene(
        "text { ttf concat(\"cyrvetic\", \".ttf\"), \"I I\" -.5, 0"
        " scale 2 translate <1, 2, 3> pigment { rgb x } no_shadow }");
    double low[3], high[3];

    (void)state;
    extent_of(scene, low, high);
    assert_int_equal(scene->primitive_count, 2);
    assert_true(scene->primitives[1].no_shadow);
    assert_vector(scene->primitives[1].pigment.color[0], 1, 0, 0);
    assert_close(low[0], 1, CLOSE);
    assert_close(low[1], 2, CLOSE);
    assert_close(low[2], 2, CLOSE);
    assert_close(high[2], 3, CLOSE);
    scene_free(scene);
}

static void test_blank(void **state)
{
    struct scene *scene = read_with("text { ttf \"timrom.ttf\" \" \" 1, 0 }",
                                    1);

    (void)state;
    assert_int_equal(scene->primitive_count, 0);
    scene_free(scene);
}

static void test_errors(void **state)
{
    static const struct line_error rows[] = {
        { "text { \"a.ttf\" \"a\" 1, 0 }", 8, "expected ttf" },
        { "text { ttf \"no.ttf\" \"a\" 1, 0 }", 12, "no such file" },
        { "text { ttf \"math.inc\" \"a\" 1, 0 }", 1, "it is not a font" },
        { "text { internal 1 \"a\" 1, 0 }", 8, "built in" },
        { "text { ttf \"timrom.ttf\" \"a\" 0, 0 }", 29, "no thickness" },
        { "text { ttf \"timrom.ttf\" 1, 0 }", 25, "expected a string" },
        { "text { ttf \"timrom.ttf\" \"a\" x, 0 }", 29, "expected a number" },
    };

    (void)state;
    assert_errors(rows, COUNT(rows));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_extents),
        cmocka_unit_test(test_curves),
        cmocka_unit_test(test_touching_loops),
        cmocka_unit_test(test_modifiers),
        cmocka_unit_test(test_blank),
        cmocka_unit_test(test_errors),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
