/* test_heat_picture.c - the pixels of pictures of flows and factors are compared with
 * the values of the surfaces seen there. A value of another surface, or a scale with
 * another unit, fails here. */
#include <unistd.h>

#include "rt/heat/color_scale.h"
#include "rt/heat/heat_picture.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

enum { WIDTH = 40, HEIGHT = 30 };
static char path[40];

static const char text[] = "camera { location <0, 1, -6> look_at 0 }\n"
                           "#declare Ball = sphere { -1.2*x, .8 }\n"
                           "#declare Block = box { <.3, -.6, -.6>, <1.5, .6, .6> }\n"
                           "#declare Sheet = disc { -y, y, 3 }\n"
                           "object { Ball } object { Block } object { Sheet }\n"
                           "object { Ball translate 30*z }\n";

static const char *const warm[] = { "default=300", "Ball=500", "Sheet=adiabatic" };

static struct heat_request usual(void)
{
    return (struct heat_request)ON_PRIOR(.mode = TRACE_VECTOR, .queue = 2000,
                                         .by = BY_PART, .drawn = 64, .repeats = 4,
                                         .lattice = true, .seed = 1, .exchange = true,
                                         .temperatures = warm, .temperature_count = 3);
}

static struct heat_look look_of(enum heat_shown shown, const char *from)
{
    return (struct heat_look){ .shown = shown,
                               .from = from,
                               .trace = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 500,
                                                 .width = WIDTH, .height = HEIGHT),
                               .path = path };
}

static double value_of(const struct heat *heat, enum heat_shown shown, size_t from,
                       size_t surface)
{
    if (shown == SHOWN_FACTOR)
        return heat->surfaces.list[from].factor[surface].value;
    return heat->thermal.exchange.flow[surface]
           / heat->surfaces.list[surface].area.value;
}

static void check_color(const struct frame *frame, size_t row, size_t column,
                        const double color[3])
{
    for (int k = 0; k < 3; k++)
        assert_true(fabs(frame->channel[k][row * frame->width + column] - color[k])
                    < .05);
}

static void check_picture(const struct heat *heat, enum heat_shown shown,
                          const char *from, size_t number)
{
    struct heat_look look = look_of(shown, from);
    struct heat_drawn drawn;
    c205_error why = { "" };
    SCOPED_VALUE(frame) frame;
    bool seen[5] = { false };
    double least = INFINITY, most = -INFINITY;
    REQUIRE(heat_draw(heat, &look, &drawn, &failure));
    assert_true(picture_read_layer(path, heat_shown_name(shown), &frame, &why));
    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        size_t id = (size_t)frame.channel[CHANNEL_ID][i];
        double expected = id == 0 ? 0
                                  : value_of(heat, shown, number,
                                             heat->surfaces.surface_of[id - 1]);
        seen[id] = true;
        assert_true(frame.value[i] == (double)(float)expected);
    }
    assert_true(seen[0] && seen[1] && seen[2] && seen[3]);
    /* The scale is below the frame and shows no object. Its ends have the colours of
     * the extremes, and it has numbers. */
    static const double left[][3] = { { .02, .08, .6 }, { .01, .02, .12 } },
                        right[][3] = { { .55, .01, .02 }, { .95, .75, .1 } },
                        white[3] = { .9, .9, .9 };
    bool from_zero = shown == SHOWN_FLOW && drawn.least >= 0;
    size_t bar = 0, dots = 0;
    assert_int_equal(frame.width, WIDTH);
    assert_true(frame.height > HEIGHT + 20);
    for (size_t k = WIDTH * HEIGHT; k < WIDTH * frame.height; k++) {
        assert_true(frame.channel[CHANNEL_ID][k] == 0 && frame.value[k] == 0);
        dots += frame.channel[CHANNEL_GREEN][k] > .85;
        if (bar == 0 && frame.channel[CHANNEL_BLUE][k] > .015)
            bar = k / WIDTH;
    }
    check_color(&frame, bar, 4, from_zero ? white : left[shown]);
    check_color(&frame, bar, WIDTH - 5, right[shown]);
    assert_true(dots > 50);
    for (size_t i = 0; i < heat->surfaces.count; i++) {
        least = fmin(least, value_of(heat, shown, number, i));
        most = fmax(most, value_of(heat, shown, number, i));
    }
    assert_true(drawn.least == least && drawn.most == most && drawn.clocks > 0);
    free(frame.value);
    remove(path);
}

TEST(values)
{
    struct heat_request request = usual();
    SCOPED(scene) *scene = read_scene(text);
    SCOPED_VALUE(heat) heat;
    REQUIRE(heat_begin(scene, &request, &heat, &failure) && heat_find(&heat, &failure));
    check_picture(&heat, SHOWN_FLOW, NULL, 0);
    check_picture(&heat, SHOWN_FACTOR, "Block", 1);
    check_picture(&heat, SHOWN_FACTOR, "Sheet", 2);
}

static void grey(const void *context UNUSED, double share, double color[3])
{
    assert_true(share >= -1 && share <= 1);
    color[0] = color[1] = color[2] = .5;
}

/* Returns the number of text pixels that a title adds to a scale. */
static size_t random_by(const char *title, double least, double most, size_t width)
{
    const struct color_scale scale = {
        .title = title, .least = least, .most = most, .color = grey
    };
    size_t rows = color_scale_rows(&scale, width), count = 0;
    SCOPED_VALUE(frame) frame;
    assert_true(frame_allocate(&frame, width, rows + 1));
    color_scale_draw(&scale, &frame, 1);
    for (size_t i = 0; i < width * (rows + 1); i++) {
        assert_true(i >= width || frame.channel[CHANNEL_RED][i] == 0);
        count += frame.channel[CHANNEL_RED][i] > .8;
    }
    return count;
}

/* Every character that a scale uses is drawn, in pictures of every width. */
TEST(scale)
{
    static const char used[] = "0123456789-+.,/^Wacefhilmnoprstuw";
    char letter[2] = "";
    size_t none = random_by("", -1, 1, 320), twice = random_by("", -1, 1, 640);
    for (size_t i = 0; used[i]; i++) {
        letter[0] = used[i];
        assert_true(random_by(letter, -1, 1, 320) > none);
    }
    assert_int_equal(twice, 4 * none);
    assert_int_equal(random_by("", 2, 3, 320), random_by("", 0, 3, 320));
    assert_int_equal(random_by("", -3, -2, 320), random_by("", -3, 0, 320));
    for (size_t width = 1; width < 400; width += 7)
        random_by("flow, W/m^2", -1.23457e-10, 9.87654e+20, width);
    random_by("flow, W/m^2", 0, 0, 320);
    random_by("flow, W/m^2", -2, -1, 320);
}

TEST(refused)
{
    struct heat_request request = usual();
    struct heat_look look = look_of(SHOWN_FACTOR, "Lid");
    SCOPED(scene) *scene = read_scene(text);
    SCOPED_VALUE(heat) heat;
    struct heat_drawn drawn;
    c205_error error = { "" };
    request.exchange = false;
    assert_true(heat_begin(scene, &request, &heat, &error) && heat_find(&heat, &error));
    assert_false(heat_draw(&heat, &look, &drawn, &error));
    assert_string_equal(error.message,
                        "unknown surface 'Lid', or a surface that emits nothing; "
                        "surfaces: Ball, Block, Sheet");
    look.shown = SHOWN_FLOW;
    assert_false(heat_draw(&heat, &look, &drawn, &error));
    assert_string_equal(error.message, "no surface has a value to draw");
    look.shown = SHOWN_FACTOR;
    look.from = "Ball";
    look.path = "missing/folder.exr";
    assert_false(heat_draw(&heat, &look, &drawn, &error));
    assert_non_null(strstr(error.message, "missing"));
}

FIXTURE(name_path)
{
    snprintf(path, sizeof path, "/tmp/rt205-heat-%ld.exr", (long)getpid());
    return set_up_model(test_state);
}

GROUP(name_path, tear_down_model);
