/* test_region_hierarchy.c - many regions under a hierarchy. The frames of all stages
 * and queues are compared with a frame in the order of the scene, over random scenes. A
 * node that is skipped, or a tie that another region wins, fails here.
 *
 *     test_region_hierarchy [SCENES [SEED]]
 */
#define SMALL_FRAMES
#include "tests/unit/random_solids.h"

enum { TEXT_ROOM = 60000 };
static size_t scene_count = 6; /* number of scenes of each kind */

/* Translates to a random position, or to a grid point where objects coincide. */
static void add_place(char *text, size_t size)
{
    if (solids.gridded)
        add_text(text, size, "translate <%zu, %zu, %zu> - 2 ", below(5), below(5),
                 below(5));
    else
        add_random(text, size, "translate <^4-2:2^, ^4-2:2^, ^4-2:2^> ");
}

/* Begins a shape. Half of the kinds are balls. */
static void add_shape(char *text, size_t size, size_t kind)
{
    switch (kind) {
    case 3:
        add_text(text, size, "box { -%.3f, .5 ", solids.gridded ? .5 : between(.1, .4));
        break;
    case 4:
        add_random(text, size,
                   "$2[merge|difference] { sphere { 0, .5 } box { $2[-.25|0], 1 } "
                   "bounded_by { sphere { 0, 3 } } ");
        break;
    case 5: add_random(text, size, "cylinder { -.5*x, .5*x, .2 $2[|open] "); break;
    default:
        add_text(text, size, "sphere { 0, %.3f ",
                 solids.gridded ? .5 : between(.05, .4));
    }
}

/* Adds words that hide the object from some rays. */
static void add_hidden(char *text, size_t size, size_t rarity)
{
    static const char *const words[] = { "no_shadow", "no_image", "no_reflection" };
    for (size_t i = 0; i < COUNT(words); i++)
        if (below(rarity) == 0)
            add_text(text, size, "%s ", words[i]);
}

/* Adds an object, or several objects with different colours at the same position. */
static void add_thing(char *text, size_t size)
{
    size_t kind = below(6), copies = below(5) ? 1 : 2 + below(2);
    uint64_t state = traced.random;
    for (size_t i = 0; i < copies; i++) {
        traced.random = state;
        add_shape(text, size, kind);
        add_place(text, size);
        uint64_t later = traced.random;
        for (size_t k = 0; k <= i; k++)
            xorshift(&later);
        traced.random = later;
        add_look(text, size);
        add_hidden(text, size, 8);
        add_text(text, size, "}\n");
    }
}

/* Adds small spheres in a few colours. Some occur twice at the same position. */
static void add_spheres(char *text)
{
    double size = between(.05, .2);
    size_t copy = 1 + below(9);
    for (size_t i = 50 + below(250); i > 0; i--) {
        uint64_t state = traced.random;
        for (size_t k = below(copy) == 0 ? 2 : 1; k > 0; k--) {
            uint64_t before = traced.random;
            traced.random = state;
            add_text(text, TEXT_ROOM, "sphere { 0, %.3f ",
                     solids.gridded ? .25 : size * between(.5, 2));
            add_place(text, TEXT_ROOM);
            traced.random = k == 2 ? traced.random : before ^ traced.random;
            add_text(text, TEXT_ROOM, "pigment { %s rgb .%zu } finish { phong %zu } ",
                     below(12) ? "color" : "checker", 1 + below(4), below(2));
            add_hidden(text, TEXT_ROOM, 200);
            add_text(text, TEXT_ROOM, "}\n");
        }
    }
}

static void write_scene(char *text, bool spheres)
{
    text[0] = '\0';
    add_random(text, TEXT_ROOM,
               "#version 3.7; global_settings { assumed_gamma 1 "
               "max_trace_level 4 }\nbackground { rgb <.2, .3, .5> }\n"
               "light_source { <^1-7:7^, 8, -7>, .7 }\n"
               "light_source { <^1-2:7^, 3, ^2-2:6^>, rgb <.3, .2, .4> }\n"
               "camera { location <^3-2:2^, ^3-2:2^, ^3-6:-1^> look_at 0 angle 60 }\n");
    if (below(2))
        add_text(text, TEXT_ROOM, "plane { y, -2.5 pigment { color rgb .8 } }\n");
    if (spheres)
        add_spheres(text);
    else
        for (size_t i = 2 + below(90); i > 0; i--)
            add_thing(text, TEXT_ROOM);
}

/* ---- Comparisons -------------------------------------------------------- */

static void check(const struct scene *scene, const char *text,
                  const struct words *expected, enum trace_mode mode, size_t queue,
                  const char *what)
{
    FREED struct words *found = trace_words(scene, mode, queue);
    for (int channel = 0; channel < FRAME_CHANNELS; channel++)
        for (size_t k = 0; k < PIXELS; k++)
            FAIL_IF(found->channel[channel][k] != expected->channel[channel][k],
                    "%s, queue %zu: channel %d, pixel %zu: another frame in\n%s", what,
                    queue, channel, k, text);
}

static void check_ways(const char *text)
{
    SCOPED(scene) *scene = read_text(text);
    static const size_t queues[] = { 1, 7, 77, 2000, 65535 };
    traced.no_bounds = true;
    FREED struct words *expected = trace_words(scene, TRACE_VECTOR, 2000);
    traced.no_bounds = false;
    for (size_t i = 0; i < COUNT(queues); i++)
        check(scene, text, expected, TRACE_VECTOR, queues[i], "vector");
    check(scene, text, expected, TRACE_KERNELS, 77, "kernels");
    check(scene, text, expected, TRACE_SCALAR, 1, "scalar");
    traced.visible = VISIBLE_EVERY;
    check(scene, text, expected, TRACE_VECTOR, 2000, "every crossing");
    traced.visible = VISIBLE_STEPPING;
    traced.flat = true;
    check(scene, text, expected, TRACE_VECTOR, 2000, "flat");
    check(scene, text, expected, TRACE_KERNELS, 2000, "flat kernels");
    traced.flat = false;
}

static void check_scenes(bool gridded, bool clear, bool spheres)
{
    FREED char *text = NON_NULL(malloc(TEXT_ROOM));
    solids.gridded = gridded;
    solids.clear = clear;
    for (size_t i = 0; i < scene_count; i++) {
        write_scene(text, spheres);
        check_ways(text);
    }
}

TEST_CALL(clouds, check_scenes(false, false, false))
TEST_CALL(clear_clouds, check_scenes(false, true, false))
TEST_CALL(grids, check_scenes(true, false, false))
TEST_CALL(clear_grids, check_scenes(true, true, false))
TEST_CALL(spheres, check_scenes(false, false, true))
TEST_CALL(grids_of_spheres, check_scenes(true, false, true))

/* Light passes down through many panes and balls with different colours. The product of
 * the colours must be that of the scene's order for any order of the hits. */
static void write_window(char *text)
{
    text[0] = '\0';
    add_random(text, TEXT_ROOM,
               "#version 3.7; global_settings { assumed_gamma 1 "
               "max_trace_level 2 }\nlight_source { <^2-2:2^, 9, ^2-2:2^>, 1 }\n"
               "camera { location <0, .5, -6> look_at -y angle 60 }\n"
               "plane { y, -2 pigment { color rgb .9 } }\n");
    for (size_t i = 20 + below(60); i > 0; i--)
        add_random(text, TEXT_ROOM,
                   "$2[box { <-1, -.1, -1>, 1|sphere { 0, 1] scale ^3.2:.6^ "
                   "translate <^3-2:2^, ^31:6^, ^3-2:2^> "
                   "pigment { rgbf <^3.7:1^, ^3.7:1^, ^3.7:1^, .9> } }\n");
}

TEST(windows)
{
    enum { WINDOWS = 6 };
    FREED char *text = NON_NULL(malloc(TEXT_ROOM));
    for (int i = 0; i < WINDOWS; i++) {
        write_window(text);
        check_ways(text);
    }
}

ARGUMENTS(count, words)
{
    scene_count = argument(count, words, 1, share_of(scene_count));
    traced.random ^= argument(count, words, 2, 0) * 0x9E3779B97F4A7C15;
    traced.reported = true;
}
