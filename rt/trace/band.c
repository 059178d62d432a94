/* band.c - traces one band of a frame on a machine. */
#include "rt/trace/band.h"

#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "rt/platform/threads.h"
#include "rt/layout/program.h"

static const struct {
    const char *name, *counter; /* a symbol in the program's data */
} kinds[RAY_KINDS] = {
    [RAY_PRIMARY] = { "primary", "rays_primary" },
    [RAY_REFLECTED] = { "reflected", "rays_reflected" },
    [RAY_REFRACTED] = { "refracted", "rays_refracted" },
    [RAY_SHADOW] = { "shadow", "rays_shadow" },
};

const char *ray_kind_name(enum ray_kind kind)
{
    return kinds[kind].name;
}

static bool load_band(const struct band_work *work, c205 *machine, size_t first_row,
                      size_t rows, struct frame_layout *layout, c205_error *error)
{
    *layout = (struct frame_layout){ .width = work->width,
                                     .height = work->height,
                                     .first_row = first_row,
                                     .samples = work->samples,
                                     .threshold = work->threshold,
                                     .rows = rows,
                                     .tiles = work->tiles };
    return c205_load(machine, &work->program->program, error)
           && layout_put(work->layout, machine, layout, error);
}

c205 *band_machine(const struct band_work *work, size_t first_row, size_t rows,
                   struct frame_layout *layout, c205_error *error)
{
    c205 *machine = c205_new(work->model, error);
    if (machine && load_band(work, machine, first_row, rows, layout, error))
        return machine;
    c205_free(machine);
    return NULL;
}

/* Returns how often the machine has called the routine that makes rays. */
static size_t calls_begun(const c205 *machine)
{
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        const c205_account *account = c205_account_at(machine, i);
        if (strcmp(account->name, "generate") == 0)
            return (size_t)account->entries;
    }
    return 0;
}

static size_t pixels_begun(const struct band_work *work, const c205 *machine,
                           size_t pixels)
{
    size_t samples = work->samples > 0 && work->threshold == 0 ? work->samples : 1;
    size_t done = calls_begun(machine) * work->rays_a_call / (samples * samples);
    return done < pixels ? done : pixels;
}

struct reporting {
    const struct band_work *work;
    size_t pixels;
    void *context;
};

static bool report_pixels(void *context, const c205 *machine)
{
    const struct reporting *reporting = context;
    const struct band_work *work = reporting->work;
    return work->progress(reporting->context,
                          pixels_begun(work, machine, reporting->pixels));
}

static bool run_band(const struct band_work *work, c205 *machine, size_t pixels,
                     void *context, bool *stopped, c205_error *error)
{
    struct reporting reporting = { work, pixels, context };
    return program_run(machine, work->progress ? report_pixels : NULL, &reporting,
                       stopped, error);
}

static void listen_band(void *context, const c205 *machine, const c205_event *event)
{
    const struct band_watch *watch = context;
    watch->observer->listen(watch->band, machine, event);
}

/* Attaches all observers of the work to the machine. */
static bool listen(struct band_tracer *tracer, c205_error *error)
{
    const struct observer *const *observers = tracer->work->observers;
    for (; observers && *observers; observers++) {
        struct band_watch *watch = &tracer->watches[tracer->watch_count];
        if (tracer->watch_count == MAX_BAND_OBSERVERS
            || !c205_listen(tracer->machine, listen_band, watch))
            return error_set(error, "more than %d observers", MAX_BAND_OBSERVERS);
        watch->observer = *observers;
        tracer->watch_count++;
    }
    return true;
}

static bool begin_watches(struct band_tracer *tracer, c205_error *error)
{
    bool good = true;
    lock_take(tracer->lock);
    for (size_t i = 0; i < tracer->watch_count; i++) {
        struct band_watch *watch = &tracer->watches[i];
        watch->band = good ? watch->observer->begin(watch->observer->context,
                                                    tracer->work->program, error)
                           : NULL;
        good = watch->band;
    }
    lock_give_back(tracer->lock);
    return good;
}

static void end_watches(struct band_tracer *tracer, bool merge)
{
    lock_take(tracer->lock);
    for (size_t i = 0; i < tracer->watch_count; i++) {
        const struct band_watch *watch = &tracer->watches[i];
        if (merge)
            watch->observer->merge(watch->observer->context, watch->band);
        if (watch->band)
            watch->observer->end(watch->band);
    }
    lock_give_back(tracer->lock);
}

static bool read_integer(const struct band_work *work, const c205 *machine,
                         const char *name, uint64_t *value)
{
    const struct asm_symbol *symbol = object_symbol(work->program, name);
    c205_word word;
    if (!symbol || !c205_read(machine, (uint64_t)symbol->value, &word, 1))
        return false;
    *value = (uint64_t)c205_to_integer(word);
    return true;
}

static bool read_counters(const struct band_work *work, const c205 *machine,
                          struct band *band)
{
    for (int i = 0; i < RAY_KINDS; i++)
        if (!read_integer(work, machine, kinds[i].counter, &band->rays[i]))
            return false;
    return true;
}

/* Returns the number of rows whose pixels are all final. The program generates rays in
 * several calls, and the pixels of a call are final when the next call starts. No row
 * counts as final before the end of the band if pixels have several samples, or if
 * reflected rays may wait in queues. With tiles the program counts the rows itself. */
static size_t rows_done(const struct band_work *work, const c205 *machine, size_t rows)
{
    size_t calls = calls_begun(machine), done;
    uint64_t levels = 0, above = 0;
    if (calls == 0 || work->samples > 1
        || !read_integer(work, machine, "scene_level_count", &levels)
        || (levels > 1 && !work->ray_by_ray))
        return 0;
    if (work->tiles)
        return read_integer(work, machine, "strips_done", &above) ? (size_t)above : 0;
    done = (calls - 1) * work->rays_a_call / work->width;
    return done < rows ? done : rows;
}

static bool read_frame(const struct band_work *work, const c205 *machine,
                       const struct frame_layout *layout, struct band *band)
{
    size_t count = FRAME_CHANNELS * band->rows * work->width;
    band->words = malloc(count * sizeof *band->words);
    return band->words && c205_read(machine, layout->address, band->words, count);
}

static bool collect(const struct band_work *work, const c205 *machine,
                    const struct frame_layout *layout, struct band *band,
                    c205_error *error)
{
    error_set(error, "out of memory");
    band->accounts.model = work->model;
    band->rows_done = band->rows;
    return read_frame(work, machine, layout, band) && read_counters(work, machine, band)
           && accounts_add(&band->accounts, machine);
}

/* Collects the finished rows of a stopped band. If out of memory, it collects none. */
static void collect_rows(const struct band_work *work, const c205 *machine,
                         const struct frame_layout *layout, struct band *band)
{
    band->rows_done = rows_done(work, machine, band->rows);
    if (!read_frame(work, machine, layout, band))
        band->rows_done = 0;
}

/* Creates the tracer's machine, with its observers, before the first band. Later bands
 * run on the same machine. */
static bool ready(struct band_tracer *tracer, c205_error *error)
{
    if (tracer->machine)
        return true;
    tracer->machine = c205_new(tracer->work->model, error);
    return tracer->machine && listen(tracer, error);
}

bool band_trace(struct band_tracer *tracer, struct band *band, void *progress_context,
                bool *stopped, c205_error *error)
{
    const struct band_work *work = tracer->work;
    struct frame_layout *layout = &tracer->layout;
    bool good;
    good = ready(tracer, error) && begin_watches(tracer, error)
           && load_band(work, tracer->machine, band->first_row, band->rows, layout,
                        error)
           && run_band(work, tracer->machine, band->rows * work->width,
                       progress_context, stopped, error)
           && collect(work, tracer->machine, layout, band, error);
    end_watches(tracer, good);
    if (*stopped)
        collect_rows(work, tracer->machine, layout, band);
    else if (!good)
        band_free(band);
    return good;
}

bool band_look(const struct band_tracer *tracer, struct band *band)
{
    const struct frame_layout *layout = &tracer->layout;
    c205_error error;
    *band = (struct band){ .first_row = layout->first_row, .rows = layout->rows };
    if (collect(tracer->work, tracer->machine, layout, band, &error))
        return true;
    band_free(band);
    return false;
}

void band_free(struct band *band)
{
    free(band->words);
    band->words = NULL;
    accounts_free(&band->accounts);
}
