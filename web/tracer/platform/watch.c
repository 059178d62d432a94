/* watch.c - reports to the page the progress of a trace, and the rows of the picture in
 * the memory of the machines.
 */
#include <stdlib.h>

#include "base/json.h"
#include "base/sink.h"
#include "rt/command/session.h"
#include "web/tracer/platform/png.h"

/* Imports from web/tracer/tracer.js. */
#define OF_PAGE(name) __attribute__((import_module("rt205"), import_name(#name)))
/* Returns false to stop the trace. */
OF_PAGE(progress) bool page_progress(size_t done, size_t all);
/* Returns true if the picture must be shown now. done: the band is complete. */
OF_PAGE(wants_rows) bool page_wants_rows(bool done);
/* Passes rows of a frame as sRGB with 4 bytes per pixel, and a JSON text with the
 * clocks so far. */
OF_PAGE(rows)
void page_rows(size_t width, size_t height, size_t first_row, size_t rows,
               const unsigned char *rgba, const char *clocks, size_t length);

static bool report_progress(void *context, size_t done, size_t all)
{
    (void)context;
    return page_progress(done, all);
}

/* Writes the clocks of the completed bands and of the current band. */
static bool put_clocks(const struct trace *trace, const struct band *band,
                       struct text_buffer *text)
{
    struct accounts sum = { .model = trace_how(trace)->model };
    c205_error error;
    struct json *json = json_open_line(text, &error);
    bool good = json && accounts_add_all(&sum, trace_accounts(trace))
                && accounts_add_all(&sum, &band->accounts);
    c205_account all = accounts_together(&sum);
    if (good) {
        json_count(json, "clocks", sum.clocks);
        json_number(json, "seconds", accounts_seconds(sum.model, sum.clocks));
        json_object(json, "causes");
        for (int cause = 0; cause < C205_CAUSES; cause++)
            if (all.clocks[cause] > 0)
                json_count(json, c205_cause_name((c205_cause)cause), all.clocks[cause]);
        json_end(json);
    }
    accounts_free(&sum);
    return json && json_close(json, &error) && good;
}

static unsigned char *bytes_of(const struct frame *part)
{
    size_t pixels = part->width * part->height;
    unsigned char *rgba = malloc(4 * pixels), *to = rgba;
    for (size_t i = 0; rgba && i < pixels; i++) {
        for (int color = CHANNEL_RED; color <= CHANNEL_BLUE; color++)
            *to++ = png_byte((float)picture_shown(part, part->channel[color][i]));
        *to++ = 255;
    }
    return rgba;
}

static void show_band(const struct trace *trace, const struct band *band)
{
    const struct trace_options *how = trace_how(trace);
    struct text_buffer clocks = { .text = NULL };
    unsigned char *rgba;
    struct frame part;
    if (!frame_allocate(&part, how->width, band->rows))
        return;
    trace_read_band(trace, band, &part);
    rgba = bytes_of(&part);
    if (rgba && put_clocks(trace, band, &clocks))
        page_rows(how->width, how->height, band->first_row, band->rows, rgba,
                  clocks.text, clocks.length);
    text_buffer_free(&clocks);
    free(rgba);
    frame_free(&part);
}

/* Shows the current band if the page requests it. If memory is exhausted, the work
 * continues without showing it. */
static void look(void *context, const struct trace *trace,
                 const struct band_tracer *tracer, bool done)
{
    struct band band;
    (void)context;
    if (!page_wants_rows(done) || !band_look(tracer, &band))
        return;
    show_band(trace, &band);
    band_free(&band);
}

void session_watch(struct trace_session *session)
{
    session->shared->trace.progress = report_progress;
    session->shared->trace.look = look;
}
