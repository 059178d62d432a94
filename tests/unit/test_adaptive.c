/* test_adaptive.c - adaptive sampling: the pixels that get more rays are compared with
 * those that a plain rule chooses, over random scenes, thresholds, forms, orders and
 * bands. A missing comparison, a wrong weight or a seam between bands fails here. */
#define SMALL_FRAMES
#include "tests/oracle/plain_adaptive.h"
#include "tests/oracle/plain_shapes.h"
#include "tests/unit/scene_reading.h"
#include "tests/unit/traced_frame.h"

#include "rt/jobs/job_set.h"

#include <unistd.h>

#define SEEN \
    "#version 3.7; global_settings { assumed_gamma %s max_trace_level 3 }\n" \
    "light_source { <4, 9, -7>, rgb 1.5 }\n" \
    "background { rgb <.1, .2, .3> }\n"

/* Adds an object. Some colours are darker than black or brighter than white. */
static void add_thing(char *text, size_t size)
{
    static const char *const looks[] = {
        "pigment { checker rgb 1, rgb <0, .2, 1> scale .6 }",
        "pigment { gradient x color_map { [0 rgb 1] [1 rgb <.4, 0, .1>] } }",
        "pigment { rgb <1, .6, .1> } finish { reflection .4 phong 3 }",
        "pigment { rgbt <.5, 1, 1, .6> } interior { ior 1.3 }",
        "pigment { rgb 1 } finish { ambient 3 }",
        "pigment { rgb <-1, .2, .3> } finish { ambient .6 }",
    };
    add_text(text, size, "%s", among(0, 1) ? "sphere { 0, 1 " : "box { -.7, .7 ");
    add_text(text, size, "scale <%.2f, %.2f, 1> rotate %.1f*z rotate %.1f*y\n",
             between(.2, 1.2), between(.1, 1), between(0, 180), between(0, 180));
    add_text(text, size, "  translate <%.3f, %.3f, %.3f> %s }\n", between(-2, 2),
             between(-1.5, 1.5), between(-1, 3), looks[among(0, COUNT(looks) - 1)]);
}

static void add_scene(char *text, size_t size)
{
    add_text(text, size, SEEN, among(0, 3) == 0 ? "2.2" : "1");
    add_text(text, size,
             "camera { %s location <%.2f, .6, -5> right 4*x up 3*y "
             "direction 4*z rotate %.1f*z }\n",
             among(0, 3) == 0 ? "orthographic" : "", between(-.5, .5),
             between(-20, 20));
    for (size_t i = among(1, 6); i > 0; i--)
        add_thing(text, size);
}

/* ---- The plain rule ------------------------------------------------------ */

static struct frame new_frame(size_t width, size_t height)
{
    struct frame frame;
    assert_true(frame_allocate(&frame, width, height));
    return frame;
}

static struct frame traced_frame(const struct scene *scene, size_t width, size_t height)
{
    struct trace_options options = ON_PRIOR(.mode = TRACE_VECTOR, .queue = TRACE_QUEUE,
                                            .width = width, .height = height);
    SCOPED(trace) *trace = run_trace(scene, &options);
    struct frame frame = new_frame(width, height);
    trace_read(trace, 0, &frame);
    return frame;
}

/* Extends the camera by one column on the left, and one row at the top. */
static void look_beyond(struct camera *camera, double width, double height)
{
    double *middle = camera->orthographic ? camera->location : camera->direction;
    add_scaled(middle, middle, -.5 / width, camera->right);
    add_scaled(middle, middle, .5 / height, camera->up);
    add_scaled(camera->right, camera->right, 1 / width, camera->right);
    add_scaled(camera->up, camera->up, 1 / height, camera->up);
}

/* Refines the picture by the plain rule, which compares colours before gamma. */
static struct plain_refined
expect(struct scene *scene, const struct trace_options *options, struct frame *picture)
{
    struct camera camera = scene->camera;
    double gamma = scene->assumed_gamma;
    size_t width = options->width + 1, height = options->height + 1;
    look_beyond(&scene->camera, (double)options->width, (double)options->height);
    scene->assumed_gamma = 1;
    SCOPED_VALUE(frame) first = traced_frame(scene, width, height);
    SCOPED_VALUE(frame) sampled = traced_frame(scene, options->samples * width,
                                               options->samples * height);
    scene->camera = camera;
    scene->assumed_gamma = gamma;
    return plain_adaptive(&first, &sampled, options->samples, options->threshold, gamma,
                          picture);
}

static double linear(double colour, double gamma)
{
    return colour > 0 ? pow(colour, gamma) : gamma == 1 ? colour : 0;
}

/* Returns the number of pixels whose colours differ. */
static size_t count_others(const struct frame *expected, const struct frame *found,
                           double gamma)
{
    size_t count = 0;
    for (size_t k = 0; k < found->width * found->height; k++) {
        double greatest = 0;
        for (int i = CHANNEL_RED; i <= CHANNEL_BLUE; i++)
            greatest = fmax(greatest, fabs(linear(expected->channel[i][k], gamma)
                                           - found->channel[i][k]));
        count += greatest > 1e-6;
    }
    return count;
}

/* Returns the number of rays of the first pass, for bands of whole blocks. It is one
 * for each pixel, and one additional column and row for each band. */
static uint64_t first_rays(const struct trace *trace,
                           const struct trace_options *options)
{
    return (options->height + trace_bands(trace)) * (options->width + 1);
}

static void check_rays(const struct trace *trace, const struct trace_options *options,
                       size_t refined)
{
    size_t each = options->samples * options->samples;
    uint64_t rays = trace_rays(trace, RAY_PRIMARY);
    uint64_t sampled = rays - first_rays(trace, options);
    assert_true(rays >= first_rays(trace, options));
    assert_int_equal(sampled % each, 0);
    assert_true(sampled / each >= refined);
    assert_true(sampled / each <= refined + refined / 5 + 8);
}

/* Compares a trace with the plain rule. Pixels at edges may differ by rounding. */
static void check_plain(struct scene *scene, const struct trace *trace,
                        const struct trace_options *options, const char *text)
{
    SCOPED_VALUE(frame) expected = new_frame(options->width, options->height);
    SCOPED_VALUE(frame) found = new_frame(options->width, options->height);
    struct plain_refined refined = expect(scene, options, &expected);
    trace_read(trace, 0, &found);
    size_t others = count_others(&expected, &found, scene->assumed_gamma);
    FAIL_IF(refined.margin > 1e-9 && others > 0,
            "%zu of %zu x %zu pixels are others, threshold %g, samples "
            "%zu, in\n%s",
            others, options->width, options->height, options->threshold,
            options->samples, text);
    if (refined.margin > 1e-9)
        check_rays(trace, options, refined.count);
}

/* ---- All forms ----------------------------------------------------------- */

static void check_form(const struct scene *scene, const struct trace_options *like,
                       const struct trace *expected, const char *text)
{
    struct trace_options options = *like;
    options.mode = among(0, 1) ? TRACE_VECTOR : TRACE_KERNELS;
    options.order = among(0, 1) ? ORDER_ROWS : ORDER_TILES;
    options.queue = among(0, 2) ? among(100, 2000) : among(1, 60);
    options.band = among(0, 1) ? 0 : among(1, 4000);
    options.jobs = among(1, 3);
    SCOPED(trace) *trace = run_trace(scene, &options);
    FAIL_IF(trace_checksum(trace) != trace_checksum(expected),
            "%s by %s, queue %zu, band %zu, threshold %g, samples %zu: "
            "another frame of %zu x %zu of\n%s",
            trace_mode_name(options.mode), order_name(options.order), options.queue,
            options.band, options.threshold, options.samples, options.width,
            options.height, text);
    if (trace_bands(trace) == trace_bands(expected))
        for (int kind = 0; kind < RAY_KINDS; kind++)
            assert_int_equal(trace_rays(trace, kind), trace_rays(expected, kind));
}

static void check_scene(const char *text, const struct trace_options *options)
{
    SCOPED(scene) *scene = read_text(text);
    SCOPED(trace) *scalar = run_trace(scene, options);
    check_plain(scene, scalar, options, text);
    check_form(scene, options, scalar, text);
    check_form(scene, options, scalar, text);
}

TEST(random)
{
    for (size_t i = 0; i < share_of(30); i++) {
        char text[3000] = "";
        struct trace_options options = ON_PRIOR(.mode = TRACE_SCALAR,
                                                .width = among(1, 70),
                                                .height = among(1, 70),
                                                .samples = among(2, 4),
                                                .threshold = exp(between(-4, 1)),
                                                .band = among(1, 5000));
        add_scene(text, sizeof text);
        check_scene(text, &options);
    }
}

/* The stripes have the width of a pixel, so that all first rays are white. A refined
 * pixel is darker, so that the next one is refined up to the block's end. */
TEST(chains)
{
    for (int i = 0; i < 6; i++) {
        char text[3000] = "";
        struct trace_options options = ON_PRIOR(.mode = TRACE_SCALAR, .width = 80,
                                                .height = 6, .samples = among(2, 3),
                                                .threshold = .3);
        add_text(text, sizeof text,
                 "#version 3.7; global_settings { assumed_gamma 1 }\n"
                 "camera { orthographic location -5*z direction z\n"
                 "  right 80*x up 6*y }\n"
                 "plane { -z, 0 pigment { gradient x color_map { [.7 rgb 1]\n"
                 "  [.7 rgb 0] } } finish { ambient 1 } }\n");
        for (size_t k = among(1, 5); k > 0; k--)
            add_text(text, sizeof text,
                     "sphere { <%.2f, %.2f, -2>, .4 pigment { rgb 0 } }\n",
                     between(-40, 40), between(-3, 3));
        check_scene(text, &options);
    }
}

/* ---- Limits of the threshold --------------------------------------------- */

static const char shades[] =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "camera { location -5*z } plane { -z, 0 finish { ambient 1 diffuse 0 }\n"
    "  pigment { gradient <1, 2, 0> color_map { [0 rgb 0] [1 rgb <1, .8, .6>] }\n"
    "  scale 9 translate <1, -20, 0> } }\n";

static struct trace *trace_with(const struct scene *scene, size_t samples,
                                double threshold)
{
    struct trace_options options = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 300,
                                            .width = WIDTH, .height = HEIGHT,
                                            .samples = samples, .threshold = threshold);
    return run_trace(scene, &options);
}

static double red(const struct trace *trace, size_t pixel)
{
    return c205_to_double(trace_channel(trace, CHANNEL_RED)[pixel]);
}

/* All pixels are refined if all differ by more than the threshold. The first ray then
 * counts as an additional sample. If none differs, each has its first ray only. */
TEST(ends)
{
    SCOPED(scene) *scene = read_text(shades);
    SCOPED(trace) *one = trace_with(scene, 1, 0);
    SCOPED(trace) *all = trace_with(scene, 3, 0);
    SCOPED(trace) *refined = trace_with(scene, 3, 1e-9);
    SCOPED(trace) *first = trace_with(scene, 3, 3);
    uint64_t first_rays = (WIDTH + 1) * (HEIGHT + 1);
    for (size_t k = 0; k < PIXELS; k++) {
        assert_close(red(first, k), red(one, k), 1e-9);
        assert_close(red(refined, k), .9 * red(all, k) + .1 * red(one, k), 1e-9);
    }
    assert_int_equal(trace_rays(first, RAY_PRIMARY), first_rays);
    assert_int_equal(trace_rays(refined, RAY_PRIMARY), first_rays + 9 * PIXELS);
    assert_true(trace_accounts(first)->clocks < trace_accounts(all)->clocks);
}

/* Depth, normal and id belong to the middle ray, which every sampling includes. */
TEST(middles)
{
    char text[3000] = "";
    add_scene(text, sizeof text);
    SCOPED(scene) *scene = read_text(text);
    SCOPED(trace) *all = trace_with(scene, 3, 0);
    SCOPED(trace) *refined = trace_with(scene, 3, .1);
    for (int i = CHANNEL_BLUE + 1; i < FRAME_CHANNELS; i++)
        assert_memory_equal(trace_channel(all, (enum frame_channel)i),
                            trace_channel(refined, (enum frame_channel)i),
                            PIXELS * sizeof(c205_word));
}

/* ---- Unsupported combinations -------------------------------------------- */

static void check_refused(const char *text, size_t width, size_t samples,
                          double threshold, const char *why)
{
    SCOPED(scene) *scene = read_text(text);
    struct trace_options options = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 300,
                                            .width = width, .height = 1,
                                            .samples = samples, .threshold = threshold);
    c205_error error = { "" };
    assert_null(trace_new(scene, &options, &error));
    FAIL_IF(!strstr(error.message, why), "%s, not %s", error.message, why);
}

TEST(refused)
{
    static const char lens[] = "sphere { 0, 1 } camera { location -5*z\n"
                               "aperture .3 focal_point 0 blur_samples 9 }\n";
    check_refused(shades, 9, 0, .3, "requires at least 2 samples");
    check_refused(shades, 9, 1, .3, "requires at least 2 samples");
    check_refused(shades, 9, 3, -.3, "above 0");
    check_refused(shades, 9, 3, NAN, "above 0");
    check_refused(shades, 9, 3, INFINITY, "above 0");
    check_refused(shades, MAX_TRACE_COLUMNS + 1, 2, .3, "65534 columns");
    check_refused(lens, 9, 3, .3, "has a lens");
}

/* ---- Stopped and continued ----------------------------------------------- */

struct patience {
    size_t asked, most;
};

static bool wait_on(void *context, size_t done, size_t all)
{
    struct patience *patience = context;
    assert_true(done <= all);
    return ++patience->asked < patience->most;
}

static struct trace *begin_kept(const struct scene *scene, double threshold,
                                struct patience *patience, struct job_set *job_set)
{
    struct trace_options options = ON_PRIOR(.mode = TRACE_SCALAR, .width = 65,
                                            .height = 3 * TRACE_BLOCK, .samples = 3,
                                            .threshold = threshold, .band = 1,
                                            .progress = patience ? wait_on : NULL,
                                            .job_set = job_set, .context = patience);
    c205_error error = { "" };
    struct trace *trace = NON_NULL(trace_new(scene, &options, &failure));
    assert_int_equal(trace_bands(trace), 3);
    if (job_set && !trace_keep(trace, &error)) {
        assert_non_null(strstr(error.message, "another run"));
        trace_free(trace);
        return NULL;
    }
    return trace;
}

/* Saved bands are complete. An interrupted band is not saved. */
TEST(kept)
{
    char path[] = "/tmp/test_adaptive.XXXXXX";
    const char *const paths[] = { path };
    struct job_set job_set = { .paths = paths, .path_count = 1 };
    SCOPED(scene) *scene = read_text(shades);
    struct patience patience = { 0, SIZE_MAX };
    SCOPED(trace) *whole = begin_kept(scene, .02, &patience, NULL);
    close(mkstemp(path));
    assert_true(trace_run(whole, &failure));
    patience = (struct patience){ 0, patience.asked * 3 / 4 };
    SCOPED(trace) *trace = begin_kept(scene, .02, &patience, &job_set);
    assert_false(trace_run(trace, &failure));
    assert_true(trace_bands_done(trace) > 0);
    assert_int_equal(trace_rows_done(trace), TRACE_BLOCK * trace_bands_done(trace));
    trace_free(trace);
    assert_null(begin_kept(scene, .03, NULL, &job_set));
    trace = begin_kept(scene, .02, NULL, &job_set);
    assert_true(job_set.kept > 0);
    assert_true(trace_run(trace, &failure));
    assert_int_equal(trace_checksum(trace), trace_checksum(whole));
    assert_int_equal(trace_accounts(trace)->clocks, trace_accounts(whole)->clocks);
    trace_forget(trace);
}
