/* cmd_debug.c - c205 debug: a program under control, by a person or a script. */
#include "asm/command/c205_command.h"
#include "asm/command/dialogue.h"
#include "base/interrupt.h"

static int debug_program(const struct c205_arguments *arguments,
                         const struct object *object, const c205_model *model)
{
    const struct debugger_setup setup = { .object = object,
                                          .name = arguments->file,
                                          .model = model,
                                          .out = stream_sink(stdout),
                                          .clocks_most = CMD_LIMIT,
                                          .interrupted = interrupt_came };
    const struct dialogue_setup dialogue = { .command = arguments->command,
                                             .prompt = "(c205) ",
                                             .verb = debugger_verb,
                                             .scripts = &arguments->scripts };
    c205_error error;
    struct debugger *debugger = debugger_new(&setup, &error);
    int code;
    if (!debugger) {
        return cmd_failed(arguments->command, "%s", error.message);
    }
    code = dialogue_hold(&dialogue, debugger);
    debugger_free(debugger);
    return code;
}

static int run(void *given)
{
    const struct c205_arguments *arguments = given;
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
      .help =
          "take the lines from there, and end with 1 if one of them fails, "
          "as an assert does" },
    CMD_MODEL,
    CMD_WARN,
    CMD_DEFINE,
    CMD_INCLUDE,
    COMMAND_END
};
static const struct command_option operands[] = { CMD_PROGRAM, COMMAND_END };
static const struct command_example examples[] = {
    { "c205 debug FILE", "go through a program, forward and back" },
    { "c205 debug -x SCRIPT FILE", "the same by a script" },
    { NULL, NULL }
};

const struct command debug_command = {
    .name = "debug",
    .summary = "go through a program, forward and back",
    .function = run,
    .options = options,
    .operands = operands,
    .examples = examples,
    .details =
        "On a terminal libedit, if it is installed, keeps the lines and "
        "completes. help tells the verbs.",
};
