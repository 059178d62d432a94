/* pixel_verbs.c - the debugger commands that concern a pixel. */
#include "rt/view/pixel_verbs.h"

#include <string.h>

#include "asm/view/word_text.h"
#include "vm/error.h"
#include "rt/view/pixel_rays.h"

c205 *pixel_machine(void *context, c205_error *error)
{
    const struct frame_pixel *pixel = context;
    return trace_machine(pixel->trace, pixel->band, error);
}

/* ---- Elements of the pixel's rays -------------------------------------------- */

struct lane_report {
    const struct frame_pixel *pixel;
    const struct sink *out;
    const char *vector;        /* show only the vector with this name */
    size_t length;             /* length of the name; 0: show all vectors */
    struct pixel_element last; /* last element that was printed; length 0: none */
};

static bool is_asked(const struct lane_report *report, const char *vector)
{
    return report->length == 0
           || (strlen(vector) == report->length
               && strncmp(vector, report->vector, report->length) == 0);
}

static void put_heading(const struct lane_report *report,
                        const struct pixel_element *element)
{
    static const char *const groups[PIXEL_GROUPS] = {
        [PIXEL_QUEUE] = "rays in the queue",
        [PIXEL_NEAR] = "current rays",
        [PIXEL_HITS] = "hits",
    };
    const struct sink *out = report->out;
    if (trace_how(report->pixel->trace)->mode == TRACE_SCALAR)
        sink_print(out, "pixel %zu,%zu\n", report->pixel->x, report->pixel->y);
    else if (element->list > 0)
        sink_print(out, "lane %zu of %zu %s, list %zu\n", element->lane,
                   element->length, groups[element->group], element->list);
    else
        sink_print(out, "lane %zu of %zu %s\n", element->lane, element->length,
                   groups[element->group]);
}

static void put_element(void *context, const struct pixel_element *element)
{
    struct lane_report *report = context;
    const struct pixel_element *last = &report->last;
    struct word_text text = word_text(element->word, false);
    if (!is_asked(report, element->vector))
        return;
    if (last->length == 0 || last->group != element->group
        || last->lane != element->lane)
        put_heading(report, element);
    sink_print(report->out, "    %-10s X'%s'  %s\n", element->vector, text.hex,
               text.number);
    report->last = *element;
}

static bool show_lane(void *context, struct debugger *debugger, const char *rest,
                      c205_error *error)
{
    const struct frame_pixel *pixel = context;
    const char *vector = rest + strspn(rest, " \t");
    struct lane_report report = { .pixel = pixel,
                                  .out = debugger_out(debugger),
                                  .vector = vector,
                                  .length = strcspn(vector, " \t") };
    size_t rays = pixel_elements(pixel, debugger_machine(debugger), put_element,
                                 &report);
    if (rays == 0)
        sink_print(report.out, "pixel %zu,%zu is in no current queue\n", pixel->x,
                   pixel->y);
    return rays == 0 || report.last.length > 0
           || error_set(error, "no vector of the pixel's rays has the name %.60s",
                        vector);
}

/* ---- Continuing ---------------------------------------------------------------- */

static bool is_made(void *context, const c205 *machine)
{
    return pixel_is_made(context, machine);
}

static bool seek(void *context, struct debugger *debugger, const char *rest,
                 c205_error *error)
{
    if (rest[strspn(rest, " \t")] != '\0')
        return error_set(error, "seek takes no argument:%.60s", rest);
    debugger_seek(debugger, is_made, context);
    return true;
}

const struct debugger_verb pixel_verbs[] = {
    { "seek", "", "continue until a queue with a ray of the pixel is made", seek },
    { "lane", "[VECTOR]",
      "the elements of the pixel's rays in the vectors of the current queue",
      show_lane },
    { NULL, NULL, NULL, NULL }
};
enum { VERBS = sizeof pixel_verbs / sizeof *pixel_verbs - 1 };

const char *pixel_verb(size_t i)
{
    return i < VERBS ? pixel_verbs[i].name : debugger_verb(i - VERBS);
}
