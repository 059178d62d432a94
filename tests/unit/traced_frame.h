/* traced_frame.h - frames of both forms of the tracer, for its tests.
 *
 * Every frame is traced by the scalar form and by the vector form with queues
 * of several lengths, and all must be equal, bit for bit.
 */
#ifndef TESTS_TRACED_FRAME_H
#define TESTS_TRACED_FRAME_H

#include "rt/trace/trace.h"
#include "rt/scene/language/scene_read.h"
#include "tests/oracle/plain_tracer.h"
#include "tests/random.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Where a frame is dear a test may define SMALL_FRAMES, or MIDDLING_FRAMES.
 * STRAIGHT_AHEAD has a unit for each pixel. */
#ifdef SMALL_FRAMES
enum { WIDTH = 17, HEIGHT = 13 };
#define STRAIGHT_AHEAD "direction 32*z right 17*x up 13*y"
/* clang-format off */
#define QUEUES { 1, WIDTH - 1, 2000 }
/* clang-format on */
#elif defined MIDDLING_FRAMES
enum { WIDTH = 31, HEIGHT = 23 };
#define STRAIGHT_AHEAD "direction 48*z right 31*x up 23*y"
/* clang-format off */
#define QUEUES { 1, 40, 2000 }
/* clang-format on */
#else
enum { WIDTH = 41, HEIGHT = 31 };
#define STRAIGHT_AHEAD "direction 64*z right 41*x up 31*y"
/* clang-format off */
#define QUEUES { 1, WIDTH - 1, WIDTH, 2000 }
/* clang-format on */
#endif

enum { PIXELS = WIDTH * HEIGHT };

struct words {
    c205_word channel[FRAME_CHANNELS][PIXELS];
};

static c205_model *model;
static uint64_t random_state = RANDOM_SEED;
static bool historical, no_bounds; /* as in trace_options */
static enum visible visible;       /* likewise */
static bool reported;              /* there may be reports about the scene */

static inline struct scene *read_text(const char *text)
{
    const struct scene_options options = { .strict = !reported };
    struct diagnostics reports = { 0 };
    struct scene *scene = scene_read_text("test", text, &options, &reports);

    if (!scene)
        diagnostics_print(&reports, stderr);
    assert_non_null(scene);
    diagnostics_free(&reports);
    return scene;
}

static inline struct words *trace_words(const struct scene *scene,
                                        enum trace_mode mode, size_t queue)
{
    struct trace_options options = { .mode = mode,
                                     .width = WIDTH,
                                     .height = HEIGHT,
                                     .queue = queue,
                                     .historical = historical,
                                     .visible = visible,
                                     .no_bounds = no_bounds,
                                     .model = model };
    c205_error error = { "" };
    struct trace *trace = trace_new(scene, &options, &error);
    struct words *words = malloc(sizeof *words);

    if (!trace || !trace_run(trace, &error))
        fail_msg("%s", error.message);
    assert_non_null(words);
    for (int i = 0; i < FRAME_CHANNELS; i++)
        memcpy(words->channel[i], trace_channel(trace, (enum frame_channel)i),
               sizeof words->channel[i]);
    trace_free(trace);
    return words;
}

/* The scalar frame, after comparing it with those of several queues. */
static inline struct words *same_frame_of(const struct scene *scene,
                                          const char *text)
{
    static const size_t queues[] = QUEUES;
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
    return scalar;
}

static inline struct words *same_frame(const char *text)
{
    struct scene *scene = read_text(text);
    struct words *words = same_frame_of(scene, text);

    scene_free(scene);
    return words;
}

/* The first channel in which a pixel is not what the plain tracer sees, or
 * FRAME_CHANNELS. */
static inline int other_channel(const struct words *words,
                                const struct frame *plain, size_t k)
{
    for (int channel = 0; channel < FRAME_CHANNELS; channel++) {
        c205_word word = words->channel[channel][k];
        double found = channel == CHANNEL_ID ? (double)c205_to_integer(word)
                                             : c205_to_double(word);
        double expected = plain->channel[channel][k];

        if (!(fabs(found - expected) <= 1e-7 * (1 + fabs(expected))))
            return channel;
    }
    return FRAME_CHANNELS;
}

/* The same, and it is the plain tracer's, but for a few pixels in a thousand,
 * at outlines and creases, where one rounding decides. */
static inline struct words *plain_frame(const char *text)
{
    struct scene *scene = read_text(text);
    struct words *words = same_frame_of(scene, text);
    struct frame plain;
    size_t others = 0;

    assert_true(plain_trace(scene, WIDTH, HEIGHT, &plain));
    for (size_t k = 0; k < PIXELS; k++) {
        int channel = other_channel(words, &plain, k);

        others += channel != FRAME_CHANNELS;
        if (others > 3 * PIXELS / 1000)
            fail_msg("channel %d, pixel %zu: not what the plain tracer sees "
                     "in\n%s",
                     channel, k, text);
    }
    frame_free(&plain);
    scene_free(scene);
    return words;
}

static inline void check_paper_stage(const char *text,
                                     const struct words *expected)
{
    struct scene *scene = read_text(text);
    struct words *found = trace_words(scene, TRACE_KERNELS, WIDTH + 1);

    if (memcmp(found, expected, sizeof *found) != 0)
        fail_msg("the paper's stage gives another frame of\n%s", text);
    free(found);
    scene_free(scene);
}

static inline size_t hits(const struct words *words)
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

static inline double between(double low, double high)
{
    return low
           + (high - low) * (double)(xorshift(&random_state) >> 11) * 0x1p-53;
}

static inline void add(char *text, size_t size, const char *format, ...)
{
    size_t used = strlen(text);
    va_list list;

    va_start(list, format);
    vsnprintf(text + used, size - used, format, list);
    va_end(list);
}

static inline void add_point(char *text, size_t size, double reach)
{
    add(text, size, "<%.9f, %.9f, %.9f>", between(-reach, reach),
        between(-reach, reach), between(-reach, reach));
}

static inline void add_surface(char *text, size_t size)
{
    add(text, size, "pigment { %s rgb <%.3f, %.3f, %.3f> } ",
        xorshift(&random_state) % 2 ? "checker" : "color", between(0, 1),
        between(0, 1), between(0, 1));
    add(text, size,
        "finish { phong %.2f phong_size %.1f specular %.2f "
        "roughness %.3f } ",
        xorshift(&random_state) % 2 ? between(0, 1) : 0, between(1, 200),
        xorshift(&random_state) % 2 ? between(0, 1) : 0, between(.005, .2));
    if (xorshift(&random_state) % 2)
        add(text, size, "scale <%.6f, %.6f, %.6f> rotate <%.3f, %.3f, %.3f>",
            between(.5, 1.5), between(.5, 1.5), between(.5, 1.5),
            between(-90, 90), between(-90, 90), between(-90, 90));
}

/* Scenes of six shapes each; at least a quarter of the rays must hit. */
static inline void check_random_scenes(void (*add_shape)(char *, size_t),
                                       size_t scenes)
{
    char text[16384];
    size_t found = 0;

    for (size_t scene = 0; scene < scenes; scene++) {
        strcpy(text, HEAD "camera { location <0, 1, -6> look_at 0 }\n");
        for (int i = 0; i < 6; i++) {
            add_shape(text, sizeof text);
            add_surface(text, sizeof text);
            add(text, sizeof text, " }\n");
        }
        struct words *words = plain_frame(text);
        found += hits(words);
        free(words);
    }
    assert_true(found > scenes * PIXELS / 4);
}

/* The middle column and row of the picture look straight ahead. */
#define AHEAD HEAD "camera { location <0, 0, -5> direction z right x up y }\n"

/* Numbers chosen so that nothing is cut off: the middle ray is 0, 0, 1. */
#define STRAIGHT HEAD "camera { location <0, 0, -5> " STRAIGHT_AHEAD " }\n"

static inline void check_middle_within(const char *text, int64_t id,
                                       double depth, double tolerance)
{
    struct words *words = same_frame(text);
    size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;

    assert_int_equal(c205_to_integer(words->channel[CHANNEL_ID][middle]), id);
    assert_float_equal(c205_to_double(words->channel[CHANNEL_DEPTH][middle]),
                       depth, tolerance);
    free(words);
}

static inline void check_middle(const char *text, int64_t id, double depth)
{
    check_middle_within(text, id, depth, 1e-10);
}

static inline int set_up(void **state)
{
    c205_error error;

    (void)state;
    model = c205_model_find("cyber205-2pipe-prior", &error);
    return !model;
}

static inline int tear_down(void **state)
{
    (void)state;
    c205_model_free(model);
    return 0;
}

#endif
