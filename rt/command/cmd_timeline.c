/* cmd_timeline.c - rt205 timeline: shows a queue of a frame clock by clock, as a
 * picture or in the format of a viewer. */
#include <inttypes.h>
#include <stdio.h>

#include "asm/timeline/timeline.h"
#include "vm/error.h"
#include "base/plural.h"
#include "rt/command/session.h"
#include "rt/view/pixel_clocks.h"

struct timeline_arguments {
    struct trace_arguments shared;
    struct scene_arguments scene;
    struct pixel_arguments pixel;
    const char *region; /* region of the program, or NULL */
    uint64_t from, to;  /* range of clocks; C205_NO_LIMIT: not specified */
};

/* Finds the clocks that the timeline shows: by default those of the queue that contains
 * the pixel. */
static bool find_stretch(const struct timeline_arguments *args,
                         const struct frame_pixel *pixel, struct clock_stretch *stretch,
                         c205_error *error)
{
    if (!pixel_queue_clocks(pixel, stretch, error))
        return false;
    if (args->from != C205_NO_LIMIT)
        stretch->from = args->from;
    if (args->to != C205_NO_LIMIT)
        stretch->to = args->to;
    if (stretch->from >= stretch->to)
        return error_set(error,
                         "the range of clocks %" PRIu64 " to %" PRIu64
                         " is empty: change --from or --to",
                         stretch->from, stretch->to);
    return !args->region || pixel_region_clocks(pixel, args->region, stretch, error);
}

/* Records whole instructions, up to the first instruction that starts after the
 * range. */
static bool listen(const struct frame_pixel *pixel, struct timeline *timeline,
                   c205_error *error)
{
    c205 *machine = trace_machine(pixel->trace, pixel->band, error);
    c205_stop stop;
    bool goes_on;
    if (!machine || !c205_listen(machine, timeline_listen, timeline)) {
        c205_free(machine);
        return false;
    }
    stop = c205_run(machine, timeline->from);
    goes_on = stop.trap == C205_TRAP_CLOCK_LIMIT;
    while (goes_on && c205_clock(machine) < timeline->to && !timeline->full)
        goes_on = c205_step(machine, &stop);
    c205_free(machine);
    if (!timeline_is_good(timeline))
        return error_set(error, "out of memory");
    if (timeline->full)
        return error_set(error,
                         "more than %d instructions: select fewer with --region "
                         "NAME, --from CLOCK and --to CLOCK, or a shorter --queue; "
                         "the range is clocks %" PRIu64 " to %" PRIu64,
                         MAX_TIMELINE, timeline->from, timeline->to);
    return timeline->insn_count > 0
           || error_set(error, "no instruction runs in this range of clocks");
}

static bool save(const struct timeline_arguments *args, const struct frame_pixel *pixel,
                 struct timeline *timeline, c205_error *error)
{
    const struct trace_options *how = trace_how(pixel->trace);
    char title[400];
    timeline_finish(timeline);
    snprintf(title, sizeof title,
             "%.150s, %s, the queue of pixel %zu,%zu of %zu x %zu, clocks "
             "%" PRIu64 " to %" PRIu64 " on %.80s",
             args->scene.path, trace_mode_name(how->mode), pixel->x, pixel->y,
             how->width, how->height, timeline->from, timeline->to,
             c205_model_name(how->model));
    return timeline_save(timeline, args->shared.output, title, error);
}

static bool draw(const struct timeline_arguments *args, const struct frame_pixel *pixel,
                 const struct command_output *results, c205_error *error)
{
    struct clock_stretch stretch;
    struct timeline timeline = { .from = 0 };
    bool good;
    if (!find_stretch(args, pixel, &stretch, error))
        return false;
    timeline.object = trace_program(pixel->trace);
    timeline.from = stretch.from;
    timeline.to = stretch.to;
    good = listen(pixel, &timeline, error) && save(args, pixel, &timeline, error);
    if (good)
        output_printf(results,
                      "%s: %zu instruction%s, clocks %" PRIu64 " to %" PRIu64
                      " of band %zu of %zu\n",
                      args->shared.output, timeline_instructions(&timeline),
                      plural(timeline_instructions(&timeline)), timeline.from,
                      timeline.to, pixel->band + 1, trace_bands(pixel->trace));
    timeline_free(&timeline);
    return good;
}

/* Traces and draws. The default pixel is in the centre of the frame. */
static int trace_and_draw(struct trace_session *session,
                          const struct timeline_arguments *args)
{
    const struct trace_options *how = &args->shared.trace;
    const struct pixel_arguments *asked = &args->pixel;
    size_t x = asked->given ? asked->x : how->width / 2;
    size_t y = asked->given ? asked->y : how->height / 2;
    const struct scene *scene = session_scene(session, &args->scene);
    struct trace *trace;
    struct frame_pixel pixel;
    c205_error error = { "out of memory" };
    bool good;
    if (!scene)
        return CMD_FAILED;
    trace = trace_new(scene, how, &error);
    good = trace && frame_pixel_find(&pixel, trace, x, y, &error)
           && draw(args, &pixel, &session->results, &error);
    trace_free(trace);
    return good ? CMD_DONE : cmd_failed(args->shared.command, "%s", error.message);
}

static int cmd_timeline(void *given)
{
    struct timeline_arguments *args = given;
    struct trace_session session;
    int code;
    if (!args->shared.output)
        return cmd_usage(args->shared.command, "expected -o FILE");
    if (!timeline_is_named(args->shared.output))
        return cmd_usage(args->shared.command,
                         "%s: the name of a timeline must end in "
                         ".svg, .kanata or .json",
                         args->shared.output);
    if (args->from != C205_NO_LIMIT && args->from >= args->to)
        return cmd_usage(args->shared.command, "--from must be below --to");
    code = cmd_check_pixel(&args->shared, &args->pixel);
    if (code != CMD_DONE)
        return code;
    code = session_open(&session, &args->shared, NULL);
    if (code == CMD_DONE)
        code = trace_and_draw(&session, args);
    return session_close(&session, code);
}

#define PLACE(member) offsetof(struct timeline_arguments, member)

static const struct command_option options[] = {
    CMD_OUTPUT(".svg, a picture; .kanata, for Konata; .json, trace events for "
               "Perfetto"),
    CMD_PIXEL("pixel", PLACE(pixel),
              "show the queue with the ray of this pixel (default: the "
              "centre)"),
    { OPTION_ROW("region", "NAME", COMMAND_TEXT, PLACE(region),
                 "show only the first execution of this region in the queue") },
    { OPTION_ROW("from", "CLOCK", COMMAND_CLOCKS, PLACE(from),
                 "show instructions from this clock of the band on (default: the start "
                 "of the queue)"),
      .preset = -1 },
    { OPTION_ROW("to", "CLOCK", COMMAND_CLOCKS, PLACE(to),
                 "show instructions before this clock (default: the end of the queue)"),
      .preset = -1 },
    CMD_SIZE(640, 480),
    CMD_MODE(cmd_mode_choice, "form of the programs; kernels is that of 1984"),
    CMD_QUEUE("rays in the vector queue"),
    CMD_ORDER(ORDER_DEFAULT),
    CMD_MODEL,
    CMD_BOUNDS,
    CMD_READ(PLACE(scene)),
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE(PLACE(scene)),
                                                  COMMAND_END };
static const struct command_example examples[] = {
    { "rt205 timeline SCENE --pixel 320,240 --region sphere -o sphere.svg",
      "a queue in the kernel of the sphere" },
    { "rt205 timeline SCENE --mode scalar -o pixel.kanata",
      "a pixel in the serial form, for Konata" },
    { NULL, NULL }
};

const struct command timeline_command = {
    COMMAND_ROW("timeline", cmd_timeline, struct timeline_arguments,
                "a queue of a frame clock by clock, as a picture"),
    .examples = examples,
    .details = "The timeline of a queue begins where its rays are generated and ends "
               "where their colours are stored. In serial form it shows one pixel, "
               "with all rays that its camera ray spawns.",
};
