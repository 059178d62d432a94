/* cmd_debug.c - c205 debug: the debugger for a user or a script. */
#include "asm/command/cmd_debug.h"
#include "asm/command/repl.h"

static int debug_program(const struct c205_arguments *arguments,
                         const struct object *object, const c205_model *model)
{
    const struct debugger_setup setup = { .object = object,
                                          .name = arguments->file,
                                          .model = model,
                                          .out = visible_stream(stdout),
                                          .printed = stream_sink(stdout),
                                          .clocks_most = CMD_LIMIT,
                                          .interrupted = repl_interrupted,
                                          .warm = arguments->warm };
    const struct repl_setup repl = { .command = arguments->command,
                                     .prompt = "(c205) ",
                                     .verb = debugger_verb,
                                     .scripts = &arguments->scripts };
    c205_error error;
    struct debugger *debugger = debugger_new(&setup, &error);
    int code;
    if (!debugger) {
        return cmd_failed(arguments->command, "%s", error.message);
    }
    code = repl_hold(&repl, debugger);
    debugger_free(debugger);
    return code;
}

static int run(void *given)
{
    const struct c205_arguments *arguments = given;
    if (arguments->dap && arguments->scripts.count > 0) {
        return cmd_usage(arguments->command, "--dap cannot be combined with --script");
    }
    if (arguments->dap) {
        return cmd_debug_dap(arguments);
    }
    if (!arguments->file) {
        return cmd_usage(arguments->command,
                         "FILE is missing; it is optional only with --dap");
    }
    struct object *object;
    c205_model *model;
    int code = cmd_open(arguments, &object, &model)
                   ? debug_program(arguments, object, model)
                   : CMD_FAILED;
    c205_model_free(model);
    object_free(object);
    return code;
}

static const struct command_option options[] = {
    { .name = "script",
      .letter = 'x',
      .value = "FILE",
      .kind = COMMAND_INPUT,
      .many = true,
      .offset = CMD_PLACE(scripts),
      .help = "read lines from FILE; the exit status is 1 if one of them fails, such "
              "as an assert" },
    CMD_MODEL,
    CMD_WARN,
    CMD_FLAG(dap, "speak the Debug Adapter Protocol on stdin and stdout, for "
                  "editors"),
    CMD_FLAG(warm, "all pages are in memory when the program begins"),
    CMD_DEFINE,
    CMD_INCLUDE,
    COMMAND_END
};
static const struct command_option operands[] = {
    { .value = "FILE",
      .kind = COMMAND_INPUT,
      .optional = true,
      .offset = CMD_PLACE(file),
      .help = "a program text, or an object of c205 asm; with --dap the "
              "editor may name it" },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "c205 debug FILE", "step through a program, forward and back" },
    { "c205 debug -x SCRIPT FILE", "do the same with a script" },
    { "c205 debug --dap", "do the same for an editor" },
    { NULL, NULL }
};

const struct command debug_command = {
    .name = "debug",
    .summary = "step through a program, forward and back",
    .function = run,
    .arguments_size = sizeof(struct c205_arguments),
    .options = options,
    .operands = operands,
    .examples = examples,
    .details =
        "On a terminal libedit, if it is installed, provides history and completion. "
        "The verb help lists all verbs.",
};
