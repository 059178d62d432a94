#include "rt/view/pixel_clocks.h"

#include <string.h>

#include "base/error.h"
#include "rt/layout/program.h"
#include "rt/view/pixel_rays.h"

/* Who listens to the band's machine until all that is asked has been heard. */
struct hearing {
    const struct frame_pixel *pixel;
    struct clock_stretch stretch;
    bool here, done;
    /* Where the program begins with a queue, has its rays, and is done with it. */
    uint64_t begin, made, end;
    const char *region;          /* that is waited for */
    struct clock_stretch within; /* in these clocks */
};

static void hear_queue(void *context, const c205 *machine, const c205_event *event)
{
    struct hearing *hearing = context;

    if (!event->record || hearing->done)
        return;
    if (hearing->here
        && (event->pc == hearing->end || event->kind == C205_EVENT_STOP)) {
        hearing->stretch.to = event->record->arrived;
        hearing->done = true;
    } else if (event->pc == hearing->begin) {
        hearing->stretch.from = event->record->arrived;
    } else if (event->pc == hearing->made) {
        hearing->here = pixel_is_in_queue(hearing->pixel, machine);
    }
}

static void hear_region(void *context, const c205 *machine, const c205_event *event)
{
    struct hearing *hearing = context;
    const struct clock_stretch *within = &hearing->within;
    uint64_t arrived;
    bool there;

    if (!event->record || hearing->done || event->record->arrived < within->from)
        return;
    arrived = event->record->arrived;
    there = arrived < within->to && event->kind != C205_EVENT_STOP
            && strcmp(c205_account_at(machine, event->region)->name, hearing->region)
                   == 0;
    if (there && !hearing->here)
        hearing->stretch.from = arrived;
    if (!there && hearing->here)
        hearing->stretch.to = arrived < within->to ? arrived : within->to;
    hearing->done = arrived >= within->to || (hearing->here && !there);
    hearing->here = there;
}

static bool go_on(void *context, const c205 *machine)
{
    const struct hearing *hearing = context;
    const struct trace_options *how = trace_how(hearing->pixel->trace);

    (void)machine;
    return !hearing->done
           && (!how->progress
               || how->progress(how->context, 0, how->width * how->height));
}

/* The band from its beginning, as far as that takes. */
static bool hear(struct hearing *hearing, c205_listener *listen, c205_error *error)
{
    const struct frame_pixel *pixel = hearing->pixel;
    c205 *machine = trace_machine(pixel->trace, pixel->band, error);
    bool stopped = false, good;

    if (!machine)
        return false;
    good = (c205_listen(machine, listen, hearing)
            && program_run(machine, go_on, hearing, &stopped, error))
           || hearing->done;
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
    struct hearing hearing = {
        .pixel = pixel,
        .begin = label(pixel, serial ? "frame_pixel" : "first_queue"),
        .made = label(pixel, pixel_made_label(pixel)),
        .end = label(pixel, serial ? "frame_pixel" : "levels_next"),
    };

    if (!hear(&hearing, hear_queue, error))
        return false;
    *stretch = hearing.stretch;
    return true;
}

bool pixel_region_clocks(const struct frame_pixel *pixel, const char *region,
                         struct clock_stretch *stretch, c205_error *error)
{
    struct hearing hearing = { .pixel = pixel, .region = region, .within = *stretch };

    if (!hear(&hearing, hear_region, error))
        return false;
    if (hearing.stretch.to == 0)
        return error_set(error,
                         "control is not in the region %.60s between clocks "
                         "%llu and %llu",
                         region, (unsigned long long)stretch->from,
                         (unsigned long long)stretch->to);
    *stretch = hearing.stretch;
    return true;
}
