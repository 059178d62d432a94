/* cmd_run.c - c205 run: runs a program and attributes its clocks. */
#include <inttypes.h>

#include "asm/check/runtime_check.h"
#include "asm/command/c205_command.h"
#include "asm/measure/line_profile.h"
#include "asm/object/disassemble.h"
#include "asm/view/operand_view.h"
#include "asm/view/print.h"
#include "asm/view/state.h"
#include "asm/view/trap_report.h"
#include "base/accounts_show.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/plural.h"

static void trace(void *context, const c205 *machine, const c205_event *event)
{
    char text[DISASSEMBLE_TEXT_SIZE];
    if (event->kind != C205_EVENT_INSTRUCTION && event->kind != C205_EVENT_REQUEST) {
        return;
    }
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

static const char *program_name(const struct c205_arguments *arguments)
{
    return arguments->files.count ? arguments->files.items[0] : arguments->restore;
}

static int show_profile(const struct c205_arguments *arguments,
                        const struct line_profile *profile,
                        const struct command_output *results)
{
    struct profile_view view = { arguments->in_order ? PROFILE_AS_WRITTEN
                                                     : PROFILE_HOTTEST,
                                 false };
    return line_profile_show(profile, view, results);
}

static int show_accounts(const struct c205_arguments *arguments, const c205 *machine,
                         const c205_stop *stop, const struct command_output *results)
{
    const c205_model *model = c205_machine_model(machine);
    struct accounts accounts = { .model = model };
    char time[ACCOUNTS_TIME];
    if (!accounts_add(&accounts, machine)) {
        accounts_free(&accounts);
        return cmd_failed(arguments->command, "out of memory");
    }
    if (results->json) {
        json_text(results->json, "program", program_name(arguments));
        provenance_json(model, results->json);
        stop_json(machine, stop, results->json);
    }
    accounts_time(model, c205_clock(machine), time);
    output_printf(results, "%" PRIu64 " clock%s, %s\n", c205_clock(machine),
                  plural(c205_clock(machine)), time);
    int code = accounts_show(&accounts, results);
    output_model(results, model);
    accounts_free(&accounts);
    return code;
}

/* ---- The end of a run ---------------------------------------------------- */

/* Returns the exit code. */
static int judge_trap(const struct c205_arguments *arguments,
                      const struct object *object, const c205 *machine,
                      const c205_stop *stop)
{
    struct sink report = visible_stream(stderr);
    fflush(stdout);
    trap_report(object, program_name(arguments), machine, stop, &report);
    if (stop->trap == C205_TRAP_CLOCK_LIMIT && arguments->limit == C205_NO_LIMIT) {
        return cmd_failed(
            arguments->command,
            "stopped after %" PRIu64
            " clocks: if the program is not in an endless loop, use --limit CLOCKS "
            "or --no-limit",
            CMD_LIMIT);
    }
    return CMD_FAILED;
}

static int judge(const struct c205_arguments *arguments, const struct object *object,
                 const c205 *machine, const c205_stop *stop)
{
    enum { STATUS = 0xFF };
    if (stop->trap != C205_TRAP_NONE) {
        return judge_trap(arguments, object, machine, stop);
    }
    if (arguments->exit_status) {
        return (int)(stop->status & STATUS);
    }
    if (stop->status != 0) {
        return cmd_failed(arguments->command, "the program ended with status %" PRId64,
                          stop->status);
    }
    return CMD_DONE;
}

static bool may_go_on(const c205_stop *stop)
{
    return stop->trap == C205_TRAP_CLOCK_LIMIT;
}

static int save(const struct c205_arguments *arguments, const struct object *object,
                const c205 *machine, const c205_stop *stop,
                const struct command_output *results)
{
    c205_error error;
    if (!may_go_on(stop)) {
        fprintf(stderr,
                "c205 run: the program did not reach the limit; nothing is saved\n");
        return judge(arguments, object, machine, stop);
    }
    if (!state_save(machine, arguments->save, &error)) {
        return cmd_failed(arguments->command, "%s", error.message);
    }
    output_printf(results, "stopped by %s, and saved as %s\n",
                  interrupt_pending() ? "Ctrl-C" : "the limit", arguments->save);
    return CMD_DONE;
}

/* The output of the program is part of results in text. It would corrupt any other
 * format, so it is then written to stderr. */
static FILE *program_stream(const struct command_output *results)
{
    bool among = results->file == stdout && results->format == OUTPUT_TEXT;
    return among ? stdout : stderr;
}

/* Prints a message on stderr, after closing a line that the program
 * has left open there. */
static void put_message(void *context, const char *text, size_t length)
{
    struct sink report = visible_stream(stderr);
    struct line_tracker *printed = context;
    if (printed->to.context == stderr) {
        line_tracker_close(printed);
    }
    report.put(report.context, text, length);
}

/* Starts the runtime checks if the object is known and any warning is enabled. */
static bool start_watch(const struct c205_arguments *arguments, c205 *machine,
                        const struct object *object, const struct sink *report,
                        struct runtime_checker **watch)
{
    const struct warning_choice *choice = &arguments->warnings.choice;
    *watch = NULL;
    if (!object || !warning_any(choice)) {
        return true;
    }
    *watch = runtime_new(object, program_name(arguments), choice, report);
    if (!*watch || !c205_listen(machine, runtime_listen, *watch)) {
        return false;
    }
    runtime_begin(*watch, machine);
    return true;
}

/* Reports an interruption after the results, so that it is not overlooked. */
static int conclude(const struct c205_arguments *arguments, const struct object *object,
                    const c205 *machine, const c205_stop *stop,
                    const struct command_output *results)
{
    int code = arguments->save       ? save(arguments, object, machine, stop, results)
               : interrupt_pending() ? CMD_DONE
                                     : judge(arguments, object, machine, stop);
    if (!may_go_on(stop) || !interrupt_pending()) {
        return code;
    }
    return cmd_failed(arguments->command,
                      "interrupted; these are the accounts of the first "
                      "%" PRIu64 " clock%s",
                      c205_clock(machine), plural(c205_clock(machine)));
}

/* ---- The run ------------------------------------------------------------- */

static uint64_t find_limit(const struct c205_arguments *arguments, const c205 *machine)
{
    return arguments->limit != C205_NO_LIMIT || arguments->no_limit
               ? arguments->limit
               : c205_clock(machine) + CMD_LIMIT;
}

/* Runs in slices, and checks for Ctrl-C between them. */
static c205_stop run_slices(c205 *machine, uint64_t limit)
{
    static const uint64_t slice = 5000000; /* clocks */
    c205_stop stop;
    do {
        uint64_t left = limit - c205_clock(machine);
        bool last = limit < c205_clock(machine) || left <= slice;
        stop = c205_run(machine, last ? limit : c205_clock(machine) + slice);
    } while (stop.trap == C205_TRAP_CLOCK_LIMIT && c205_clock(machine) < limit
             && !interrupt_pending());
    return stop;
}

static int run(const struct c205_arguments *arguments, c205 *machine,
               const struct object *object)
{
    struct runtime_checker *watch;
    struct command_output results = arguments->results;
    if (!output_open(&results, arguments->command, arguments->save)) {
        return CMD_FAILED;
    }
    struct line_tracker printed = { stream_sink(program_stream(&results)), false };
    struct printer printer = { line_tracker_sink(&printed) };
    struct sink messages = { put_message, &printed };
    struct line_profile *profile = NULL;
    if (arguments->profile) {
        profile = line_profile_new(object);
    }
    c205_listen(machine, printer_listen, &printer);
    if (arguments->trace) {
        c205_listen(machine, trace, &messages);
    }
    if ((arguments->profile
         && (!profile || !c205_listen(machine, line_profile_listen, profile)))
        || !start_watch(arguments, machine, object, &messages, &watch)) {
        output_close(&results, CMD_FAILED);
        line_profile_free(profile);
        return cmd_failed(arguments->command, "out of memory");
    }
    interrupt_catch();
    c205_stop stop = run_slices(machine, find_limit(arguments, machine));
    bool errors = watch && runtime_errors(watch) > 0;
    runtime_free(watch);
    line_tracker_close(&printed);
    int code = show_accounts(arguments, machine, &stop, &results);
    if (profile && code == CMD_DONE) {
        code = show_profile(arguments, profile, &results);
    }
    line_profile_free(profile);
    code = output_close(&results, code);
    int verdict = conclude(arguments, object, machine, &stop, &results);
    return code != CMD_DONE ? code : errors ? CMD_FAILED : verdict;
}

/* ---- The machine -------------------------------------------------------- */

/* Restores a saved machine. object: NULL, or the program that it must be running. */
static c205 *restore(const char *path, const c205_model *model,
                     const struct object *object, c205_error *error)
{
    c205 *machine = state_load(path, model, error);
    if (machine && object
        && c205_loaded_program(machine) != c205_program_hash(&object->program)) {
        error_set(error, "%.180s: the saved machine runs another program", path);
        c205_free(machine);
        return NULL;
    }
    return machine;
}

static int make_and_run(const struct c205_arguments *arguments, const c205_model *model,
                        const struct object *object)
{
    c205_error error;
    c205 *machine = arguments->restore
                        ? restore(arguments->restore, model, object, &error)
                        : cmd_load(arguments, object, model, &error);
    if (!machine) {
        return cmd_failed(arguments->command, "%s", error.message);
    }
    if (arguments->profile && object->line_count == 0) {
        c205_free(machine);
        return cmd_failed(
            arguments->command,
            "--profile: the source lines of %s are not known; run its program text",
            program_name(arguments));
    }
    int code = run(arguments, machine, object);
    c205_free(machine);
    return code;
}

static int read_and_run(const struct c205_arguments *arguments, const c205_model *model)
{
    struct sink report = visible_stream(stderr);
    if (arguments->files.count == 0) {
        return make_and_run(arguments, model, NULL);
    }
    struct object *object = cmd_read_program(arguments, arguments->files.items[0],
                                             &report);
    int code = object ? make_and_run(arguments, model, object) : CMD_FAILED;
    object_free(object);
    return code;
}

/* Returns CMD_DONE if the combination of arguments is valid. */
static int check_usage(const struct c205_arguments *arguments)
{
    const char *command = arguments->command;
    bool state = arguments->save || arguments->restore;
    if (arguments->files.count == 0 && !arguments->restore) {
        return cmd_usage(command, "FILE is missing");
    }
    if (arguments->check) {
        return state ? cmd_usage(command,
                                 "--check cannot be combined with --save or --restore")
               : arguments->profile || arguments->warm
                   ? cmd_usage(command,
                               "--check cannot be combined with --profile or --warm")
                   : CMD_DONE;
    }
    if (arguments->files.count > 1) {
        return cmd_usage(command,
                         "expected one program, found also %s; --check runs several",
                         arguments->files.items[1]);
    }
    if (arguments->profile && arguments->restore) {
        return cmd_usage(command, "--profile cannot be combined with --restore");
    }
    if (arguments->in_order && !arguments->profile) {
        return cmd_usage(command, "--in-order requires --profile");
    }
    if (arguments->warm && arguments->restore) {
        return cmd_usage(command, "--warm cannot be combined with --restore");
    }
    if (arguments->save && arguments->limit == C205_NO_LIMIT) {
        return cmd_usage(command, "--save requires --limit");
    }
    return CMD_DONE;
}

static int run_command_line(void *given)
{
    const struct c205_arguments *arguments = given;
    if (arguments->warnings.list) {
        return cmd_list_warnings();
    }
    int code = check_usage(arguments);
    if (code != CMD_DONE) {
        return code;
    }
    if (arguments->check) {
        return cmd_run_check(arguments);
    }
    c205_model *model = model_open(arguments->command, arguments->model);
    code = model ? read_and_run(arguments, model) : CMD_FAILED;
    c205_model_free(model);
    return code;
}

static const struct command_option options[] = {
    CMD_FLAG(check, "run test programs and print PASS or FAIL for each"),
    { .name = "model",
      .value = "NAME|FILE",
      .kind = COMMAND_INPUT,
      .offset = CMD_PLACE(model),
      .choice = command_model_choice,
      .help = "machine model (" C205_DEFAULT_MODEL
              "; with --check that of the program)" },
    { .name = "limit",
      .value = "CLOCKS",
      .kind = COMMAND_CLOCKS,
      .offset = CMD_PLACE(limit),
      .preset = -1,
      .help =
          "stop the program after this number of clocks (1000000000, then it fails)" },
    { .name = "no-limit",
      .kind = COMMAND_FLAG,
      .offset = CMD_PLACE(no_limit),
      .help = "run without a limit" },
    { .name = "exit-status",
      .kind = COMMAND_FLAG,
      .offset = CMD_PLACE(exit_status),
      .help = "exit with the low 8 bits of the program's status" },
    { .name = "save",
      .value = "STATE",
      .kind = COMMAND_OUTPUT,
      .offset = CMD_PLACE(save),
      .help = "save the machine when the limit stops it" },
    { .name = "restore",
      .value = "STATE",
      .kind = COMMAND_INPUT,
      .offset = CMD_PLACE(restore),
      .help = "continue a saved program; a FILE must be that program" },
    CMD_WARN,
    CMD_DEFINE,
    CMD_INCLUDE,
    CMD_FLAG(trace, "print each instruction as it is executed"),
    CMD_FLAG(profile,
             "also print the clocks of each line, the most expensive first; macros at "
             "their calls"),
    { .name = "in-order",
      .kind = COMMAND_FLAG,
      .offset = CMD_PLACE(in_order),
      .help = "print the lines of --profile in the order of memory" },
    CMD_FLAG(warm, "all pages are in memory when the program begins"),
    CMD_FIGURES,
    COMMAND_END
};
static const struct command_option operands[] = {
    { .value = "FILE",
      .kind = COMMAND_INPUT,
      .many = true,
      .optional = true,
      .offset = CMD_PLACE(files),
      .help = "a program text, or an object of c205 asm; several with "
              "--check" },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "c205 run FILE", "run a program and account for its clocks" },
    { "c205 run --check FILE..", "run test programs" },
    { "c205 run --restore STATE [FILE]", "continue a saved program" },
    { NULL, NULL }
};

const struct command run_command = {
    .name = "run",
    .summary = "run a program and account for its clocks",
    .function = run_command_line,
    .arguments_size = sizeof(struct c205_arguments),
    .options = options,
    .operands = operands,
    .examples = examples,
};
