/* test_samples.c - several rays for each pixel. The pixels are compared with means, in
 * linear light, of a frame that has a pixel for each ray, in all forms and orders. A
 * sample that is lost or weighted twice fails here. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

#define THINGS \
    "light_source { <4, 9, -7>, rgb 1.5 }\n" \
    "background { rgb <.1, .2, .3> }\n" \
    "camera { location <0, 1, -6> look_at 0 right 1.3*x up y }\n" \
    "sphere { <-.8, 0, 0>, .9 pigment { rgb <1, .5, 0> }\n" \
    "  finish { reflection .4 phong 2 } }\n" \
    "box { <.2, -1, -.6>, <1.4, .5, .6> pigment { rgbt <.5, 1, 1, .6> }\n" \
    "  interior { ior 1.3 } rotate 20*y }\n" \
    "plane { y, -1 pigment { checker rgb 1, rgb <0, .2, 1> } }\n"

static const char linear[] =
    "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 3 }\n" THINGS;
static const char curved[] =
    "#version 3.7; global_settings { assumed_gamma 2.2 max_trace_level 3 }\n" THINGS;

static struct frame read_all(const struct trace *trace, size_t width, size_t height)
{
    struct frame frame;
    assert_true(frame_allocate(&frame, width, height));
    trace_read(trace, 0, &frame);
    return frame;
}

/* Returns the mean of a pixel's samples. */
static double mean(const double *samples, size_t width, size_t n)
{
    double sum = 0;
    for (size_t row = 0; row < n; row++)
        for (size_t column = 0; column < n; column++)
            sum += samples[row * width * n + column];
    return sum / (double)(n * n);
}

static void check_pixel(const struct frame *pixels, const struct frame *samples,
                        size_t n, size_t row, size_t column)
{
    size_t width = pixels->width;
    size_t first = row * n * width * n + column * n;
    for (int i = 0; i < FRAME_CHANNELS; i++) {
        double found = pixels->channel[i][row * width + column];
        const double *all = samples->channel[i] + first;
        if (i <= CHANNEL_BLUE)
            assert_float_equal(found, mean(all, width, n), 1e-9);
        else
            assert_true(found == all[n / 2 * width * n + n / 2]);
    }
}

/* Compares a frame with a frame that has a pixel for each ray. */
static uint64_t check_means(const struct scene *scene, size_t width, size_t height,
                            size_t n)
{
    struct trace_options options = ON_PRIOR(.mode = TRACE_SCALAR, .width = width,
                                            .height = height, .samples = n,
                                            .band = among(1, n * n * width * height));
    SCOPED(trace) *pixels = run_trace(scene, &options);
    SCOPED_VALUE(frame) of_pixels = read_all(pixels, width, height);
    uint64_t checksum = trace_checksum(pixels);
    assert_int_equal(trace_rays(pixels, RAY_PRIMARY), n * n * width * height);
    options.samples = 0;
    options.width *= n;
    options.height *= n;
    SCOPED(trace) *samples = run_trace(scene, &options);
    SCOPED_VALUE(frame) of_samples = read_all(samples, n * width, n * height);
    for (size_t row = 0; row < height; row++)
        for (size_t column = 0; column < width; column++)
            check_pixel(&of_pixels, &of_samples, n, row, column);
    return checksum;
}

static void check_forms(const struct scene *scene, size_t width, size_t height,
                        size_t n, uint64_t expected)
{
    for (int i = 0; i < 3; i++) {
        struct trace_options options = ON_PRIOR(
                .mode = i == 2 ? TRACE_KERNELS : TRACE_VECTOR,
                .order = i == 0 ? ORDER_ROWS : ORDER_TILES, .width = width,
                .height = height, .samples = n,
                .queue = xorshift(&traced.random) % 2 ? among(1, 9) : among(1, 999),
                .band = among(1, n * n * width * height), .jobs = among(1, 3));
        SCOPED(trace) *trace = run_trace(scene, &options);
        FAIL_IF(trace_checksum(trace) != expected,
                "%zu x %zu of %zu, %s by %s, queue %zu, band %zu: another frame", width,
                height, n, trace_mode_name(options.mode), order_name(options.order),
                options.queue, options.band);
    }
}

static void check_scene(const char *text, int times)
{
    SCOPED(scene) *scene = read_text(text);
    for (int i = 0; i < times; i++) {
        size_t n = among(2, 4), width = among(1, 17), height = among(1, 9);
        check_forms(scene, width, height, n, check_means(scene, width, height, n));
    }
}

TEST_CALL(linear, check_scene(linear, 6))

/* Samples are averaged in linear light if the assumed gamma is not 1. */
TEST_CALL(gamma, check_scene(curved, 4))

/* One sample for each pixel is the same as the default. */
TEST(one)
{
    SCOPED(scene) *scene = read_text(curved);
    struct trace_options options = ON_PRIOR(.mode = TRACE_VECTOR, .width = WIDTH,
                                            .height = HEIGHT, .queue = 50);
    SCOPED(trace) *none = run_trace(scene, &options);
    options.samples = 1;
    SCOPED(trace) *one = run_trace(scene, &options);
    assert_int_equal(trace_checksum(one), trace_checksum(none));
    assert_int_equal(trace_accounts(one)->clocks, trace_accounts(none)->clocks);
}

static bool stop_in_the_middle(void *context, size_t done, size_t all)
{
    size_t *asked = context;
    assert_true(done <= all);
    assert_int_equal(all, 40 * 60);
    return ++*asked < 4;
}

/* An interrupted band has no pixels. */
TEST(stopped)
{
    SCOPED(scene) *scene = read_text(linear);
    size_t asked = 0;
    struct trace_options options = ON_PRIOR(.mode = TRACE_SCALAR, .width = 40,
                                            .height = 60, .samples = 3,
                                            .band = 40 * 20 * 9,
                                            .progress = stop_in_the_middle,
                                            .context = &asked);
    SCOPED(trace) *trace = NON_NULL(trace_new(scene, &options, &failure));
    assert_int_equal(trace_bands(trace), 3);
    assert_false(trace_run(trace, &failure));
    assert_int_equal(trace_rows_done(trace), 20 * trace_bands_done(trace));
}
