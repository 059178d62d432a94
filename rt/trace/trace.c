#include "rt/trace/trace.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "rt/trace/band_file.h"
#include "rt/trace/form.h"
#include "rt/trace/planes.h"
#include "base/hash.h"

struct trace {
    struct trace_options options;
    struct object *program;
    struct scene_layout *layout;
    struct band_work work;
    double gamma; /* of the frame's colours */

    size_t band_rows; /* of each band but perhaps the last */
    size_t band_count;
    bool *taken;                /* bands that are done or being done */
    struct frame_planes planes; /* FRAME_CHANNELS, as far as they are done */
    size_t hits;
    size_t rows_done, bands_done;
    size_t rows_of_parts; /* done, of bands that were stopped */
    struct accounts accounts;
    uint64_t rays[RAY_KINDS];
    struct band_file *file; /* that keeps the bands, or NULL */

    /* While it runs, all of the above that changes is under the lock. */
    pthread_mutex_t lock, watching;
    struct job *jobs;
    size_t job_count;
    bool stop;
    c205_error error; /* why it stopped */
};

/* One thread's work: a band at a time. */
struct job {
    struct trace *trace;
    pthread_t thread;
    size_t pixels; /* of its band that are begun */
};

/* ---- Whether to go on ---------------------------------------------------- */

static void stop_with(struct trace *trace, const c205_error *why)
{
    if (!trace->stop)
        trace->error = *why;
    trace->stop = true;
}

static size_t pixels_done(const struct trace *trace)
{
    size_t done = trace->rows_done * trace->options.width;

    for (size_t i = 0; i < trace->job_count; i++)
        done += trace->jobs[i].pixels;
    return done;
}

/* Whether to go on, of whoever follows the progress; under the lock. */
static bool ask(struct trace *trace)
{
    const struct trace_options *options = &trace->options;
    size_t all = options->width * options->height, done = pixels_done(trace);
    c205_error why;

    if (trace->stop || !options->progress
        || options->progress(options->context, done, all))
        return !trace->stop;
    snprintf(why.message, sizeof why.message,
             "stopped after %zu of %zu pixels", done, all);
    stop_with(trace, &why);
    return false;
}

static bool go_on(void *context)
{
    struct trace *trace = context;
    bool going;

    pthread_mutex_lock(&trace->lock);
    going = ask(trace);
    pthread_mutex_unlock(&trace->lock);
    return going;
}

/* ---- To begin ------------------------------------------------------------ */

/* As many as are asked for, and one for each point of a lens at the least. */
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

/* What a threshold does not go with. */
static bool check_threshold(const struct trace_options *options,
                            const struct scene *scene, c205_error *error)
{
    const char *why = NULL;

    if (options->threshold == 0)
        return true;
    if (!(options->threshold > 0) || isinf(options->threshold))
        why = "a threshold is a number above 0";
    else if (scene->camera.lens_radius > 0)
        why = "a threshold does not go with a camera that has a lens: all of "
              "its pixels need their samples";
    else if (options->samples < 2)
        why = "a threshold needs samples, 2 across a pixel at the least";
    else if (options->width > TRACE_COLUMNS_MOST)
        why = "with a threshold a frame has 65534 columns at the most";
    if (why)
        snprintf(error->message, sizeof error->message, "%s", why);
    return !why;
}

static void divide(struct trace *trace)
{
    const struct trace_options *options = &trace->options;
    size_t pixels = options->band > 0 ? options->band : TRACE_BAND;
    size_t samples = options->samples * options->samples;
    size_t least = 1;

    if (options->threshold > 0) {
        samples = 1; /* of most pixels */
        least = TRACE_BLOCK;
    }
    trace->band_rows = pixels / (samples * options->width) / least * least;
    if (trace->band_rows < least)
        trace->band_rows = least;
    if (trace->band_rows > options->height)
        trace->band_rows = options->height;
    trace->band_count = (options->height + trace->band_rows - 1)
                        / trace->band_rows;
}

static size_t rows_of(const struct trace *trace, size_t band)
{
    size_t left = trace->options.height - band * trace->band_rows;

    return left < trace->band_rows ? left : trace->band_rows;
}

c205 *trace_machine(const struct trace *trace, c205_error *error)
{
    struct frame_layout layout;

    return band_machine(&trace->work, 0, rows_of(trace, 0), &layout, error);
}

static bool lay_out(struct trace *trace, const struct scene *scene,
                    c205_error *error)
{
    const struct trace_options *options = &trace->options;
    enum bounding bounding = options->no_bounds ? BOUNDING_NONE
                             : options->flat    ? BOUNDING_FLAT
                                                : BOUNDING_HIERARCHY;

    trace->work.program = trace->program = form_assemble(options, scene,
                                                         error);
    trace->work.layout = trace->layout = trace->program
                                             ? layout_new(trace->program,
                                                          scene, bounding,
                                                          options->progress
                                                              ? go_on
                                                              : NULL,
                                                          trace, error)
                                             : NULL;
    return trace->layout;
}

static bool prepare(struct trace *trace, const struct scene *scene,
                    c205_error *error)
{
    size_t pixels = trace->options.width * trace->options.height;

    if (!lay_out(trace, scene, error))
        return false;
    snprintf(error->message, sizeof error->message,
             "no memory for the frame");
    trace->taken = calloc(trace->band_count, sizeof *trace->taken);
    return trace->taken
           && planes_take(&trace->planes, FRAME_CHANNELS * pixels);
}

enum trace_order trace_order(const struct trace_options *options)
{
    if (options->mode == TRACE_SCALAR)
        return ORDER_ROWS;
    if (options->order == ORDER_DEFAULT)
        return options->mode == TRACE_VECTOR ? ORDER_TILES : ORDER_ROWS;
    return options->order;
}

struct trace *trace_new(const struct scene *scene,
                        const struct trace_options *options,
                        c205_error *error)
{
    struct trace *trace = calloc(1, sizeof *trace);

    if (!trace) {
        snprintf(error->message, sizeof error->message, "no memory");
        return NULL;
    }
    pthread_mutex_init(&trace->lock, NULL);
    pthread_mutex_init(&trace->watching, NULL);
    trace->options = *options;
    trace->options.samples = samples_across(options, scene);
    trace->accounts.model = options->model;
    trace->gamma = scene->assumed_gamma > 0
                           && (trace->options.samples == 1
                               || options->threshold > 0)
                       ? scene->assumed_gamma
                       : 1;
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
    if (check_threshold(options, scene, error)
        && prepare(trace, scene, error))
        return trace;
    trace_free(trace);
    return NULL;
}

void trace_free(struct trace *trace)
{
    if (!trace)
        return;
    band_file_close(trace->file, false);
    pthread_mutex_destroy(&trace->lock);
    pthread_mutex_destroy(&trace->watching);
    accounts_free(&trace->accounts);
    layout_free(trace->layout);
    object_free(trace->program);
    free(trace->taken);
    planes_give_back(&trace->planes);
    free(trace);
}

size_t trace_samples(const struct trace *trace)
{
    return trace->options.samples;
}

/* ---- Bands that are done ------------------------------------------------- */

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
        planes_leave(&trace->planes, first, done);
    }
    for (size_t i = 0; i < done; i++)
        trace->hits += c205_to_integer(ids[i]) != 0;
}

static bool add_band(struct trace *trace, const struct band *band)
{
    copy_rows(trace, band);
    if (!accounts_add_all(&trace->accounts, &band->accounts))
        return false;
    for (int kind = 0; kind < RAY_KINDS; kind++)
        trace->rays[kind] += band->rays[kind];
    trace->rows_done += band->rows;
    trace->bands_done++;
    return true;
}

/* A band from the file, if it is one of this trace's. */
static bool add_kept(void *context, const struct band *band)
{
    struct trace *trace = context;
    size_t i = band->first_row / trace->band_rows;

    if (i >= trace->band_count || trace->taken[i]
        || band->first_row != i * trace->band_rows
        || band->rows != rows_of(trace, i))
        return true;
    trace->taken[i] = true;
    return add_band(trace, band);
}

bool trace_keep(struct trace *trace, const char *path, c205_error *error)
{
    c205 *machine = trace_machine(trace, error);
    uint64_t key = machine ? band_file_key(machine) : 0;

    c205_free(machine);
    if (!machine)
        return false;
    trace->file = band_file_open(path, key, trace->options.width,
                                 trace->options.model, add_kept, trace,
                                 error);
    return trace->file != NULL;
}

void trace_forget(struct trace *trace)
{
    band_file_close(trace->file, true);
    trace->file = NULL;
}

/* ---- Jobs ---------------------------------------------------------------- */

static bool tell_progress(void *context, size_t pixels)
{
    struct job *job = context;
    bool going;

    pthread_mutex_lock(&job->trace->lock);
    job->pixels = pixels;
    going = ask(job->trace);
    pthread_mutex_unlock(&job->trace->lock);
    return going;
}

static bool take_next(struct trace *trace, struct band *band)
{
    bool found = false;

    pthread_mutex_lock(&trace->lock);
    for (size_t i = 0; i < trace->band_count && !found && !trace->stop; i++)
        if (!trace->taken[i]) {
            found = trace->taken[i] = true;
            *band = (struct band){ .first_row = i * trace->band_rows,
                                   .rows = rows_of(trace, i) };
        }
    pthread_mutex_unlock(&trace->lock);
    return found;
}

static void finish_band(struct job *job, const struct band *band)
{
    struct trace *trace = job->trace;
    c205_error why = { "no memory" };

    pthread_mutex_lock(&trace->lock);
    job->pixels = 0;
    if (!add_band(trace, band)
        || (trace->file && !band_file_add(trace->file, band, &why)))
        stop_with(trace, &why);
    pthread_mutex_unlock(&trace->lock);
}

static void keep_part(struct trace *trace, const struct band *band)
{
    pthread_mutex_lock(&trace->lock);
    if (band->rows_done > 0)
        copy_rows(trace, band);
    trace->rows_of_parts += band->rows_done;
    pthread_mutex_unlock(&trace->lock);
}

static void *do_job(void *context)
{
    struct job *job = context;
    struct trace *trace = job->trace;
    struct band_tracer tracer = { .work = &trace->work,
                                  .lock = &trace->watching };
    struct band band;

    while (take_next(trace, &band)) {
        bool stopped = false;
        c205_error why;

        if (band_trace(&tracer, &band, job, &stopped, &why)) {
            finish_band(job, &band);
        } else if (stopped) {
            keep_part(trace, &band);
        } else {
            pthread_mutex_lock(&trace->lock);
            stop_with(trace, &why);
            pthread_mutex_unlock(&trace->lock);
        }
        band_free(&band);
    }
    c205_free(tracer.machine);
    return NULL;
}

/* The first job is this thread's own. */
static void do_jobs(struct trace *trace)
{
    size_t begun = 1;

    while (begun < trace->job_count
           && pthread_create(&trace->jobs[begun].thread, NULL, do_job,
                             &trace->jobs[begun])
                  == 0)
        begun++;
    do_job(&trace->jobs[0]);
    for (size_t i = 1; i < begun; i++)
        pthread_join(trace->jobs[i].thread, NULL);
}

bool trace_run(struct trace *trace, c205_error *error)
{
    const struct trace_options *options = &trace->options;
    size_t jobs = options->jobs > 0 ? options->jobs : 1;

    trace->job_count = jobs < trace->band_count ? jobs : trace->band_count;
    trace->jobs = calloc(trace->job_count, sizeof *trace->jobs);
    snprintf(error->message, sizeof error->message, "no memory");
    if (!trace->jobs)
        return false;
    for (size_t i = 0; i < trace->job_count; i++)
        trace->jobs[i].trace = trace;
    trace->work.progress = options->progress ? tell_progress : NULL;
    do_jobs(trace);
    free(trace->jobs);
    trace->jobs = NULL;
    trace->job_count = 0;
    if (trace->stop)
        *error = trace->error;
    else if (options->progress)
        options->progress(options->context, options->width * options->height,
                          options->width * options->height);
    return !trace->stop;
}

/* ---- What came of it ----------------------------------------------------- */

static size_t pixels_of(const struct trace *trace)
{
    return trace->options.width * trace->options.height;
}

const c205_word *trace_channel(const struct trace *trace,
                               enum frame_channel channel)
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

void trace_read(const struct trace *trace, size_t first_row,
                struct frame *part)
{
    size_t width = trace->options.width, pixels = part->height * width;

    for (int i = 0; i < FRAME_CHANNELS; i++) {
        size_t first = (size_t)i * pixels_of(trace) + first_row * width;
        const c205_word *words = trace->planes.words + first;

        for (size_t k = 0; k < pixels; k++)
            part->channel[i][k] = c205_to_double(words[k]);
        planes_leave(&trace->planes, first, pixels);
        if (i <= CHANNEL_BLUE)
            make_linear(part->channel[i], pixels, trace->gamma);
    }
}

uint64_t trace_checksum(const struct trace *trace)
{
    enum { AT_A_TIME = 1 << 17 };
    size_t words = FRAME_CHANNELS * pixels_of(trace);
    uint64_t checksum = HASH_START;

    for (size_t i = 0; i < words; i += AT_A_TIME) {
        size_t count = words - i < AT_A_TIME ? words - i : AT_A_TIME;

        checksum = hash_words(checksum, trace->planes.words + i, count);
        planes_leave(&trace->planes, i, count);
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
