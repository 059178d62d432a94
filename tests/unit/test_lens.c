/* test_lens.c - a camera with a lens. Frames of all forms are compared with each other
 * and with the plain tracer, and objects in focus with a pinhole camera. A sample at
 * another point of the lens, or a focal plane at another distance, fails here. */
#define SMALL_FRAMES
#include "tests/unit/traced_frame.h"

#define LIGHTS \
    "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 3 }\n" \
    "background { rgb <.2, .3, .4> }\n" \
    "light_source { <4, 9, -7>, .8 } light_source { <-9, 2, -5>, .3 }\n"
#define THINGS \
    "sphere { <-.8, 0, 0>, .9 pigment { rgb <1, .5, 0> }\n" \
    "  finish { reflection .4 } }\n" \
    "box { <.2, -1, -.6>, <1.4, .5, .6> pigment { rgbt <.5, 1, 1, .6> }\n" \
    "  interior { ior 1.3 } rotate 20*y }\n" \
    "sphere { <.5, .8, 2>, .7 pigment { gradient x color_map {\n" \
    "  [0 rgb 1] [1 rgb <0, .3, 1>] } } }\n"

/* ---- All forms ----------------------------------------------------------- */

TEST(random)
{
    for (size_t i = 0; i < share_of(10); i++) {
        char text[2000] = LIGHTS THINGS;
        bool orthographic = among(0, 3) == 0;
        add_text(text, sizeof text,
                 "camera { %s location <%.3f, %.3f, -5> %s\n"
                 "  aperture %.3f blur_samples %zu focal_point <%.2f, 0, %.2f>\n"
                 "  look_at 0 rotate %.1f*z translate %.2f*x }\n",
                 orthographic ? "orthographic" : "", between(-1, 1), between(-1, 2),
                 orthographic ? "right 4*x up 3*y" : "angle 42", between(-2, 2),
                 among(2, 17), between(-1, 1), between(-4, 6), between(-20, 20),
                 between(-.3, .3));
        FREED struct words *words = plain_frame(text);
        check_paper_stage(text, words);
        SCOPED(scene) *scene = read_text(text);
        struct trace_options options = ON_PRIOR(.mode = TRACE_SCALAR, .width = WIDTH,
                                                .height = HEIGHT,
                                                .samples = among(1, 5));
        SCOPED(trace) *scalar = run_trace(scene, &options);
        options.mode = among(0, 1) ? TRACE_VECTOR : TRACE_KERNELS;
        options.order = among(0, 1) ? ORDER_ROWS : ORDER_TILES;
        options.queue = among(1, 300);
        options.band = among(1, 900);
        options.jobs = among(1, 2);
        SCOPED(trace) *other = run_trace(scene, &options);
        assert_int_equal(trace_samples(scalar), trace_samples(other));
        FAIL_IF(trace_checksum(scalar) != trace_checksum(other),
                "%s by %s, queue %zu, band %zu, samples %zu: another frame of\n%s",
                trace_mode_name(options.mode), order_name(options.order), options.queue,
                options.band, options.samples, text);
    }
}

/* ---- In focus ------------------------------------------------------------ */

static struct frame seen(const char *camera, double distance, size_t samples)
{
    struct trace_options options = ON_PRIOR(.mode = TRACE_VECTOR, .width = WIDTH,
                                            .height = HEIGHT, .queue = 100,
                                            .samples = samples);
    char text[1000] = "";
    struct frame frame;
    add_text(text, sizeof text,
             "#version 3.7; global_settings { assumed_gamma 1 }\n"
             "plane { -z, %.9f pigment { gradient <1, 2, 0> color_map {\n"
             "  [0 rgb 1] [.3 rgb <0, .3, 1>] [1 rgb 1] } scale .4 }\n"
             "  finish { ambient 1 diffuse 0 } }\ncamera { %s }\n",
             -distance, camera);
    SCOPED(scene) *scene = read_text(text);
    SCOPED(trace) *trace = run_trace(scene, &options);
    assert_true(frame_allocate(&frame, WIDTH, HEIGHT));
    trace_read(trace, 0, &frame);
    return frame;
}

/* Returns the largest difference of a colour component. */
static double difference(const char *a, const char *b, double distance, size_t samples)
{
    SCOPED_VALUE(frame) one = seen(a, distance, samples);
    SCOPED_VALUE(frame) other = seen(b, distance, samples);
    double greatest = 0;
    for (int i = CHANNEL_RED; i <= CHANNEL_BLUE; i++)
        for (size_t k = 0; k < PIXELS; k++)
            greatest = fmax(greatest, fabs(one.channel[i][k] - other.channel[i][k]));
    return greatest;
}

/* An object in focus looks the same as through a pinhole, at any distance from the axis
 * and for any focal point. An object out of focus does not. */
TEST(focus)
{
    for (size_t samples = 2; samples <= 6; samples++)
        for (int orthographic = 0; orthographic < 2; orthographic++) {
            char pinhole[64], lens[300];
            double distance = between(2, 9);
            double aside = among(0, 1) ? .6 : 0;
            snprintf(pinhole, sizeof pinhole, "%s right 1.3*x up y",
                     orthographic ? "orthographic" : "");
            snprintf(lens, sizeof lens,
                     "%s aperture %.3f blur_samples %zu\n"
                     "focal_point %.9f*<%.1f, 0, %.1f>",
                     pinhole, between(.5, 3), samples * samples, distance, aside,
                     sqrt(1 - aside * aside));
            assert_true(difference(pinhole, lens, distance, samples) < 1e-6);
            assert_true(difference(pinhole, lens, 1.7 * distance, samples) > .01);
        }
}

/* ---- Words --------------------------------------------------------------- */

#define FOCUS "aperture -4 focal_point 7*z blur_samples 10 "

/* POV-Ray's values, which were measured in pictures of a small, distant sphere. */
TEST(words)
{
    static const struct {
        const char *camera;
        double radius, distance;
        int points;
    } rows[] = {
        { "camera { " FOCUS "confidence .9 variance 1/64 }", 1, 7, 10 },
        { "camera { " FOCUS "location -2*z }", 1, 9, 10 },
        { "camera { " FOCUS "translate 3*z scale 2 rotate y }", 1, 7, 10 },
        { "#declare C = camera { " FOCUS "} camera { C translate x }", 1, 7, 10 },
        { "#declare C = camera { " FOCUS "} camera { C focal_point 3*y }", 1, 3, 10 },
        { "camera { aperture 2 focal_point y }", .5, 1, 0 },
        { "camera { blur_samples 7 focal_point y }", 0, 1, 7 },
        { "camera { aperture 0 blur_samples 7 }", 0, 0, 7 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_text(rows[i].camera);
        assert_float_equal(scene->camera.lens_radius, rows[i].radius, 1e-12);
        assert_float_equal(scene->camera.focal_distance, rows[i].distance, 1e-12);
        assert_int_equal(scene->camera.lens_points, rows[i].points);
    }
}

/* Returns the number of rays across a pixel for an option --samples. */
static size_t across(const char *camera, size_t samples)
{
    SCOPED(scene) *scene = read_text(camera);
    struct trace_options options = ON_PRIOR(.mode = TRACE_VECTOR, .width = 2,
                                            .height = 1, .queue = 10,
                                            .samples = samples);
    SCOPED(trace) *trace = run_trace(scene, &options);
    size_t found = trace_samples(trace);
    assert_int_equal(trace_rays(trace, RAY_PRIMARY), 2 * found * found);
    return found;
}

TEST(samples)
{
    assert_int_equal(across("camera { " FOCUS "}", 1), 4);
    assert_int_equal(across("camera { " FOCUS "}", 3), 4);
    assert_int_equal(across("camera { " FOCUS "}", 5), 5);
    assert_int_equal(across("camera { " FOCUS "blur_samples 9 }", 1), 3);
    assert_int_equal(across("camera { " FOCUS "aperture 0 }", 2), 2);
    assert_int_equal(across("camera { " FOCUS "blur_samples 1 }", 1), 1);
}
