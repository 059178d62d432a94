/* cmd_timeline.c - c205 timeline: draws a run as a picture, or
 * exports it for a viewer. */
#include <inttypes.h>
#include <stdio.h>

#include "asm/command/session.h"
#include "asm/timeline/timeline.h"
#include "base/plural.h"

struct program_timeline_arguments {
    struct shared_arguments shared;
    struct source_arguments source;
    const char *file, *output;
    uint64_t from, to; /* range in clocks */
    bool warm;
};

static int write_file(const struct program_timeline_arguments *args,
                      const struct timeline *timeline)
{
    c205_error error;
    char title[TIMELINE_TITLE];
    timeline_title(timeline, args->file,
                   args->shared.model ? args->shared.model : C205_DEFAULT_MODEL, title);
    if (!timeline_save(timeline, args->output, title, &error))
        return cmd_failed(args->shared.command, "%s", error.message);
    cmd_print_line(stdout, "%s: %zu instruction%s, clocks %" PRIu64 " to %" PRIu64,
                   args->output, timeline_instructions(timeline),
                   plural(timeline_instructions(timeline)), timeline->from,
                   timeline->to);
    return CMD_DONE;
}

/* The end of the recorded run: the end of the program, a trap, or a limit of clocks. */
struct ending {
    bool ended; /* false: the run was stopped at a limit of clocks */
    c205_stop stop;
};

/* Reports a trap. The timeline up to the trap has been written. */
static int print_trap(const struct program_timeline_arguments *args,
                      const c205 *machine, const struct ending *ending)
{
    c205_error error;
    if (!ending->ended || ending->stop.trap == C205_TRAP_NONE)
        return CMD_DONE;
    c205_describe_stop(machine, &ending->stop, &error);
    cmd_print_line(stderr, "%s: %s", args->file, error.message);
    return CMD_FAILED;
}

static int judge(const struct program_timeline_arguments *args, c205 *machine,
                 struct ending ending, struct timeline *timeline)
{
    int code;
    if (!timeline_is_good(timeline))
        return cmd_failed(args->shared.command, "out of memory");
    if (timeline->full) {
        return cmd_failed(
            args->shared.command,
            "more than %d instructions; select a part with --from CLOCK and --to CLOCK",
            MAX_TIMELINE);
    }
    if (timeline->insn_count == 0) {
        return cmd_failed(
            args->shared.command,
            ending.ended
                ? "no instruction is active in this range: the program takes %" PRIu64
                  " clock%s"
                : "no instruction is active in this range: the program was run for "
                  "%" PRIu64 " clock%s",
            c205_clock(machine), plural(c205_clock(machine)));
    }
    timeline_finish(timeline);
    code = write_file(args, timeline);
    return code != CMD_DONE ? code : print_trap(args, machine, &ending);
}

/* Runs until an instruction arrives at the end of the timeline or later, the timeline is
 * full, or the default limit is reached. */
static struct ending run_to_end(c205 *machine, const struct timeline *timeline)
{
    uint64_t end = timeline->to < CMD_LIMIT ? timeline->to : CMD_LIMIT;
    struct ending ending = { .ended = false };
    bool goes_on = true;
    while (goes_on && !timeline->full && c205_clock(machine) < end)
        goes_on = c205_step(machine, &ending.stop);
    ending.ended = !goes_on;
    return ending;
}

/* Runs the program up to the end of the timeline only. */
static int run_program(struct session *session,
                       const struct program_timeline_arguments *args)
{
    struct timeline timeline = { .object = session->object,
                                 .from = args->from,
                                 .to = args->to };
    c205_error error;
    int code;
    if (!session_load(session, args->warm, &error))
        return cmd_failed(session->command, "%s", error.message);
    c205_listen(session->machine, timeline_listen, &timeline);
    code = judge(args, session->machine, run_to_end(session->machine, &timeline),
                 &timeline);
    timeline_free(&timeline);
    return code;
}

static int check_usage(const struct program_timeline_arguments *args)
{
    const char *path = args->output;
    if (!path)
        return cmd_usage(args->shared.command, "-o FILE is missing");
    if (!timeline_is_named(path)) {
        return cmd_usage(
            args->shared.command,
            "%s: the name of a timeline must end in .svg, .kanata or .json", path);
    }
    if (args->from >= args->to)
        return cmd_usage(args->shared.command, "--from must be before --to");
    return CMD_DONE;
}

static int cmd_timeline(void *given)
{
    const struct program_timeline_arguments *args = given;
    struct session session = { .command = args->shared.command };
    int code = check_usage(args);
    if (code != CMD_DONE)
        return code;
    bool good = session_program(&session, &args->source, args->file)
                && session_model(&session, args->shared.model);
    return session_close(&session, good ? run_program(&session, args) : CMD_FAILED);
}

#define PLACE(member) offsetof(struct program_timeline_arguments, member)

static const struct command_option options[] = {
    OPTION_OUTPUT(PLACE(output),
                  ".svg, a picture; .kanata, for Konata; .json, trace events for "
                  "Perfetto"),
    { OPTION_ROW("from", "CLOCK", COMMAND_CLOCKS, PLACE(from),
                 "include instructions that are active from this clock on (0)") },
    { OPTION_ROW("to", "CLOCK", COMMAND_CLOCKS, PLACE(to),
                 "and before this clock (the end)"),
      .preset = -1 },
    OPTION_FLAG("warm", PLACE(warm), "all pages are in memory when the program begins"),
    CMD_MODEL,
    CMD_DEFINE(PLACE(source)),
    CMD_INCLUDE(PLACE(source)),
    COMMAND_END
};
static const struct command_option operands[] = { CMD_PROGRAM(PLACE(file)),
                                                  COMMAND_END };
static const struct command_example examples[] = {
    { "c205 timeline FILE -o run.svg", "a picture of a run" },
    { "c205 timeline FILE --from 1000 --to 2000 -o run.kanata",
      "a part of it, for Konata" },
    { NULL, NULL }
};

const struct command timeline_command = {
    COMMAND_ROW("timeline", cmd_timeline, struct program_timeline_arguments,
                "draw when each instruction was active"),
    .examples = examples,
};
