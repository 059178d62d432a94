#include "rt/trace.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rt/layout.h"
#include "rt/program.h"

struct trace {
    struct trace_options options;
    struct object *program;
    c205 *machine;
    struct frame_layout layout;
    double gamma; /* of the scene's colours */
};

static const struct form {
    const char *name, *program;
} forms[TRACE_MODES] = {
    [TRACE_SCALAR] = { "scalar", "frame_scalar.s" },
    [TRACE_VECTOR] = { "vector", "frame_vector.s" },
};

const char *trace_mode_name(enum trace_mode mode)
{
    return forms[mode].name;
}

bool trace_mode_named(const char *name, enum trace_mode *mode)
{
    for (int i = 0; i < TRACE_MODES; i++)
        if (strcmp(name, forms[i].name) == 0) {
            *mode = (enum trace_mode)i;
            return true;
        }
    return false;
}

static struct object *assemble_form(const struct trace_options *options,
                                    c205_error *error)
{
    struct asm_define defines[] = {
        { "QUEUE", (int64_t)options->queue },
        { "HISTORICAL", 1 },
        { "FALSI", FALSI_PAPER },
        { NULL, 0 },
    };

    if (!options->historical)
        defines[1] = defines[3];

    return program_assemble(forms[options->mode].program, defines, error);
}

static bool prepare(struct trace *trace, const struct scene *scene,
                    c205_error *error)
{
    trace->program = assemble_form(&trace->options, error);
    if (trace->program == NULL)
        return false;
    trace->machine = c205_new(trace->options.model, error);
    return trace->machine != NULL
           && c205_load(trace->machine, &trace->program->program, error)
           && layout_scene(trace->machine, trace->program, scene,
                           &trace->layout, error);
}

struct trace *trace_new(const struct scene *scene,
                        const struct trace_options *options,
                        c205_error *error)
{
    struct trace *trace = calloc(1, sizeof *trace);

    if (trace == NULL) {
        snprintf(error->message, sizeof error->message, "no memory");
        return NULL;
    }
    trace->options = *options;
    trace->layout.width = options->width;
    trace->layout.height = options->height;
    trace->gamma = scene->assumed_gamma > 0 ? scene->assumed_gamma : 1;
    if (prepare(trace, scene, error))
        return trace;
    trace_free(trace);
    return NULL;
}

void trace_free(struct trace *trace)
{
    if (trace == NULL)
        return;
    c205_free(trace->machine);
    object_free(trace->program);
    free(trace);
}

bool trace_watch(struct trace *trace, struct iterations *iterations)
{
    return iterations_begin(iterations, trace->program,
                            trace->options.mode == TRACE_VECTOR)
           && c205_listen(trace->machine, iterations_listen, iterations);
}

/* Rays made so far, from the account of the routine that makes them. */
static size_t pixels_done(const struct trace *trace)
{
    size_t rays = trace->options.mode == TRACE_VECTOR ? trace->options.queue
                                                      : 1;
    size_t pixels = trace->layout.width * trace->layout.height;
    size_t done = 0;

    for (size_t i = 0; i < c205_account_count(trace->machine); i++) {
        const c205_account *account = c205_account_at(trace->machine, i);

        if (strcmp(account->name, "generate") == 0)
            done = (size_t)account->entries * rays;
    }
    return done < pixels ? done : pixels;
}

bool trace_run(struct trace *trace, c205_error *error)
{
    enum { SLICE = 5000000 }; /* clocks between two looks at progress */
    const struct trace_options *options = &trace->options;
    size_t pixels = trace->layout.width * trace->layout.height;

    for (;;) {
        uint64_t limit = options->progress == NULL
                             ? C205_NO_LIMIT
                             : c205_clock(trace->machine) + SLICE;
        c205_stop stop = c205_run(trace->machine, limit);

        if (stop.trap == C205_TRAP_NONE) {
            if (options->progress != NULL)
                options->progress(options->context, pixels, pixels);
            return true;
        }
        if (stop.trap != C205_TRAP_CLOCK_LIMIT) {
            c205_describe_stop(trace->machine, &stop, error);
            return false;
        }
        if (!options->progress(options->context, pixels_done(trace),
                               pixels)) {
            snprintf(error->message, sizeof error->message,
                     "stopped after %zu of %zu pixels", pixels_done(trace),
                     pixels);
            return false;
        }
    }
}

bool trace_read_words(const struct trace *trace, enum frame_channel channel,
                      c205_word *words)
{
    size_t pixels = trace->layout.width * trace->layout.height;

    return c205_read(trace->machine,
                     trace->layout.address
                         + UINT64_C(64) * pixels * (uint64_t)channel,
                     words, pixels);
}

static void convert(double *samples, const c205_word *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        samples[i] = c205_to_double(words[i]);
}

static void make_linear(double *samples, size_t count, double gamma)
{
    for (size_t i = 0; i < count && gamma != 1; i++)
        samples[i] = samples[i] > 0 ? pow(samples[i], gamma) : 0;
}

bool trace_read(const struct trace *trace, struct frame *frame,
                c205_error *error)
{
    size_t pixels = trace->layout.width * trace->layout.height;
    c205_word *words = malloc(pixels * sizeof *words);
    bool good = words != NULL
                && frame_allocate(frame, trace->layout.width,
                                  trace->layout.height);

    for (int i = 0; good && i < FRAME_CHANNELS; i++) {
        good = trace_read_words(trace, (enum frame_channel)i, words);
        if (good)
            convert(frame->channel[i], words, pixels);
        if (good && i <= CHANNEL_BLUE)
            make_linear(frame->channel[i], pixels, trace->gamma);
    }
    if (!good)
        snprintf(error->message, sizeof error->message,
                 "no memory for the frame");
    free(words);
    return good;
}

static uint64_t add_to_checksum(uint64_t checksum, const c205_word *words,
                                size_t count)
{
    for (size_t i = 0; i < count; i++)
        for (unsigned shift = 64; shift > 0; shift -= 8)
            checksum = (checksum ^ (words[i] >> (shift - 8) & 0xFF))
                       * UINT64_C(0x100000001B3);
    return checksum;
}

bool trace_checksum(const struct trace *trace, uint64_t *checksum,
                    c205_error *error)
{
    size_t pixels = trace->layout.width * trace->layout.height;
    c205_word *words = malloc(pixels * sizeof *words);

    if (words == NULL) {
        snprintf(error->message, sizeof error->message,
                 "no memory for the frame");
        return false;
    }
    *checksum = UINT64_C(0xCBF29CE484222325);
    for (int i = 0; i < FRAME_CHANNELS; i++)
        if (trace_read_words(trace, (enum frame_channel)i, words))
            *checksum = add_to_checksum(*checksum, words, pixels);
    free(words);
    return true;
}

enum falsi trace_falsi(const struct trace *trace)
{
    return falsi_of(trace->program);
}

const c205 *trace_machine(const struct trace *trace)
{
    return trace->machine;
}
