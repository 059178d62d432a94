/* cmd_timeline.c - rt205 timeline: shows a queue of a frame clock by clock, as a
 * picture or for a viewer. */
#include <inttypes.h>
#include <stdio.h>

#include "asm/timeline/timeline.h"
#include "base/error.h"
#include "base/plural.h"
#include "rt/command/rt205_command.h"
#include "rt/view/pixel_clocks.h"

/* Finds the clocks of the band to show. The default is the pixel's queue. */
static bool find_stretch(const struct rt205_arguments *arguments,
                         const struct frame_pixel *pixel, struct clock_stretch *stretch,
                         c205_error *error)
{
    if (!pixel_queue_clocks(pixel, stretch, error))
        return false;
    if (arguments->from != C205_NO_LIMIT)
        stretch->from = arguments->from;
    if (arguments->to != C205_NO_LIMIT)
        stretch->to = arguments->to;
    if (stretch->from >= stretch->to)
        return error_set(error,
                         "the range of clocks %" PRIu64 " to %" PRIu64
                         " is empty: change --from or --to",
                         stretch->from, stretch->to);
    return !arguments->region
           || pixel_region_clocks(pixel, arguments->region, stretch, error);
}

/* Records whole instructions, up to one that starts after the range. */
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

static bool save(const struct rt205_arguments *arguments,
                 const struct frame_pixel *pixel, struct timeline *timeline,
                 c205_error *error)
{
    const struct trace_options *how = trace_how(pixel->trace);
    char title[400];

    timeline_finish(timeline);
    snprintf(title, sizeof title,
             "%.150s, %s, the queue of pixel %zu,%zu of %zu x %zu, clocks "
             "%" PRIu64 " to %" PRIu64 " on %.80s",
             arguments->scene, trace_mode_name(how->mode), pixel->x, pixel->y,
             how->width, how->height, timeline->from, timeline->to,
             c205_model_name(how->model));
    return timeline_save(timeline, arguments->output, title, error);
}

static bool draw(const struct rt205_arguments *arguments,
                 const struct frame_pixel *pixel, const struct command_output *results,
                 c205_error *error)
{
    struct clock_stretch stretch;
    struct timeline timeline = { .from = 0 };
    bool good;

    if (!find_stretch(arguments, pixel, &stretch, error))
        return false;
    timeline.from = stretch.from;
    timeline.to = stretch.to;
    good = listen(pixel, &timeline, error) && save(arguments, pixel, &timeline, error);
    if (good)
        output_printf(results,
                      "%s: %zu instruction%s, clocks %" PRIu64 " to %" PRIu64
                      " of band %zu of %zu\n",
                      arguments->output, timeline_instructions(&timeline),
                      plural(timeline_instructions(&timeline)), timeline.from,
                      timeline.to, pixel->band + 1, trace_bands(pixel->trace));
    timeline_free(&timeline);
    return good;
}

/* The default pixel is the one in the centre. */
static int trace_and_draw(const struct rt205_arguments *arguments,
                          const struct command_output *results)
{
    const struct trace_options *how = &arguments->trace;
    const struct cmd_pixel *asked = &arguments->pixel;
    size_t x = asked->given ? asked->x : how->width / 2;
    size_t y = asked->given ? asked->y : how->height / 2;
    struct scene *scene = cmd_read_scene(arguments);
    struct trace *trace;
    struct frame_pixel pixel;
    c205_error error = { "out of memory" };
    bool good;

    if (!scene)
        return CMD_FAILED;
    trace = trace_new(scene, how, &error);
    good = trace && frame_pixel_find(&pixel, trace, x, y, &error)
           && draw(arguments, &pixel, results, &error);
    trace_free(trace);
    scene_free(scene);
    return good ? CMD_DONE : cmd_failed(arguments->command, "%s", error.message);
}

static int run_command_line(void *given)
{
    struct rt205_arguments *arguments = given;

    if (!arguments->output)
        return cmd_usage(arguments->command, "expected -o FILE");
    if (!timeline_is_named(arguments->output))
        return cmd_usage(arguments->command,
                         "%s: the name of a timeline must end in "
                         ".svg, .kanata or .json",
                         arguments->output);
    if (arguments->from != C205_NO_LIMIT && arguments->from >= arguments->to)
        return cmd_usage(arguments->command, "--from must be below --to");
    return cmd_check_pixel(arguments) == CMD_DONE
               ? cmd_with_machine(arguments, trace_and_draw)
               : CMD_USAGE;
}

static const struct command_option options[] = {
    { .name = "output",
      .letter = 'o',
      .value = "FILE",
      .kind = COMMAND_OUTPUT,
      .offset = CMD_PLACE(output),
      .help = ".svg, a picture; .kanata, for Konata; .json, trace events for "
              "Perfetto" },
    CMD_PIXEL("pixel", "show the queue with the ray of this pixel (default: the "
                       "centre)"),
    { .name = "region",
      .value = "NAME",
      .kind = COMMAND_TEXT,
      .offset = CMD_PLACE(region),
      .help = "show only the first execution of this region in the queue" },
    { .name = "from",
      .value = "CLOCK",
      .kind = COMMAND_CLOCKS,
      .offset = CMD_PLACE(from),
      .preset = -1,
      .help = "show instructions from this clock of the band on (default: the start "
              "of the queue)" },
    { .name = "to",
      .value = "CLOCK",
      .kind = COMMAND_CLOCKS,
      .offset = CMD_PLACE(to),
      .preset = -1,
      .help = "show instructions before this clock (default: the end of the queue)" },
    CMD_SIZE(640, 480),
    CMD_MODE(cmd_mode_choice, "form of the programs; kernels is that of 1984"),
    CMD_QUEUE("rays in the vector queue"),
    CMD_ORDER(ORDER_DEFAULT),
    CMD_MODEL,
    CMD_BOUNDS,
    CMD_READ,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_SCENE, COMMAND_END };
static const struct command_example examples[] = {
    { "rt205 timeline SCENE --pixel 320,240 --region sphere -o sphere.svg",
      "a queue in the kernel of the sphere" },
    { "rt205 timeline SCENE --mode scalar -o pixel.kanata",
      "a pixel in the serial form, for Konata" },
    { NULL, NULL }
};

const struct command timeline_command = {
    .name = "timeline",
    .summary = "a queue of a frame clock by clock, as a picture",
    .function = run_command_line,
    .arguments_size = sizeof(struct rt205_arguments),
    .options = options,
    .operands = operands,
    .examples = examples,
    .details = "The timeline of a queue begins where its rays are generated and ends "
               "where their colours are stored. In serial form it shows one pixel, "
               "with all rays that its camera ray spawns.",
};
