/* traced_frame.c - traces frames in both forms, and writes random scenes. */
#include "traced_frame.h"
#include "tests/unit/scene_reading.h"

struct traced traced = { .random = RANDOM_SEED };

struct scene *read_text(const char *text)
{
    const struct scene_options options = { .strict = !traced.reported };
    SCOPED_VALUE(diagnostics) reports = { 0 };
    return read_reported(text, &options, &reports);
}

struct trace *run_trace(const struct scene *scene, const struct trace_options *options)
{
    struct trace *trace = trace_new(scene, options, &failure);
    REQUIRE(trace && trace_run(trace, &failure));
    return trace;
}

struct words *trace_words(const struct scene *scene, enum trace_mode mode, size_t queue)
{
    struct trace_options options = ON_PRIOR(.mode = mode, .width = traced.width,
                                            .height = traced.height, .queue = queue,
                                            .historical = traced.historical,
                                            .variant = traced.variant,
                                            .visible = traced.visible,
                                            .order = traced.order,
                                            .samples = traced.samples,
                                            .no_bounds = traced.no_bounds,
                                            .flat = traced.flat);
    SCOPED(trace) *trace = run_trace(scene, &options);
    struct words *words = NON_NULL(calloc(1, sizeof *words));
    for (int i = 0; i < FRAME_CHANNELS; i++)
        memcpy(words->channel[i], trace_channel(trace, (enum frame_channel)i),
               traced.pixels * sizeof(c205_word));
    return words;
}

struct words *same_frame_of(const struct scene *scene, const char *text)
{
    const size_t *queue = traced.queues;
    struct words *scalar = trace_words(scene, TRACE_SCALAR, 1);
    for (size_t i = 0; i < MAX_QUEUES && queue[i]; i++) {
        traced.order = i % 2 ? ORDER_ROWS : ORDER_TILES;
        FREED struct words *vector = trace_words(scene, TRACE_VECTOR, queue[i]);
        traced.order = ORDER_DEFAULT;

        for (int channel = 0; channel < FRAME_CHANNELS; channel++)
            for (size_t k = 0; k < traced.pixels; k++)
                FAIL_IF(scalar->channel[channel][k] != vector->channel[channel][k],
                        "queue %zu, channel %d, pixel %zu: %016llX, "
                        "scalar %016llX in\n%s",
                        queue[i], channel, k,
                        (unsigned long long)vector->channel[channel][k],
                        (unsigned long long)scalar->channel[channel][k], text);
    }
    return scalar;
}

struct words *same_frame(const char *text)
{
    SCOPED(scene) *scene = read_text(text);
    return same_frame_of(scene, text);
}

/* Returns the first channel of a pixel that differs from the plain tracer, or
 * FRAME_CHANNELS if all channels agree. */
static int other_channel(const struct words *words, const struct frame *plain, size_t k)
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

struct words *plain_frame(const char *text)
{
    SCOPED(scene) *scene = read_text(text);
    struct words *words = same_frame_of(scene, text);
    SCOPED_VALUE(frame) plain;
    size_t others = 0;
    assert_true(plain_trace(scene, traced.width, traced.height, &plain));
    for (size_t k = 0; k < traced.pixels; k++) {
        int channel = other_channel(words, &plain, k);
        others += channel != FRAME_CHANNELS;
        FAIL_IF(others > 3 * traced.pixels / 1000,
                "channel %d, pixel %zu: not what the plain tracer sees in\n%s", channel,
                k, text);
    }
    return words;
}

void check_paper_stage(const char *text, const struct words *expected)
{
    SCOPED(scene) *scene = read_text(text);
    FREED struct words *found = trace_words(scene, TRACE_KERNELS, traced.width + 1);
    FAIL_IF(memcmp(found, expected, sizeof *found) != 0,
            "the paper's stage gives another frame of\n%s", text);
}

size_t hits(const struct words *words)
{
    size_t count = 0;
    for (size_t i = 0; i < traced.pixels; i++)
        count += c205_to_integer(words->channel[CHANNEL_ID][i]) != 0;
    return count;
}

double between(double low, double high)
{
    return xorshift_real(&traced.random, low, high);
}

size_t among(size_t least, size_t most)
{
    return least + (size_t)(xorshift(&traced.random) % (most - least + 1));
}

void add_text(char *text, size_t size, const char *format, ...)
{
    size_t used = strlen(text);
    va_list list;
    va_start(list, format);
    vsnprintf(text + used, size - used, format, list);
    va_end(list);
}

void add_point(char *text, size_t size, double reach)
{
    add_text(text, size, "<%.9f, %.9f, %.9f>", between(-reach, reach),
             between(-reach, reach), between(-reach, reach));
}

void add_steiner_patch(char *text, size_t size, double reach)
{
    add_text(text, size, "steiner_patch { ");
    for (int i = 0; i < 6; i++) {
        add_text(text, size, "%s", i > 0 ? ", " : "");
        add_point(text, size, reach);
    }
    if (xorshift(&traced.random) % 2)
        for (int i = 0; i < 6; i++)
            add_text(text, size, "%s %.6f", i > 0 ? "," : " weights", between(.4, 2.5));
}

static void add_surface(char *text, size_t size)
{
    add_text(text, size, "pigment { %s rgb <%.3f, %.3f, %.3f> } ",
             xorshift(&traced.random) % 2 ? "checker" : "color", between(0, 1),
             between(0, 1), between(0, 1));
    add_text(text, size,
             "finish { phong %.2f phong_size %.1f specular %.2f roughness %.3f } ",
             xorshift(&traced.random) % 2 ? between(0, 1) : 0, between(1, 200),
             xorshift(&traced.random) % 2 ? between(0, 1) : 0, between(.005, .2));
    if (xorshift(&traced.random) % 2)
        add_text(text, size, "scale <%.6f, %.6f, %.6f> rotate <%.3f, %.3f, %.3f>",
                 between(.5, 1.5), between(.5, 1.5), between(.5, 1.5), between(-90, 90),
                 between(-90, 90), between(-90, 90));
}

void check_random_scenes(void (*add_shape)(char *, size_t), size_t scenes)
{
    static char text[1 << 18];
    size_t found = 0;
    for (size_t scene = 0; scene < scenes; scene++) {
        strcpy(text, HEAD "camera { location <0, 1, -6> look_at 0 }\n");
        for (int i = 0; i < 6; i++) {
            add_shape(text, sizeof text);
            add_surface(text, sizeof text);
            add_text(text, sizeof text, " }\n");
        }
        FREED struct words *words = plain_frame(text);
        found += hits(words);
    }
    assert_true(found > scenes * traced.pixels / 4);
}

void check_middle_within(const char *text, int64_t id, double depth, double tolerance)
{
    FREED struct words *words = same_frame(text);
    size_t middle = traced.height / 2 * traced.width + traced.width / 2;
    assert_int_equal(c205_to_integer(words->channel[CHANNEL_ID][middle]), id);
    /* assert_float_equal rounds to single precision. */
    assert_true(fabs(c205_to_double(words->channel[CHANNEL_DEPTH][middle]) - depth)
                <= tolerance);
}

void check_middle(const char *text, int64_t id, double depth)
{
    check_middle_within(text, id, depth, 1e-10);
}
