/* test_displayed_bands.c - a frame is read while it is traced. The displayed bands are
 * compared with the frame and its accounts. A band that is displayed twice or too
 * early, or a clock that decreases, fails here. */
#define MIDDLING_FRAMES
#include "tests/unit/traced_frame.h"

#define SCENE \
    "#version 3.7; global_settings { assumed_gamma %s }\n" \
    "light_source { <4, 9, -7>, rgb 1 }\n" \
    "camera { location <0, 1, -6> look_at 0 }\n" \
    "plane { y, -1 pigment { checker rgb .2, rgb .9 } finish { reflection " \
    ".3 } }\n"

/* Bands that a trace has displayed. */
struct shown {
    size_t done, under_way; /* numbers of views of complete and of incomplete bands */
    size_t last_row;        /* last row of the previous band */
    uint64_t clocks;        /* last reported clocks of this band */
    struct frame frame;     /* the complete bands */
    bool rows[MAX_PIXELS];  /* rows that are in the frame */
    uint64_t all;           /* clocks of the last complete band */
    size_t some;            /* number of views with only a part of their pixels */
};

static bool go_on(void *context UNUSED, size_t done UNUSED, size_t pixels UNUSED)
{
    return true;
}

static void look(void *context, const struct trace *trace,
                 const struct band_tracer *tracer, bool done)
{
    struct shown *shown = context;
    size_t width = trace_how(trace)->width;
    SCOPED_VALUE(band) band;
    assert_true(band_look(tracer, &band));
    size_t count = band.rows * width, there = 0;
    for (size_t i = 0; i < count; i++)
        there += c205_to_integer(band.words[(size_t)CHANNEL_ID * count + i]) != 0;
    if (trace_how(trace)->jobs == 1 && band.first_row == shown->last_row)
        assert_true(band.accounts.clocks >= shown->clocks);
    shown->clocks = done ? 0 : band.accounts.clocks;
    shown->last_row = band.first_row;
    shown->under_way += !done;
    shown->some += !done && there > 0 && there < count;
    if (done) {
        struct frame part = shown->frame;
        part.height = band.rows;
        for (int k = 0; k < FRAME_CHANNELS; k++)
            part.channel[k] += band.first_row * part.width;
        trace_read_band(trace, &band, &part);
        for (size_t row = 0; row < band.rows; row++) {
            assert_false(shown->rows[band.first_row + row]);
            shown->rows[band.first_row + row] = true;
        }
        shown->all = trace_accounts(trace)->clocks + band.accounts.clocks;
        shown->done++;
    }
}

TEST(bands)
{
    static const char *const gammas[] = { "1", "2.2" };
    char text[4000];
    for (int i = 0; i < 12; i++) {
        *text = '\0';
        add_text(text, sizeof text, SCENE, gammas[i % 2]);
        for (size_t k = among(1, 6); k > 0; k--) {
            add_text(text, sizeof text, "sphere { ");
            add_point(text, sizeof text, 2);
            add_text(text, sizeof text, ", %.3f pigment { rgb <1, .5, .2> } }",
                     between(.2, 1));
        }
        SCOPED(scene) *scene = read_text(text);
        enum trace_mode mode = (enum trace_mode)(i % TRACE_MODES);
        struct shown shown = { .done = 0 };
        struct trace_options options = ON_PRIOR(.mode = mode, .queue = among(1, 500),
                                                .width = among(20, WIDTH),
                                                .height = among(10, HEIGHT),
                                                .band = among(1, 400),
                                                .jobs = among(1, 3), .progress = go_on,
                                                .look = look, .context = &shown);
        assert_true(frame_allocate(&shown.frame, options.width, options.height));
        SCOPED(trace) *trace = run_trace(scene, &options);
        assert_int_equal(shown.done, trace_bands(trace));
        if (options.jobs == 1)
            assert_int_equal(shown.all, trace_accounts(trace)->clocks);
        const struct trace_options *how = trace_how(trace);
        SCOPED_VALUE(frame) frame;
        assert_true(frame_allocate(&frame, how->width, how->height));
        trace_read(trace, 0, &frame);
        for (size_t row = 0; row < how->height; row++)
            assert_true(shown.rows[row]);
        for (int k = 0; k < FRAME_CHANNELS; k++)
            assert_memory_equal(frame.channel[k], shown.frame.channel[k],
                                how->width * how->height * sizeof *frame.channel[k]);
        frame_free(&shown.frame);
    }
}

/* The frame is one band, and is long enough to be read while it is traced. A part of it
 * is visible before the rest. */
TEST(under_way)
{
    struct shown shown = { .done = 0 };
    struct trace_options options = ON_PRIOR(.mode = TRACE_SCALAR, .no_bounds = true,
                                            .width = WIDTH, .height = HEIGHT, .jobs = 1,
                                            .progress = go_on, .look = look,
                                            .context = &shown);
    char text[9000] = "";
    add_text(text, sizeof text, SCENE, "1");
    for (int k = 0; k < 100; k++)
        add_text(text, sizeof text, "sphere { <%d, %d, 0>, .3 pigment { rgb 1 } }",
                 k % 10 - 5, k / 10 - 5);
    SCOPED(scene) *scene = read_text(text);
    assert_true(frame_allocate(&shown.frame, WIDTH, HEIGHT));
    trace_free(run_trace(scene, &options));
    assert_int_equal(shown.done, 1);
    assert_true(shown.some > 0);
    frame_free(&shown.frame);
}
