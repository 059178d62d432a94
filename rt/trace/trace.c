/* trace.c - traces a frame band by band and collects the bands. */
#include "rt/trace/trace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rt/jobs/job_set.h"
#include "rt/platform/framebuffer.h"
#include "rt/platform/threads.h"
#include "rt/trace/band_words.h"
#include "rt/trace/form.h"
#include "vm/error.h"
#include "base/fnv_hash.h"
#include "base/plural.h"

struct trace {
    struct trace_options options;
    struct object *program;
    struct scene_layout *layout;
    struct band_work work;
    double gamma; /* gamma of the frame's colours */
    double unit;  /* unit of length of the scene, in units of the scene file */
    bool gamma_off;

    size_t band_rows; /* rows in each band, except perhaps the last */
    size_t band_count;
    struct frame_planes planes; /* FRAME_CHANNELS planes; unfinished rows are zeros */
    size_t hits;
    size_t rows_done, bands_done;
    size_t rows_of_parts; /* finished rows in bands that were stopped */
    struct accounts accounts;
    uint64_t rays[RAY_KINDS];
    struct job_set alone, *job_set; /* `alone` is used if the options have no job set */

    /* During a run the lock protects all fields above that can change. */
    struct lock *lock, *watching;
    struct job *jobs;
    size_t job_count;
    bool stop;
    c205_error error; /* the reason for stopping */
};

/* The work of one thread: one band at a time. */
struct job {
    struct trace *trace;
    struct band_tracer tracer;
    size_t pixels; /* pixels of its current band that have been started */
};

/* ---- Progress --------------------------------------------------------------- */

static size_t pixels_done(const struct trace *trace)
{
    size_t done = trace->rows_done * trace->options.width;
    for (size_t i = 0; i < trace->job_count; i++)
        done += trace->jobs[i].pixels;
    return done;
}

/* Reports the progress and returns whether to continue. The caller holds the lock. */
static bool ask(struct trace *trace)
{
    const struct trace_options *options = &trace->options;
    size_t all = options->width * options->height, done = pixels_done(trace);
    if (trace->stop || !options->progress
        || options->progress(options->context, done, all))
        return !trace->stop;
    trace->stop = true;
    return error_set(&trace->error, "stopped after %zu of %zu pixel%s", done, all,
                     plural(all));
}

static bool may_continue(void *context)
{
    struct trace *trace = context;
    bool going;
    lock_take(trace->lock);
    going = ask(trace);
    lock_give_back(trace->lock);
    return going;
}

/* ---- Setup --------------------------------------------------------------- */

/* Returns the number of samples across a pixel. It is the requested number, or more if
 * the lens has more points than the pixel has rays. */
static size_t samples_across(const struct trace_options *options,
                             const struct scene *scene)
{
    const struct camera *camera = &scene->camera;
    size_t samples = options->samples > 0 ? options->samples : 1;
    if (camera->lens_radius > 0)
        while (samples * samples < (size_t)camera->lens_points)
            samples++;
    return samples;
}

/* Rejects options and cameras that cannot be combined with a threshold. */
static bool check_threshold(const struct trace_options *options,
                            const struct scene *scene, c205_error *error)
{
    const char *why = NULL;
    if (options->threshold == 0)
        return true;
    if (!(options->threshold > 0) || isinf(options->threshold))
        why = "the threshold must be finite and above 0";
    else if (scene->camera.lens_radius > 0)
        why = "a threshold cannot be combined with a camera that has a lens: all of "
              "its pixels need all samples";
    else if (options->samples < 2)
        why = "a threshold requires at least 2 samples across a pixel";
    else if (options->width > MAX_TRACE_COLUMNS)
        why = "at most 65534 columns are allowed with a threshold";
    if (why)
        error_set(error, "%s", why);
    return !why;
}

static void divide(struct trace *trace)
{
    const struct trace_options *options = &trace->options;
    size_t pixels = options->band > 0 ? options->band : TRACE_BAND;
    size_t samples = options->samples * options->samples;
    size_t least = 1;
    if (options->threshold > 0) {
        samples = 1; /* the number of samples of most pixels */
        least = TRACE_BLOCK;
    }
    trace->band_rows = pixels / (samples * options->width) / least * least;
    if (trace->band_rows < least)
        trace->band_rows = least;
    if (trace->band_rows > options->height)
        trace->band_rows = options->height;
    trace->band_count = (options->height + trace->band_rows - 1) / trace->band_rows;
}

size_t trace_band_row(const struct trace *trace, size_t band)
{
    return band * trace->band_rows;
}

static size_t rows_of(const struct trace *trace, size_t band)
{
    size_t left = trace->options.height - band * trace->band_rows;
    return left < trace->band_rows ? left : trace->band_rows;
}

c205 *trace_machine(const struct trace *trace, size_t band, c205_error *error)
{
    struct frame_layout layout;
    return band_machine(&trace->work, trace_band_row(trace, band), rows_of(trace, band),
                        &layout, error);
}

static bool lay_out_frame(struct trace *trace, const struct scene *scene,
                          c205_error *error)
{
    const struct trace_options *options = &trace->options;
    enum bounding bounding = options->no_bounds ? BOUNDING_NONE
                             : options->flat    ? BOUNDING_FLAT
                                                : BOUNDING_HIERARCHY;
    trace->work.program = trace->program = form_assemble(options, scene, error);
    trace->work.layout = trace->layout = trace->program ? layout_new(trace->program,
                                                                     scene, bounding,
                                                                     options->progress
                                                                         ? may_continue
                                                                         : NULL,
                                                                     trace, error)
                                                        : NULL;
    return trace->layout;
}

static bool prepare(struct trace *trace, const struct scene *scene, c205_error *error)
{
    size_t pixels = trace->options.width * trace->options.height;
    if (!lay_out_frame(trace, scene, error))
        return false;
    error_set(error, "out of memory for the frame");
    return framebuffer_take(&trace->planes, FRAME_CHANNELS * pixels);
}

enum trace_order trace_order(const struct trace_options *options)
{
    if (options->mode == TRACE_SCALAR)
        return ORDER_ROWS;
    if (options->order == ORDER_DEFAULT)
        return options->mode == TRACE_VECTOR ? ORDER_TILES : ORDER_ROWS;
    return options->order;
}

struct trace *trace_new(const struct scene *scene, const struct trace_options *options,
                        c205_error *error)
{
    struct trace *trace = calloc(1, sizeof *trace);
    if (!trace) {
        error_set(error, "out of memory");
        return NULL;
    }
    trace->lock = lock_new();
    trace->watching = lock_new();
    trace->options = *options;
    trace->job_set = options->job_set ? options->job_set : &trace->alone;
    trace->options.samples = samples_across(options, scene);
    trace->accounts.model = options->model;
    trace->gamma = scene->assumed_gamma > 0
                           && (trace->options.samples == 1 || options->threshold > 0)
                       ? scene->assumed_gamma
                       : 1;
    trace->unit = ldexp(1, scene->unit_log);
    trace->gamma_off = scene->gamma_off;
    trace->work = (struct band_work){
        .model = options->model,
        .width = options->width,
        .height = options->height,
        .samples = trace->options.samples,
        .threshold = options->threshold,
        .tiles = trace_order(options) == ORDER_TILES,
        .ray_by_ray = options->mode == TRACE_SCALAR,
        .rays_a_call = options->mode == TRACE_SCALAR ? 1 : options->queue,
        .observers = options->observers,
    };
    divide(trace);
    if (!trace->lock || !trace->watching)
        error_set(error, "out of memory");
    else if (check_threshold(options, scene, error) && prepare(trace, scene, error))
        return trace;
    trace_free(trace);
    return NULL;
}

void trace_free(struct trace *trace)
{
    if (!trace)
        return;
    job_set_close(trace->job_set, false);
    lock_free(trace->lock);
    lock_free(trace->watching);
    accounts_free(&trace->accounts);
    layout_free(trace->layout);
    object_free(trace->program);
    planes_give_back(&trace->planes);
    free(trace);
}

const struct trace_options *trace_how(const struct trace *trace)
{
    return &trace->options;
}

size_t trace_samples(const struct trace *trace)
{
    return trace->options.samples;
}

/* ---- Finished bands ------------------------------------------------------ */

static void copy_rows(struct trace *trace, const struct band *band)
{
    size_t width = trace->options.width, count = band->rows * width;
    size_t pixels = width * trace->options.height;
    size_t done = band->rows_done * width;
    const c205_word *ids = band->words + (size_t)CHANNEL_ID * count;
    for (int i = 0; i < FRAME_CHANNELS; i++) {
        size_t first = (size_t)i * pixels + band->first_row * width;
        memcpy(trace->planes.words + first, band->words + (size_t)i * count,
               done * sizeof *band->words);
        framebuffer_leave(&trace->planes, first, done);
    }
    for (size_t i = 0; i < done; i++)
        trace->hits += c205_to_integer(ids[i]) != 0;
}

static bool add_band(struct trace *trace, const struct band *band)
{
    if (!accounts_add_all(&trace->accounts, &band->accounts))
        return false;
    copy_rows(trace, band);
    for (int kind = 0; kind < RAY_KINDS; kind++)
        trace->rays[kind] += band->rays[kind];
    trace->rows_done += band->rows;
    trace->bands_done++;
    return true;
}

/* Adds a finished band. It was computed here or in another process. */
static bool take_band(void *context, size_t number, struct serialized_result *words,
                      c205_error *error)
{
    struct trace *trace = context;
    struct band band = { .first_row = trace_band_row(trace, number),
                         .rows = rows_of(trace, number),
                         .accounts = { .model = trace->options.model } };
    bool good;
    lock_take(trace->lock);
    good = (band_take(&band, trace->options.width, words) && add_band(trace, &band))
           || error_set(error, "out of memory");
    lock_give_back(trace->lock);
    band_free(&band);
    return good;
}

bool trace_keep(struct trace *trace, c205_error *error)
{
    c205 *machine = trace_machine(trace, 0, error);
    const uint64_t size[] = { trace->options.width, trace->options.height,
                              trace->band_rows };
    uint64_t key = machine ? job_set_key("frame", machine, size, 3) : 0;
    c205_free(machine);
    return machine && job_set_open(trace->job_set, key, error);
}

void trace_forget(struct trace *trace)
{
    job_set_close(trace->job_set, true);
}

/* ---- Jobs ---------------------------------------------------------------- */

/* Calls the callback options->look, if there is one. The caller holds the lock. */
static void look(const struct job *job, bool done)
{
    const struct trace_options *options = &job->trace->options;
    if (options->look)
        options->look(options->context, job->trace, &job->tracer, done);
}

static bool report_progress(void *context, size_t pixels)
{
    struct job *job = context;
    bool going;
    lock_take(job->trace->lock);
    job->pixels = pixels;
    going = ask(job->trace);
    if (going)
        look(job, false);
    lock_give_back(job->trace->lock);
    return going;
}

static void keep_part(struct trace *trace, const struct band *band)
{
    lock_take(trace->lock);
    if (band->rows_done > 0)
        copy_rows(trace, band);
    trace->rows_of_parts += band->rows_done;
    lock_give_back(trace->lock);
}

/* Stores the finished rows of a stopped band, and sets the error to the reason for
 * stopping, which all bands share. */
static bool end_stopped(struct trace *trace, const struct band *band, c205_error *error)
{
    keep_part(trace, band);
    *error = trace->error;
    return false;
}

static bool run_band(void *context, size_t number, size_t unit,
                     struct serialized_result *words, c205_error *error)
{
    struct trace *trace = context;
    struct job *job = &trace->jobs[number];
    struct band band = { .first_row = trace_band_row(trace, unit),
                         .rows = rows_of(trace, unit) };
    bool stopped = false;
    bool good = band_trace(&job->tracer, &band, job, &stopped, error);
    if (good)
        band_put(&band, trace->options.width, words);
    else if (stopped)
        end_stopped(trace, &band, error);
    band_free(&band);
    lock_take(trace->lock);
    if (good)
        look(job, true);
    job->pixels = 0;
    lock_give_back(trace->lock);
    return good;
}

static bool watch(void *context, size_t done, c205_error *error)
{
    struct trace *trace = context;
    (void)done;
    if (may_continue(trace))
        return true;
    *error = trace->error;
    return false;
}

static bool begin_jobs(struct trace *trace)
{
    size_t jobs = trace->options.jobs > 0 ? trace->options.jobs : 1;
    trace->job_count = jobs < trace->band_count ? jobs : trace->band_count;
    trace->jobs = calloc(trace->job_count, sizeof *trace->jobs);
    for (size_t i = 0; trace->jobs && i < trace->job_count; i++)
        trace->jobs[i] = (struct job){
            .trace = trace, .tracer = { .work = &trace->work, .lock = trace->watching }
        };
    return trace->jobs;
}

static void end_jobs(struct trace *trace)
{
    for (size_t i = 0; i < trace->job_count; i++)
        c205_free(trace->jobs[i].tracer.machine);
    free(trace->jobs);
    trace->jobs = NULL;
    trace->job_count = 0;
}

bool trace_run(struct trace *trace, c205_error *error)
{
    const struct trace_options *options = &trace->options;
    const struct job_set_work work = { .job_set = trace->job_set,
                                       .count = trace->band_count,
                                       .jobs = options->jobs,
                                       .run = run_band,
                                       .take = take_band,
                                       .go_on = options->progress ? watch : NULL,
                                       .context = trace };
    bool good;
    if (!begin_jobs(trace))
        return error_set(error, "out of memory");
    trace->work.progress = options->progress ? report_progress : NULL;
    good = job_set_run(&work, error);
    end_jobs(trace);
    if (good && options->progress)
        options->progress(options->context, options->width * options->height,
                          options->width * options->height);
    return good;
}

/* ---- Results ------------------------------------------------------------- */

static size_t pixels_of(const struct trace *trace)
{
    return trace->options.width * trace->options.height;
}

const c205_word *trace_channel(const struct trace *trace, enum frame_channel channel)
{
    return trace->planes.words + (size_t)channel * pixels_of(trace);
}

size_t trace_hits(const struct trace *trace)
{
    return trace->hits;
}

static void make_linear(double *samples, size_t count, double gamma)
{
    for (size_t i = 0; i < count && gamma != 1; i++)
        samples[i] = samples[i] > 0 ? pow(samples[i], gamma) : 0;
}

static void read_channel(const struct trace *trace, int channel, const c205_word *words,
                         struct frame *part)
{
    size_t pixels = part->height * trace->options.width;
    double *samples = part->channel[channel];
    for (size_t i = 0; i < pixels; i++)
        samples[i] = c205_to_double(words[i]);
    if (channel <= CHANNEL_BLUE)
        make_linear(samples, pixels, trace->gamma);
    for (size_t i = 0; channel == CHANNEL_DEPTH && i < pixels; i++)
        samples[i] *= trace->unit;
}

void trace_read(const struct trace *trace, size_t first_row, struct frame *part)
{
    size_t width = trace->options.width;
    part->gamma_off = trace->gamma_off;
    for (int i = 0; i < FRAME_CHANNELS; i++) {
        size_t first = (size_t)i * pixels_of(trace) + first_row * width;
        read_channel(trace, i, trace->planes.words + first, part);
        framebuffer_leave(&trace->planes, first, part->height * width);
    }
}

void trace_read_band(const struct trace *trace, const struct band *band,
                     struct frame *part)
{
    size_t pixels = band->rows * trace->options.width;
    part->gamma_off = trace->gamma_off;
    for (int i = 0; i < FRAME_CHANNELS; i++)
        read_channel(trace, i, band->words + (size_t)i * pixels, part);
}

uint64_t trace_checksum(const struct trace *trace)
{
    enum { AT_A_TIME = 1 << 17 };
    size_t words = FRAME_CHANNELS * pixels_of(trace);
    uint64_t checksum = HASH_START;
    for (size_t i = 0; i < words; i += AT_A_TIME) {
        size_t count = words - i < AT_A_TIME ? words - i : AT_A_TIME;
        checksum = hash_words(checksum, trace->planes.words + i, count);
        framebuffer_leave(&trace->planes, i, count);
    }
    return checksum;
}

size_t trace_bands(const struct trace *trace)
{
    return trace->band_count;
}

size_t trace_bands_done(const struct trace *trace)
{
    return trace->bands_done;
}

size_t trace_rows_done(const struct trace *trace)
{
    return trace->rows_done + trace->rows_of_parts;
}

const struct accounts *trace_accounts(const struct trace *trace)
{
    return &trace->accounts;
}

uint64_t trace_rays(const struct trace *trace, enum ray_kind kind)
{
    return trace->rays[kind];
}

const struct object *trace_program(const struct trace *trace)
{
    return trace->program;
}
