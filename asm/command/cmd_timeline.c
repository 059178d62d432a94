/* cmd_timeline.c - c205 timeline: draws a run as a picture, or
 * exports it for a viewer. */
#include <inttypes.h>
#include <stdio.h>

#include "asm/command/c205_command.h"
#include "asm/timeline/timeline.h"
#include "base/plural.h"

static int write_file(const struct c205_arguments *arguments,
                      const struct timeline *timeline)
{
    c205_error error;
    char title[TIMELINE_TITLE];
    timeline_title(timeline, arguments->file,
                   arguments->model ? arguments->model : C205_DEFAULT_MODEL, title);
    if (!timeline_save(timeline, arguments->output, title, &error)) {
        return cmd_failed(arguments->command, "%s", error.message);
    }
    cmd_print_line(stdout, "%s: %zu instruction%s, clocks %" PRIu64 " to %" PRIu64,
                   arguments->output, timeline_instructions(timeline),
                   plural(timeline_instructions(timeline)), timeline->from,
                   timeline->to);
    return CMD_DONE;
}

/* How the run ended. */
struct ending {
    bool ended; /* false: it was stopped at a limit of clocks */
    c205_stop stop;
};

/* Reports a trap. The timeline up to the trap has been written. */
static int print_trap(const struct c205_arguments *arguments, const c205 *machine,
                      const struct ending *ending)
{
    c205_error error;
    if (!ending->ended || ending->stop.trap == C205_TRAP_NONE) {
        return CMD_DONE;
    }
    c205_describe_stop(machine, &ending->stop, &error);
    cmd_print_line(stderr, "%s: %s", arguments->file, error.message);
    return CMD_FAILED;
}

static int judge(const struct c205_arguments *arguments, c205 *machine,
                 struct ending ending, struct timeline *timeline)
{
    int code;
    if (!timeline_is_good(timeline)) {
        return cmd_failed(arguments->command, "out of memory");
    }
    if (timeline->full) {
        return cmd_failed(
            arguments->command,
            "more than %d instructions; select a part with --from CLOCK and --to CLOCK",
            MAX_TIMELINE);
    }
    if (timeline->insn_count == 0) {
        return cmd_failed(
            arguments->command,
            ending.ended
                ? "no instruction is active in this range: the program takes %" PRIu64
                  " clock%s"
                : "no instruction is active in this range: the program was run for "
                  "%" PRIu64 " clock%s",
            c205_clock(machine), plural(c205_clock(machine)));
    }
    timeline_finish(timeline);
    code = write_file(arguments, timeline);
    return code != CMD_DONE ? code : print_trap(arguments, machine, &ending);
}

/* Runs until an instruction arrives at that clock or later, or the
 * default limit is reached. */
static struct ending run_to(c205 *machine, uint64_t clock)
{
    uint64_t end = clock < CMD_LIMIT ? clock : CMD_LIMIT;
    struct ending ending = { .ended = false };
    bool goes_on = true;
    while (goes_on && c205_clock(machine) < end) {
        goes_on = c205_step(machine, &ending.stop);
    }
    ending.ended = !goes_on;
    return ending;
}

/* Runs the program up to the end of the timeline only. */
static int run_program(const struct c205_arguments *arguments,
                       const struct object *object, const c205_model *model)
{
    struct timeline timeline = { .from = arguments->from, .to = arguments->limit };
    c205_error error;
    c205 *machine = cmd_load(arguments, object, model, &error);
    int code;
    if (!machine) {
        return cmd_failed(arguments->command, "%s", error.message);
    }
    c205_listen(machine, timeline_listen, &timeline);
    code = judge(arguments, machine, run_to(machine, arguments->limit), &timeline);
    timeline_free(&timeline);
    c205_free(machine);
    return code;
}

static int check_usage(const struct c205_arguments *arguments)
{
    const char *path = arguments->output;
    if (!path) {
        return cmd_usage(arguments->command, "-o FILE is missing");
    }
    if (!timeline_is_named(path)) {
        return cmd_usage(
            arguments->command,
            "%s: the name of a timeline must end in .svg, .kanata or .json", path);
    }
    if (arguments->from >= arguments->limit) {
        return cmd_usage(arguments->command, "--from must be before --to");
    }
    return CMD_DONE;
}

static int run(void *given)
{
    const struct c205_arguments *arguments = given;
    struct object *object;
    c205_model *model;
    int code = check_usage(arguments);
    if (code != CMD_DONE) {
        return code;
    }
    code = cmd_open(arguments, &object, &model) ? run_program(arguments, object, model)
                                                : CMD_FAILED;
    c205_model_free(model);
    object_free(object);
    return code;
}

static const struct command_option options[] = {
    { .name = "output",
      .letter = 'o',
      .value = "FILE",
      .kind = COMMAND_OUTPUT,
      .offset = CMD_PLACE(output),
      .help = ".svg, a picture; .kanata, for Konata; .json, trace events for "
              "Perfetto" },
    { .name = "from",
      .value = "CLOCK",
      .kind = COMMAND_CLOCKS,
      .offset = CMD_PLACE(from),
      .help = "include instructions that are active from this clock on (0)" },
    { .name = "to",
      .value = "CLOCK",
      .kind = COMMAND_CLOCKS,
      .offset = CMD_PLACE(limit),
      .preset = -1,
      .help = "and before this clock (the end)" },
    CMD_FLAG(warm, "all pages are in memory when the program begins"),
    CMD_MODEL,
    CMD_DEFINE,
    CMD_INCLUDE,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_PROGRAM, COMMAND_END };
static const struct command_example examples[] = {
    { "c205 timeline FILE -o run.svg", "a picture of a run" },
    { "c205 timeline FILE --from 1000 --to 2000 -o run.kanata",
      "a part of it, for Konata" },
    { NULL, NULL }
};

const struct command timeline_command = {
    .name = "timeline",
    .summary = "draw when each instruction was active",
    .function = run,
    .arguments_size = sizeof(struct c205_arguments),
    .options = options,
    .operands = operands,
    .examples = examples,
};
