/* cmd_run.c - c205 run: runs a program and prints the causes of its clocks. */
#include <inttypes.h>

#include "asm/check/runtime_check.h"
#include "asm/command/cmd_run.h"
#include "asm/measure/line_profile.h"
#include "asm/object/disassemble.h"
#include "asm/view/operand_view.h"
#include "asm/view/print.h"
#include "asm/view/state.h"
#include "asm/view/trap_report.h"
#include "base/accounts_show.h"
#include "vm/error.h"
#include "base/interrupt.h"
#include "base/plural.h"

static void trace(void *context, const c205 *machine, const c205_event *event)
{
    char text[DISASSEMBLE_TEXT_SIZE];
    if (event->kind != C205_EVENT_INSTRUCTION && event->kind != C205_EVENT_REQUEST)
        return;
    disassemble_one(view_word_at(machine, event->pc), event->pc, text);
    sink_print(context, "%10" PRIu64 " %+6" PRId64 " %10" PRIX64 "  %s\n",
               event->issued, (int64_t)event->clocks, event->pc, text);
}

static void stop_json(const c205 *machine, const c205_stop *stop, struct json *json)
{
    json_object(json, "stop");
    json_text(json, "trap", c205_trap_name(stop->trap));
    json_count(json, "pc", stop->pc);
    json_count(json, "address", stop->address);
    json_number(json, "status", (double)stop->status);
    json_end(json);
    json_count(json, "clocks", c205_clock(machine));
}

static const char *program_name(const struct run_arguments *args)
{
    return args->files.count ? args->files.items[0] : args->restore;
}

static int show_accounts(const struct session *session,
                         const struct run_arguments *args, const c205_stop *stop)
{
    const struct command_output *results = &session->results;
    uint64_t clocks = c205_clock(session->machine);
    struct accounts accounts = { .model = session->model };
    char time[ACCOUNTS_TIME];
    if (!accounts_add(&accounts, session->machine)) {
        accounts_free(&accounts);
        return cmd_failed(session->command, "out of memory");
    }
    if (results->json) {
        json_text(results->json, "program", program_name(args));
        provenance_json(session->model, results->json);
        stop_json(session->machine, stop, results->json);
    }
    accounts_time(session->model, clocks, time);
    output_printf(results, "%" PRIu64 " clock%s, %s\n", clocks, plural(clocks), time);
    int code = accounts_show(&accounts, results);
    output_model(results, session->model);
    accounts_free(&accounts);
    return code;
}

/* ---- The end of a run ---------------------------------------------------- */

/* Reports the trap that stopped the program. Returns the exit code. */
static int judge_trap(const struct session *session, const struct run_arguments *args,
                      const c205_stop *stop)
{
    struct sink report = visible_stream(stderr);
    fflush(stdout);
    trap_report(session->object, program_name(args), session->machine, stop, &report);
    if (stop->trap == C205_TRAP_CLOCK_LIMIT && args->limit == C205_NO_LIMIT) {
        return cmd_failed(
            session->command,
            "stopped after %" PRIu64
            " clocks: if the program is not in an endless loop, use --limit CLOCKS "
            "or --no-limit",
            CMD_LIMIT);
    }
    return CMD_FAILED;
}

static int judge(const struct session *session, const struct run_arguments *args,
                 const c205_stop *stop)
{
    enum { STATUS = 0xFF };
    if (stop->trap != C205_TRAP_NONE)
        return judge_trap(session, args, stop);
    if (args->exit_status)
        return (int)(stop->status & STATUS);
    if (stop->status != 0) {
        return cmd_failed(session->command, "the program ended with status %" PRId64,
                          stop->status);
    }
    return CMD_DONE;
}

static bool may_go_on(const c205_stop *stop)
{
    return stop->trap == C205_TRAP_CLOCK_LIMIT;
}

static int save(const struct session *session, const struct run_arguments *args,
                const c205_stop *stop)
{
    c205_error error;
    if (!may_go_on(stop)) {
        fprintf(stderr,
                "c205 run: the program did not reach the limit; nothing is saved\n");
        return judge(session, args, stop);
    }
    if (!state_save(session->machine, args->save, &error))
        return cmd_failed(session->command, "%s", error.message);
    output_printf(&session->results, "stopped by %s, and saved as %s\n",
                  interrupt_pending() ? "Ctrl-C" : "the limit", args->save);
    return CMD_DONE;
}

/* Returns the stream for the output of the program. It is part of the results in text
 * format. It would corrupt other formats, so it is then written to stderr. */
static FILE *program_stream(const struct command_output *results)
{
    bool among = results->file == stdout && results->format == OUTPUT_TEXT;
    return among ? stdout : stderr;
}

/* Prints a message on stderr. If the output of the program is on stderr and its last
 * line is incomplete, a newline is printed first. */
static void put_message(void *context, const char *text, size_t length)
{
    struct sink report = visible_stream(stderr);
    struct line_tracker *printed = context;
    if (printed->to.context == stderr)
        line_tracker_close(printed);
    report.put(report.context, text, length);
}

/* Starts the runtime checks if the object is known and a warning is enabled. */
static bool start_watch(const struct session *session, const struct run_arguments *args,
                        const struct sink *report, struct runtime_checker **watch)
{
    const struct warning_choice *choice = &args->source.warnings.choice;
    *watch = NULL;
    if (!session->object || !warning_any(choice))
        return true;
    *watch = runtime_new(session->object, program_name(args), choice, report);
    if (!*watch || !c205_listen(session->machine, runtime_listen, *watch))
        return false;
    runtime_begin(*watch, session->machine);
    return true;
}

/* Reports an interruption after the results, so the user does not overlook it. */
static int conclude(const struct session *session, const struct run_arguments *args,
                    const c205_stop *stop)
{
    uint64_t clocks = c205_clock(session->machine);
    int code = args->save            ? save(session, args, stop)
               : interrupt_pending() ? CMD_DONE
                                     : judge(session, args, stop);
    if (!may_go_on(stop) || !interrupt_pending())
        return code;
    return cmd_failed(session->command,
                      "interrupted; these are the accounts of the first %" PRIu64
                      " clock%s",
                      clocks, plural(clocks));
}

/* ---- The run ------------------------------------------------------------- */

static uint64_t find_limit(const struct run_arguments *args, const c205 *machine)
{
    return args->limit != C205_NO_LIMIT || args->no_limit
               ? args->limit
               : c205_clock(machine) + CMD_LIMIT;
}

/* Runs in slices, and checks for Ctrl-C between them. */
static c205_stop run_slices(c205 *machine, uint64_t limit)
{
    static const uint64_t slice = 5000000; /* clocks per slice */
    c205_stop stop;
    do {
        uint64_t left = limit - c205_clock(machine);
        bool last = limit < c205_clock(machine) || left <= slice;
        stop = c205_run(machine, last ? limit : c205_clock(machine) + slice);
    } while (stop.trap == C205_TRAP_CLOCK_LIMIT && c205_clock(machine) < limit
             && !interrupt_pending());
    return stop;
}

static int run(struct session *session, const struct run_arguments *args)
{
    c205 *machine = session->machine;
    struct command_output *results = &session->results;
    struct profile_view view = { args->in_order ? PROFILE_AS_WRITTEN : PROFILE_HOTTEST,
                                 false };
    struct runtime_checker *watch;
    struct line_tracker printed = { stream_sink(program_stream(results)), false };
    struct printer printer = { line_tracker_sink(&printed) };
    struct sink messages = { put_message, &printed };
    struct line_profile *profile = NULL;
    if (args->profile)
        profile = line_profile_new(session->object);
    c205_listen(machine, printer_listen, &printer);
    if (args->trace)
        c205_listen(machine, trace, &messages);
    if ((args->profile
         && (!profile || !c205_listen(machine, line_profile_listen, profile)))
        || !start_watch(session, args, &messages, &watch)) {
        line_profile_free(profile);
        return cmd_failed(session->command, "out of memory");
    }
    interrupt_catch();
    c205_stop stop = run_slices(machine, find_limit(args, machine));
    bool errors = watch && runtime_errors(watch) > 0;
    runtime_free(watch);
    line_tracker_close(&printed);
    int code = show_accounts(session, args, &stop);
    if (profile && code == CMD_DONE)
        code = line_profile_show(profile, view, results);
    line_profile_free(profile);
    code = output_close(results, code);
    int verdict = conclude(session, args, &stop);
    return code != CMD_DONE ? code : errors ? CMD_FAILED : verdict;
}

/* ---- The machine -------------------------------------------------------- */

/* Restores a saved machine. If the session has a program, the machine must be running
 * it. */
static bool restore(struct session *session, const char *path, c205_error *error)
{
    session->machine = state_load(path, session->model, error);
    if (session->machine && session->object
        && c205_loaded_program(session->machine)
               != c205_program_hash(&session->object->program))
        return error_set(error, "%.180s: the saved machine runs another program", path);
    return session->machine;
}

static bool make_machine(struct session *session, const struct run_arguments *args)
{
    c205_error error;
    if (!(args->restore ? restore(session, args->restore, &error)
                        : session_load(session, args->warm, &error))) {
        cmd_failed(session->command, "%s", error.message);
        return false;
    }
    if (args->profile && session->object->line_count == 0) {
        cmd_failed(
            session->command,
            "--profile: the source lines of %s are not known; run its program text",
            program_name(args));
        return false;
    }
    return true;
}

/* ---- The command -------------------------------------------------------- */

/* Checks the combination of arguments. Returns CMD_DONE if it is valid. */
static int check_usage(const struct run_arguments *args)
{
    const char *command = args->shared.command;
    bool state = args->save || args->restore;
    if (args->files.count == 0 && !args->restore)
        return cmd_usage(command, "FILE is missing");
    if (args->check) {
        return state ? cmd_usage(command,
                                 "--check cannot be combined with --save or --restore")
               : args->profile || args->warm
                   ? cmd_usage(command,
                               "--check cannot be combined with --profile or --warm")
                   : CMD_DONE;
    }
    if (args->files.count > 1) {
        return cmd_usage(command,
                         "expected one program, found also %s; --check runs several",
                         args->files.items[1]);
    }
    if (args->profile && args->restore)
        return cmd_usage(command, "--profile cannot be combined with --restore");
    if (args->in_order && !args->profile)
        return cmd_usage(command, "--in-order requires --profile");
    if (args->warm && args->restore)
        return cmd_usage(command, "--warm cannot be combined with --restore");
    if (args->save && args->limit == C205_NO_LIMIT)
        return cmd_usage(command, "--save requires --limit");
    return CMD_DONE;
}

static int cmd_run(void *given)
{
    const struct run_arguments *args = given;
    struct session session = { .command = args->shared.command };
    if (args->source.warnings.list)
        return cmd_list_warnings();
    int code = check_usage(args);
    if (code != CMD_DONE || args->check)
        return code == CMD_DONE ? cmd_run_check(args) : code;
    bool good = session_model(&session, args->shared.model)
                && (args->files.count == 0
                    || session_program(&session, &args->source, args->files.items[0]))
                && make_machine(&session, args)
                && session_output(&session, &args->shared.results, args->save);
    return session_close(&session, good ? run(&session, args) : CMD_FAILED);
}

#define PLACE(member) offsetof(struct run_arguments, member)

static const struct command_option options[] = {
    OPTION_FLAG("check", PLACE(check),
                "run test programs and print PASS or FAIL for each"),
    { OPTION_ROW("model", "NAME|FILE", COMMAND_INPUT, PLACE(shared.model),
                 "machine model (" C205_DEFAULT_MODEL
                 "; with --check that of the program)"),
      .choice = command_model_choice },
    { OPTION_ROW(
          "limit", "CLOCKS", COMMAND_CLOCKS, PLACE(limit),
          "stop the program after this number of clocks (1000000000, then it fails)"),
      .preset = -1 },
    OPTION_FLAG("no-limit", PLACE(no_limit), "run without a limit"),
    OPTION_FLAG("exit-status", PLACE(exit_status),
                "exit with the low 8 bits of the program's status"),
    { OPTION_ROW("save", "STATE", COMMAND_OUTPUT, PLACE(save),
                 "save the machine when the limit stops it") },
    { OPTION_ROW("restore", "STATE", COMMAND_INPUT, PLACE(restore),
                 "continue a saved program; a FILE must be that program") },
    CMD_WARN(PLACE(source)),
    CMD_DEFINE(PLACE(source)),
    CMD_INCLUDE(PLACE(source)),
    OPTION_FLAG("trace", PLACE(trace), "print each instruction as it is executed"),
    OPTION_FLAG(
        "profile", PLACE(profile),
        "also print the clocks of each line, the most expensive first; macros of "
        "other files at their calls; operations of forms.s with their form"),
    OPTION_FLAG("in-order", PLACE(in_order),
                "print the lines of --profile in the order of memory"),
    OPTION_FLAG("warm", PLACE(warm), "all pages are in memory when the program begins"),
    CMD_FIGURES,
    COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW("FILE", COMMAND_INPUT, PLACE(files),
                  "a program text, or an object of c205 asm; several with "
                  "--check"),
      .many = true, .optional = true },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "c205 run FILE", "run a program and account for its clocks" },
    { "c205 run --check FILE..", "run test programs" },
    { "c205 run --restore STATE [FILE]", "continue a saved program" },
    { NULL, NULL }
};

const struct command run_command = {
    COMMAND_ROW("run", cmd_run, struct run_arguments,
                "run a program and account for its clocks"),
    .examples = examples,
};
