/* pixel_clocks.c - finds the clocks in which a pixel's queue is traced. */
#include "rt/view/pixel_clocks.h"

#include <string.h>

#include "vm/error.h"
#include "rt/layout/program.h"
#include "rt/view/pixel_rays.h"

/* The state of a listener that searches for a range of clocks of the band's machine. It
 * sets `done` at the end of the search. */
struct recording {
    const struct frame_pixel *pixel;
    struct clock_stretch stretch;
    bool here, done;
    /* The addresses at which the program starts a queue, at which it has generated the
     * rays, and at which it has finished the queue. */
    uint64_t begin, made, end;
    const char *region;          /* the region to search for */
    struct clock_stretch within; /* the clocks in which to search */
};

static void record_queue(void *context, const c205 *machine, const c205_event *event)
{
    struct recording *recording = context;
    if (!event->record || recording->done)
        return;
    if (recording->here
        && (event->pc == recording->end || event->kind == C205_EVENT_STOP)) {
        recording->stretch.to = event->record->arrived;
        recording->done = true;
    } else if (event->pc == recording->begin) {
        recording->stretch.from = event->record->arrived;
    } else if (event->pc == recording->made) {
        recording->here = pixel_is_in_queue(recording->pixel, machine);
    }
}

static void record_region(void *context, const c205 *machine, const c205_event *event)
{
    struct recording *recording = context;
    const struct clock_stretch *within = &recording->within;
    uint64_t arrived;
    bool there;
    if (!event->record || recording->done || event->record->arrived < within->from)
        return;
    arrived = event->record->arrived;
    there = arrived < within->to && event->kind != C205_EVENT_STOP
            && strcmp(c205_account_at(machine, event->region)->name, recording->region)
                   == 0;
    if (there && !recording->here)
        recording->stretch.from = arrived;
    if (!there && recording->here)
        recording->stretch.to = arrived < within->to ? arrived : within->to;
    recording->done = arrived >= within->to || (recording->here && !there);
    recording->here = there;
}

static bool may_continue(void *context, const c205 *machine)
{
    const struct recording *recording = context;
    const struct trace_options *how = trace_how(recording->pixel->trace);
    (void)machine;
    return !recording->done
           && (!how->progress
               || how->progress(how->context, 0, how->width * how->height));
}

/* Runs the program of the pixel's band from its start. Stops when the listener has
 * stored the range of clocks in `recording` and set recording->done, or when the program
 * ends. Returns false after an error. */
static bool on_event(struct recording *recording, c205_listener *listen,
                     c205_error *error)
{
    const struct frame_pixel *pixel = recording->pixel;
    c205 *machine = trace_machine(pixel->trace, pixel->band, error);
    bool stopped = false, good;
    if (!machine)
        return false;
    good = (c205_listen(machine, listen, recording)
            && program_run(machine, may_continue, recording, &stopped, error))
           || recording->done;
    c205_free(machine);
    return good || (stopped ? error_set(error, "stopped") : false);
}

static uint64_t label(const struct frame_pixel *pixel, const char *name)
{
    return (uint64_t)object_symbol(trace_program(pixel->trace), name)->value;
}

bool pixel_queue_clocks(const struct frame_pixel *pixel, struct clock_stretch *stretch,
                        c205_error *error)
{
    bool serial = trace_how(pixel->trace)->mode == TRACE_SCALAR;
    struct recording recording = {
        .pixel = pixel,
        .begin = label(pixel, serial ? "frame_pixel" : "first_queue"),
        .made = label(pixel, pixel_made_label(pixel)),
        .end = label(pixel, serial ? "frame_pixel" : "levels_next"),
    };
    if (!on_event(&recording, record_queue, error))
        return false;
    *stretch = recording.stretch;
    return true;
}

bool pixel_region_clocks(const struct frame_pixel *pixel, const char *region,
                         struct clock_stretch *stretch, c205_error *error)
{
    struct recording recording = { .pixel = pixel,
                                   .region = region,
                                   .within = *stretch };
    if (!on_event(&recording, record_region, error))
        return false;
    if (recording.stretch.to == 0)
        return error_set(error,
                         "the region %.60s does not run between clocks %llu and %llu",
                         region, (unsigned long long)stretch->from,
                         (unsigned long long)stretch->to);
    *stretch = recording.stretch;
    return true;
}
