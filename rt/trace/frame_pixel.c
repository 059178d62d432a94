#include "rt/trace/frame_pixel.h"

#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "rt/layout/program.h"

bool frame_pixel_find(struct frame_pixel *pixel, const struct trace *trace,
                      size_t x, size_t y, c205_error *error)
{
    const struct trace_options *how = trace_how(trace);
    size_t band = 0;

    if (how->samples > 1)
        return error_say(error,
                         "a pixel of this frame has %zu x %zu rays: only one "
                         "alone is followed",
                         how->samples, how->samples);
    while (trace_band_row(trace, band + 1) <= y)
        band++;
    *pixel = (struct frame_pixel){
        trace, x, y, band, (y - trace_band_row(trace, band)) * how->width + x
    };
    return true;
}

/* ---- What the program has in its memory ----------------------------------- */

static uint64_t address_of(const struct frame_pixel *pixel, const char *name)
{
    return (uint64_t)object_symbol(trace_program(pixel->trace), name)->value;
}

static c205_word word_at(const c205 *machine, uint64_t address)
{
    c205_word word = 0;

    c205_read(machine, address, &word, 1);
    return word;
}

static c205_word word_of(const struct frame_pixel *pixel, const c205 *machine,
                         const char *name)
{
    return word_at(machine, address_of(pixel, name));
}

/* The address of a descriptor. */
static uint64_t at_of(c205_word descriptor)
{
    return descriptor & UINT64_C(0xFFFFFFFFFFFF);
}

/* The serial form goes pixel by pixel: column and row, as numbers. */
static bool is_at(const struct frame_pixel *pixel, const c205 *machine)
{
    uint64_t at = address_of(pixel, "pixel");

    return word_at(machine, at) == c205_from_double((double)pixel->x)
           && word_at(machine, at + 64) == c205_from_double((double)pixel->y);
}

/* Of a queue by tiles: the pixels' places in the planes, one after the other. */
static bool is_among(const struct frame_pixel *pixel, const c205 *machine,
                     uint64_t places, size_t count)
{
    for (size_t i = 0; i < count; i++, places += 64)
        if (c205_to_integer(word_at(machine, places))
            == (int64_t)pixel->place)
            return true;
    return false;
}

bool frame_pixel_is_in_queue(const struct frame_pixel *pixel,
                             const c205 *machine)
{
    enum { LEVEL_POSITION = 64 };
    c205_word importance, order;
    size_t count, first;

    if (trace_how(pixel->trace)->mode == TRACE_SCALAR)
        return is_at(pixel, machine);
    importance = word_of(pixel, machine, "queue_importance");
    order = word_of(pixel, machine, "queue_order");
    count = (size_t)(importance >> 48);
    if (at_of(importance) != address_of(pixel, "importance_one"))
        return false;
    if (order != 0)
        return is_among(pixel, machine, at_of(order), count);
    first = (size_t)c205_to_integer(
        word_at(machine,
                word_of(pixel, machine, "scene_levels") + LEVEL_POSITION));
    return pixel->place >= first && pixel->place - first < count;
}

/* ---- When ------------------------------------------------------------------ */

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

static void hear_queue(void *context, const c205 *machine,
                       const c205_event *event)
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
        hearing->here = frame_pixel_is_in_queue(hearing->pixel, machine);
    }
}

static void hear_region(void *context, const c205 *machine,
                        const c205_event *event)
{
    struct hearing *hearing = context;
    const struct clock_stretch *within = &hearing->within;
    uint64_t arrived;
    bool there;

    if (!event->record || hearing->done
        || event->record->arrived < within->from)
        return;
    arrived = event->record->arrived;
    there = arrived < within->to && event->kind != C205_EVENT_STOP
            && strcmp(c205_account_at(machine, event->region)->name,
                      hearing->region)
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
static bool hear(struct hearing *hearing, c205_listener *listen,
                 c205_error *error)
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
    return good || (stopped ? error_say(error, "stopped") : false);
}

bool frame_pixel_queue(const struct frame_pixel *pixel,
                       struct clock_stretch *stretch, c205_error *error)
{
    bool serial = trace_how(pixel->trace)->mode == TRACE_SCALAR;
    struct hearing hearing = {
        .pixel = pixel,
        .begin = address_of(pixel, serial ? "frame_pixel" : "first_queue"),
        .made = address_of(pixel, serial ? "trace" : "find_nearest"),
        .end = address_of(pixel, serial ? "frame_pixel" : "levels_next"),
    };

    if (!hear(&hearing, hear_queue, error))
        return false;
    *stretch = hearing.stretch;
    return true;
}

bool frame_pixel_region(const struct frame_pixel *pixel, const char *region,
                        struct clock_stretch *stretch, c205_error *error)
{
    struct hearing hearing = { .pixel = pixel,
                               .region = region,
                               .within = *stretch };

    if (!hear(&hearing, hear_region, error))
        return false;
    if (hearing.stretch.to == 0)
        return error_say(error,
                         "control is not in the region %.60s between clocks "
                         "%llu and %llu",
                         region, (unsigned long long)stretch->from,
                         (unsigned long long)stretch->to);
    *stretch = hearing.stretch;
    return true;
}
