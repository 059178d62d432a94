/* test_frame_pixel.c - the queue of a pixel: in its clocks the pixel gets what it has in the
 * end, and what a timeline has of them is what the accounts have. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

#include "asm/timeline/timeline.h"
#include "rt/trace/frame_pixel.h"

static uint64_t random_state = RANDOM_SEED;

static size_t some(size_t least, size_t most)
{
    return (size_t)xorshift_between(&random_state, (int64_t)least,
                                    (int64_t)most);
}

static struct trace_options some_options(enum trace_mode mode)
{
    size_t width = some(3, 15);

    return (struct trace_options){ .mode = mode,
                                   .width = width,
                                   .height = some(3, 12),
                                   .queue = some(1, 80),
                                   .band = width * some(2, 6),
                                   .order = (enum trace_order)some(0, 2),
                                   .model = prior_model };
}

static struct scene *some_scene(void)
{
    static const char *const texts[] = {
        HEAD "camera { location -5*z look_at 0 } sphere { 0, 1.6 }"
             "plane { y, -1 finish { reflection .3 } }",
        HEAD "camera { location <1, 2, -5> look_at 0 }"
             "torus { 1, .4 rotate -30*x } box { <1, -1, 0>, 2 }"
             "difference { sphere { -x, 1 } box { -1, 0 } }",
        HEAD
        "camera { orthographic location -5*z right 4*x up 3*y }"
        "sphere { 0, 1 pigment { rgbt <1, 1, 1, .6> } interior { ior 1.3 } }"
        "plane { z, 2 pigment { checker rgb 1 rgb .2 } }",
    };

    return read_text(texts[some(0, 2)]);
}

/* ---- What the machine has when ------------------------------------------- */

/* Between two instructions. */
static c205 *machine_at(const struct frame_pixel *pixel, uint64_t clock)
{
    c205_error error;
    c205 *machine = trace_machine(pixel->trace, pixel->band, &error);
    c205_stop stop;

    assert_non_null(machine);
    while (c205_clock(machine) < clock && c205_step(machine, &stop))
        continue;
    return machine;
}

static c205_word sample(const struct frame_pixel *pixel, const c205 *machine,
                        enum frame_channel channel)
{
    const struct object *program = trace_program(pixel->trace);
    const char *const names[] = { "scene_frame", "scene_pixels" };
    c205_word word, values[2];

    for (size_t i = 0; i < 2; i++)
        assert_true(
            c205_read(machine,
                      (uint64_t)object_symbol(program, names[i])->value,
                      &values[i], 1));
    assert_true(
        c205_read(machine,
                  values[0]
                      + 64 * ((uint64_t)channel * values[1] + pixel->place),
                  &word, 1));
    return word;
}

/* The depth comes where the ray is shaded, not before and not later. */
static void check_depth(const struct frame_pixel *pixel,
                        const struct clock_stretch *stretch)
{
    const struct trace_options *how = trace_how(pixel->trace);
    c205_word depth =
        trace_channel(pixel->trace,
                      CHANNEL_DEPTH)[pixel->y * how->width + pixel->x];
    c205 *before = machine_at(pixel, stretch->from);
    c205 *after = machine_at(pixel, stretch->to);

    assert_true(c205_to_double(sample(pixel, before, CHANNEL_DEPTH)) == 0);
    if (c205_to_double(depth) != 0)
        assert_int_equal(sample(pixel, after, CHANNEL_DEPTH), depth);
    c205_free(before);
    c205_free(after);
}

static void add_causes(const c205 *machine, int64_t sign,
                       int64_t clocks[C205_CAUSES])
{
    for (size_t i = 0; i < c205_account_count(machine); i++)
        for (int cause = 0; cause < C205_CAUSES; cause++)
            clocks[cause] += sign
                             * (int64_t)c205_account_at(machine, i)
                                   ->clocks[cause];
}

static void check_sums(const struct frame_pixel *pixel,
                       const struct clock_stretch *stretch)
{
    struct timeline timeline = { .from = stretch->from, .to = stretch->to };
    c205_error error;
    c205 *machine = trace_machine(pixel->trace, pixel->band, &error);
    c205 *before = machine_at(pixel, stretch->from);
    c205 *after = machine_at(pixel, stretch->to);
    int64_t clocks[C205_CAUSES] = { 0 };
    c205_stop stop;

    assert_true(machine && c205_listen(machine, timeline_listen, &timeline));
    while (c205_clock(machine) < stretch->to && c205_step(machine, &stop))
        continue;
    assert_true(timeline_is_good(&timeline) && !timeline.full);
    add_causes(after, 1, clocks);
    add_causes(before, -1, clocks);
    for (size_t i = 0; i < timeline.piece_count; i++) {
        const struct timed_piece *piece = &timeline.pieces[i];

        if (piece->begin >= stretch->from && piece->begin < stretch->to)
            clocks[piece->cause] -= (int64_t)(piece->end - piece->begin);
    }
    for (int cause = 0; cause < C205_CAUSES; cause++)
        assert_int_equal(clocks[cause], 0);
    timeline_free(&timeline);
    c205_free(machine);
    c205_free(before);
    c205_free(after);
}

/* A stretch of a region is within the queue's; control is there in its clocks, and not before
 * in the queue. */
static void check_region(const struct frame_pixel *pixel,
                         const struct clock_stretch *queue)
{
    static const char *const regions[] = { "shade", "bound", "visible" };
    const struct object *program = trace_program(pixel->trace);
    const char *region = regions[some(0, 2)];
    struct clock_stretch stretch = *queue;
    c205_error error;
    c205_stop stop;
    c205 *machine;

    if (!frame_pixel_region(pixel, region, &stretch, &error))
        return;
    assert_true(stretch.to <= queue->to && stretch.from < stretch.to);
    machine = machine_at(pixel, queue->from);
    while (c205_clock(machine) < stretch.to) {
        bool there = strcmp(object_region(program, c205_pc(machine)), region)
                     == 0;

        assert_int_equal(there, c205_clock(machine) >= stretch.from);
        assert_true(c205_step(machine, &stop));
    }
    if (stretch.to < queue->to)
        assert_string_not_equal(object_region(program, c205_pc(machine)),
                                region);
    c205_free(machine);
}

static void check_pixels(enum trace_mode mode)
{
    struct scene *scene = some_scene();
    struct trace_options options = some_options(mode);
    struct trace *trace = run_trace(scene, &options);

    for (size_t i = 0; i < 4; i++) {
        struct frame_pixel pixel;
        struct clock_stretch stretch;
        c205_error error;

        assert_true(frame_pixel_find(&pixel, trace,
                                     some(0, options.width - 1),
                                     some(0, options.height - 1), &error));
        if (!frame_pixel_queue(&pixel, &stretch, &error))
            fail_msg("%s", error.message);
        check_depth(&pixel, &stretch);
        check_sums(&pixel, &stretch);
        check_region(&pixel, &stretch);
    }
    trace_free(trace);
    scene_free(scene);
}

static void test_queues(void **state)
{
    (void)state;
    for (size_t i = 0; i < 8 * TRACE_MODES; i++)
        check_pixels((enum trace_mode)(i % TRACE_MODES));
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(test_queues) };

    return cmocka_run_group_tests(tests, set_up_frames, tear_down_model);
}
