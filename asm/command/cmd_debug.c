/* cmd_debug.c - c205 debug: runs the debugger for a user, a script or an editor. */
#include <limits.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "asm/command/repl.h"
#include "asm/command/session.h"
#include "asm/dap/dap.h"
#include "base/file.h"

struct debug_arguments {
    struct shared_arguments shared;
    struct source_arguments source;
    const char *file;
    struct command_texts scripts;
    bool dap, warm;
};

/* ---- An editor ------------------------------------------------------------- */

static size_t read_stdin(void *context, char *bytes, size_t most)
{
    ssize_t length = read(STDIN_FILENO, bytes, most);
    (void)context;
    return length > 0 ? (size_t)length : 0;
}

static bool is_ready(void *context)
{
    struct pollfd input = { .fd = STDIN_FILENO, .events = POLLIN };
    (void)context;
    return poll(&input, 1, 0) > 0;
}

static void put(void *context, const char *text, size_t length)
{
    (void)context;
    fwrite(text, 1, length, stdout);
    fflush(stdout);
}

/* Finds a model. It cannot be read from stdin, because messages arrive there. */
static c205_model *find_model(const char *name, const struct sink *report)
{
    c205_error error = { "a model cannot be read from stdin with --dap" };
    c205_model *model = file_is_stream(name) ? NULL : c205_model_find(name, &error);
    if (!model)
        sink_print(report, "%s\n", error.message);
    return model;
}

/* Adds a definition, which replaces an earlier definition of the same name. */
static bool add_define(struct cmd_defines *defines, const struct asm_define *define)
{
    size_t i = 0;
    while (i < defines->count && strcmp(defines->items[i].name, define->name) != 0)
        i++;
    if (i == CMD_DEFINES)
        return false;
    defines->count += i == defines->count;
    defines->items[i] = *define;
    return true;
}

/* Opens the program of a launch request. Arguments of the request override the command
 * line. */
static bool open_program(void *context, const struct dap_program *program,
                         const struct sink *report, struct object **object,
                         c205_model **model)
{
    struct debug_arguments args = *(const struct debug_arguments *)context;
    for (const struct asm_define *define = program->defines; define->name; define++) {
        if (!add_define(&args.source.defines, define)) {
            sink_print(report, "more than %d names are defined\n", CMD_DEFINES);
            return false;
        }
    }
    if (*program->search)
        args.source.folders.items = (const char **)program->search;
    *object = cmd_read_program(&args.source, program->path, report);
    if (!*object)
        return false;
    *model = find_model(program->model ? program->model : args.shared.model, report);
    return *model;
}

static int serve_editor(const struct debug_arguments *args)
{
    char folder[PATH_MAX];
    struct debug_arguments copy = *args;
    struct dap_setup setup = { .read = read_stdin,
                               .ready = is_ready,
                               .open = open_program,
                               .context = &copy,
                               .out = { put, NULL },
                               .program = args->file,
                               .folder = getcwd(folder, sizeof folder) ? folder : "",
                               .warm = args->warm,
                               .clocks_most = UINT64_MAX };
    c205_error error;
    return dap_serve(&setup, &error)
               ? CMD_DONE
               : cmd_failed(args->shared.command, "%s", error.message);
}

/* ---- A user or a script ---------------------------------------------------- */

static int debug(const struct session *session, const struct debug_arguments *args)
{
    const struct debugger_setup setup = { .object = session->object,
                                          .name = args->file,
                                          .model = session->model,
                                          .out = visible_stream(stdout),
                                          .printed = stream_sink(stdout),
                                          .clocks_most = CMD_LIMIT,
                                          .interrupted = repl_interrupted,
                                          .warm = args->warm };
    const struct repl_setup repl = { .command = args->shared.command,
                                     .prompt = "(c205) ",
                                     .verb = debugger_verb,
                                     .scripts = &args->scripts };
    return repl_run(&repl, &setup);
}

static int cmd_debug(void *given)
{
    const struct debug_arguments *args = given;
    struct session session = { .command = args->shared.command };
    if (args->dap && args->scripts.count > 0) {
        return cmd_usage(args->shared.command,
                         "--dap cannot be combined with --script");
    }
    if (args->dap)
        return serve_editor(args);
    if (!args->file) {
        return cmd_usage(args->shared.command,
                         "FILE is missing; it is optional only with --dap");
    }
    bool good = session_program(&session, &args->source, args->file)
                && session_model(&session, args->shared.model);
    return session_close(&session, good ? debug(&session, args) : CMD_FAILED);
}

#define PLACE(member) offsetof(struct debug_arguments, member)

static const struct command_option options[] = {
    { OPTION_ROW(
          "script", "FILE", COMMAND_INPUT, PLACE(scripts),
          "read lines from FILE; the exit status is 1 if one of them fails, such "
          "as an assert"),
      .letter = 'x', .many = true },
    CMD_MODEL,
    CMD_WARN(PLACE(source)),
    OPTION_FLAG("dap", PLACE(dap),
                "speak the Debug Adapter Protocol on stdin and stdout, for "
                "editors"),
    OPTION_FLAG("warm", PLACE(warm), "all pages are in memory when the program begins"),
    CMD_DEFINE(PLACE(source)),
    CMD_INCLUDE(PLACE(source)),
    COMMAND_END
};
static const struct command_option operands[] = {
    { OPERAND_ROW("FILE", COMMAND_INPUT, PLACE(file),
                  "a program text, or an object of c205 asm; with --dap the "
                  "editor may name it"),
      .optional = true },
    COMMAND_END
};
static const struct command_example examples[] = {
    { "c205 debug FILE", "step through a program, forward and back" },
    { "c205 debug -x SCRIPT FILE", "do the same with a script" },
    { "c205 debug --dap", "do the same for an editor" },
    { NULL, NULL }
};

const struct command debug_command = {
    COMMAND_ROW("debug", cmd_debug, struct debug_arguments,
                "step through a program, forward and back"),
    .examples = examples,
    .details =
        "On a terminal libedit, if it is installed, provides history and completion. "
        "The verb help lists all verbs.",
};
