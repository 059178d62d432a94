/* The tracer's two forms: the same frame, bit for bit, on scenes that no one
 * has chosen, and on rays for which the kernels have cases of their own. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "rt/speedup.h"
#include "rt/trace.h"
#include "tests/random.h"

enum { WIDTH = 41, HEIGHT = 31, PIXELS = WIDTH * HEIGHT };

struct words {
    c205_word channel[FRAME_CHANNELS][PIXELS];
};

static c205_model *model;
static uint64_t random_state = RANDOM_SEED;

static struct scene *read_text(const char *text)
{
    static const struct scene_options options = { .strict = true };
    struct reports reports = { 0, 0, NULL };
    struct scene *scene = scene_read_text("test", text, &options, &reports);

    if (scene == NULL)
        reports_print(stderr, &reports);
    assert_non_null(scene);
    reports_free(&reports);
    return scene;
}

static struct words *trace_words(const struct scene *scene,
                                 enum trace_mode mode, size_t queue)
{
    struct trace_options options = { .mode = mode,
                                     .width = WIDTH,
                                     .height = HEIGHT,
                                     .queue = queue,
                                     .model = model };
    c205_error error = { "" };
    struct trace *trace = trace_new(scene, &options, &error);
    struct words *words = malloc(sizeof *words);

    if (trace == NULL || !trace_run(trace, &error))
        fail_msg("%s", error.message);
    assert_non_null(words);
    for (int i = 0; i < FRAME_CHANNELS; i++)
        assert_true(trace_read_words(trace, (enum frame_channel)i,
                                     words->channel[i]));
    trace_free(trace);
    return words;
}

/* The scalar frame, after comparing it with those of several queues. */
static struct words *same_frame(const char *text)
{
    static const size_t queues[] = { 1, 40, 41, 2000 };
    struct scene *scene = read_text(text);
    struct words *scalar = trace_words(scene, TRACE_SCALAR, 1);

    for (size_t i = 0; i < sizeof queues / sizeof *queues; i++) {
        struct words *vector = trace_words(scene, TRACE_VECTOR, queues[i]);

        for (int channel = 0; channel < FRAME_CHANNELS; channel++)
            for (size_t k = 0; k < PIXELS; k++)
                if (scalar->channel[channel][k]
                    != vector->channel[channel][k])
                    fail_msg("queue %zu, channel %d, pixel %zu: %016llX, "
                             "scalar %016llX in\n%s",
                             queues[i], channel, k,
                             (unsigned long long)vector->channel[channel][k],
                             (unsigned long long)scalar->channel[channel][k],
                             text);
        free(vector);
    }
    scene_free(scene);
    return scalar;
}

static size_t hits(const struct words *words)
{
    size_t count = 0;

    for (size_t i = 0; i < PIXELS; i++)
        count += c205_to_integer(words->channel[CHANNEL_ID][i]) != 0;
    return count;
}

#define HEAD \
    "#version 3.7; global_settings { assumed_gamma 1 }\n" \
    "light_source { <4, 9, -7>, rgb .9 shadowless }\n" \
    "light_source { <-9, 2, -5>, rgb <.2, .3, .5> shadowless }\n"

static double between(double low, double high)
{
    return low + (high - low)
                     * (double)(xorshift(&random_state) >> 11) * 0x1p-53;
}

static void add(char *text, size_t size, const char *format, ...)
{
    size_t used = strlen(text);
    va_list list;

    va_start(list, format);
    vsnprintf(text + used, size - used, format, list);
    va_end(list);
}

static void add_point(char *text, size_t size, double reach)
{
    add(text, size, "<%.9f, %.9f, %.9f>", between(-reach, reach),
        between(-reach, reach), between(-reach, reach));
}

static void add_primitive(char *text, size_t size)
{
    switch (xorshift(&random_state) % 5) {
    case 0:
        add(text, size, "sphere { ");
        add_point(text, size, 2);
        add(text, size, ", %.9f ", between(.2, 1));
        break;
    case 1:
        add(text, size, "box { ");
        add_point(text, size, 2);
        add(text, size, ", ");
        add_point(text, size, 2);
        break;
    case 2:
        add(text, size, "plane { ");
        add_point(text, size, 1);
        add(text, size, ", %.9f ", between(-5, -3));
        break;
    default:
        add(text, size, "cylinder { ");
        add_point(text, size, 2);
        add(text, size, ", ");
        add_point(text, size, 2);
        add(text, size, ", %.9f %s", between(.2, .8),
            xorshift(&random_state) % 2 ? "open " : "");
        break;
    }
    add(text, size, "pigment { %s rgb <%.3f, %.3f, %.3f> %s } ",
        xorshift(&random_state) % 2 ? "checker" : "color", between(0, 1),
        between(0, 1), between(0, 1), "");
    add(text, size, "finish { phong %.2f phong_size %.1f specular %.2f "
        "roughness %.3f } ",
        xorshift(&random_state) % 2 ? between(0, 1) : 0, between(1, 200),
        xorshift(&random_state) % 2 ? between(0, 1) : 0, between(.005, .2));
    if (xorshift(&random_state) % 2)
        add(text, size, "scale <%.6f, %.6f, %.6f> rotate <%.3f, %.3f, %.3f>",
            between(.5, 1.5), between(.5, 1.5), between(.5, 1.5),
            between(-90, 90), between(-90, 90), between(-90, 90));
    add(text, size, " }\n");
}

static void test_random_scenes(void **state)
{
    char text[8192];
    size_t found = 0;

    (void)state;
    for (int scene = 0; scene < 12; scene++) {
        strcpy(text, HEAD "camera { location <0, 1, -6> look_at 0 }\n");
        for (int i = 0; i < 6; i++)
            add_primitive(text, sizeof text);
        struct words *words = same_frame(text);
        found += hits(words);
        free(words);
    }
    assert_true(found > 12 * PIXELS / 4);
}

/* The middle column and row of the picture look straight ahead. */
#define AHEAD \
    HEAD "camera { location <0, 0, -5> direction z right x up y }\n"

static void check_middle_within(const char *text, int64_t id, double depth,
                                double tolerance)
{
    struct words *words = same_frame(text);
    size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;

    assert_int_equal(c205_to_integer(words->channel[CHANNEL_ID][middle]),
                     id);
    assert_float_equal(c205_to_double(words->channel[CHANNEL_DEPTH][middle]),
                       depth, tolerance);
    free(words);
}

static void check_middle(const char *text, int64_t id, double depth)
{
    check_middle_within(text, id, depth, 1e-10);
}

static void test_parallel_rays(void **state)
{
    (void)state;
    check_middle(AHEAD "box { -1, 1 }", 1, 4);
    check_middle(AHEAD "box { <1, -1, -1>, <2, 1, 1> }", 0, 0);
    check_middle(AHEAD "cylinder { -z, z, 1 }", 1, 4);
    check_middle(AHEAD "cylinder { -z, z, 1 open } sphere { 0, .5 }", 2, 4.5);
    check_middle(AHEAD "cylinder { <2, 0, -1>, <2, 0, 1>, 1 }", 0, 0);
    check_middle(AHEAD "cylinder { -x, x, 1 }", 1, 4);
    check_middle(AHEAD "cylinder { <-1, 3, 0>, <1, 3, 0>, 1 open }", 0, 0);
    check_middle(AHEAD "plane { y, -1 }", 0, 0);
    check_middle(AHEAD "plane { y, 1 }", 0, 0);
    check_middle(AHEAD "plane { -z, 1 }", 1, 4);
    check_middle(AHEAD "plane { z, 3 }", 1, 8);
    check_middle(AHEAD "sphere { 0, 1 scale <1, 1, 2> }", 1, 3);
}

static void test_from_inside(void **state)
{
    (void)state;
    check_middle(AHEAD "box { -8, 7 }", 1, 12);
    check_middle(AHEAD "sphere { <0, 0, -5>, 2 }", 1, 2);
    check_middle(AHEAD "cylinder { <0, -1, -5>, <0, 1, -5>, 3 }", 1, 3);
    check_middle(AHEAD "sphere { <0, 0, -5>, 1 scale <1, 1, 2> }", 0, 0);
    check_middle(AHEAD "sphere { <0, 0, -9>, 1 }", 0, 0);
}

static void test_open_cylinder_shows_its_inside(void **state)
{
    (void)state;
    check_middle(AHEAD "cylinder { <0, .7, 0>, <0, 3, 0>, 1 open"
                       " rotate -30*x }", 0, 0);
    check_middle(AHEAD "cylinder { -y, y, 1 open }", 1, 4);
    check_middle(AHEAD "cylinder { -y, y, 1 open rotate 45*x translate -y }",
                 1, 5 + 1 - sqrt(2));
}

static void test_nearest_of_equals_is_the_first(void **state)
{
    (void)state;
    check_middle(AHEAD "box { -1, 1 } box { -1, 1 } plane { z, 9 }", 1, 4);
    check_middle(AHEAD "plane { z, 9 } sphere { 0, 1 } box { -1, 1 }", 2, 4);
}

/* Numbers chosen so that nothing is cut off: the middle ray is 0, 0, 1. */
#define STRAIGHT \
    HEAD "camera { location <0, 0, -5> direction 64*z right 41*x up 31*y }\n"
#define GLOSSY "no_shadow finish { phong .5 specular .5 } }"

/* L, then H, has no length. */
static void test_no_way_to_the_light(void **state)
{
    (void)state;
    check_middle(STRAIGHT "light_source { -z, rgb 1 } box { -1, 1 " GLOSSY,
                 1, 4);
    check_middle(STRAIGHT "light_source { <0, 1e-9, 10>, rgb 1 }"
                 "box { -1, <1, 0, 1> " GLOSSY, 1, 4);
    check_middle(STRAIGHT "light_source { <0, 0, -5>, rgb 1 }"
                 "sphere { 0, 1 scale <1, 1, 1e-20> " GLOSSY, 1, 5);
}

static void check_normal_z(const char *text, double expected)
{
    struct words *words = same_frame(text);
    size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;

    assert_float_equal(
        c205_to_double(words->channel[CHANNEL_NORMAL_Z][middle]), expected,
        1e-12);
    free(words);
}

static void test_flat_boxes(void **state)
{
    (void)state;
    check_normal_z(AHEAD "box { <-1, -1, 2>, <1, 1, 2> }", -1);
    check_normal_z(AHEAD "box { <-1, -1, 0>, <1, 1, 0>"
                   " rotate 60*x translate <.1, .3, 9> }", -.5);
    check_normal_z(AHEAD "box { <-1, -1, 1000>, <1, 1, 1000 + 1e-9> }", -1);
}

/* The axis leans by 1e-7: the ray is in the side from z = 5 to 15. */
static void test_ray_almost_along_a_cylinder(void **state)
{
    (void)state;
    check_middle_within(STRAIGHT "cylinder { <-1.1e-5, 0, -100>,"
                        " <9e-6, 0, 100>, 5e-7 open }", 1, 10, 1e-5);
}

static void test_numbers_beyond_doubles(void **state)
{
    static const char *const shapes[] = {
        "sphere { 0, 1e200 }", "sphere { 0, 1e-310 }",
        "cylinder { -1e200*x, x, 1 }", "cylinder { 0, 1e-200*x, 1 }"
    };

    (void)state;
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        char text[1024] = AHEAD;
        struct trace_options options = { .width = 1, .height = 1,
                                         .model = model };
        c205_error error = { "" };

        add(text, sizeof text, "%s", shapes[i]);
        struct scene *scene = read_text(text);
        assert_null(trace_new(scene, &options, &error));
        assert_non_null(strstr(error.message, "line 5"));
        scene_free(scene);
    }
}

static void test_empty_scene(void **state)
{
    (void)state;
    struct words *words = same_frame(AHEAD "background { rgb <.5, .25, 1> }");

    assert_int_equal(hits(words), 0);
    assert_float_equal(c205_to_double(words->channel[CHANNEL_GREEN][7]), .25,
                       0);
    free(words);
}

static void test_speedup_subjects(void **state)
{
    (void)state;
    for (size_t i = 0; i < speedup_subject_count; i++) {
        struct speedup_measure measures[TRACE_MODES];

        for (int mode = 0; mode < TRACE_MODES; mode++) {
            struct trace_options options = { .mode = (enum trace_mode)mode,
                                             .width = 80,
                                             .height = 50,
                                             .queue = TRACE_QUEUE,
                                             .model = model };
            c205_error error = { "" };

            if (!speedup_measure(&speedup_subjects[i], &options,
                                 &measures[mode], &error))
                fail_msg("%s", error.message);
            assert_int_equal(measures[mode].rays, 4000);
            assert_in_range(measures[mode].hits, 1000, 3000);
        }
        assert_true(measures[TRACE_SCALAR].checksum
                    == measures[TRACE_VECTOR].checksum);
        assert_true(measures[TRACE_SCALAR].total
                    > 5 * measures[TRACE_VECTOR].total);
    }
}

static int set_up(void **state)
{
    c205_error error;

    (void)state;
    model = c205_model_find("cyber205-2pipe", &error);
    return model == NULL;
}

static int tear_down(void **state)
{
    (void)state;
    c205_model_free(model);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_scenes),
        cmocka_unit_test(test_parallel_rays),
        cmocka_unit_test(test_from_inside),
        cmocka_unit_test(test_open_cylinder_shows_its_inside),
        cmocka_unit_test(test_nearest_of_equals_is_the_first),
        cmocka_unit_test(test_no_way_to_the_light),
        cmocka_unit_test(test_flat_boxes),
        cmocka_unit_test(test_ray_almost_along_a_cylinder),
        cmocka_unit_test(test_numbers_beyond_doubles),
        cmocka_unit_test(test_empty_scene),
        cmocka_unit_test(test_speedup_subjects),
    };

    return cmocka_run_group_tests(tests, set_up, tear_down);
}
