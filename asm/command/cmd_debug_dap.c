/* cmd_debug_dap.c - c205 debug --dap: serves an editor on stdin and stdout.
 */
#include "asm/command/cmd_debug.h"

#include <limits.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "asm/dap/dap.h"
#include "base/file.h"

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

/* Finds a model. It cannot be read from stdin, which carries the messages. */
static c205_model *find_model(const char *name, const struct sink *report)
{
    c205_error error = { "a model cannot be read from stdin with --dap" };
    c205_model *model = file_is_stream(name) ? NULL : c205_model_find(name, &error);
    if (!model) {
        sink_print(report, "%s\n", error.message);
    }
    return model;
}

/* Adds a definition; it replaces an earlier one of the same name. */
static bool add_define(struct cmd_defines *defines, const struct asm_define *define)
{
    size_t i = 0;
    while (i < defines->count && strcmp(defines->items[i].name, define->name) != 0) {
        i++;
    }
    if (i == CMD_DEFINES) {
        return false;
    }
    defines->count += i == defines->count;
    defines->items[i] = *define;
    return true;
}

/* Opens the program of a launch request. Arguments of the request
 * override the command line. */
static bool open_program(void *context, const struct dap_program *program,
                         const struct sink *report, struct object **object,
                         c205_model **model)
{
    struct c205_arguments arguments = *(const struct c205_arguments *)context;
    for (const struct asm_define *define = program->defines; define->name; define++) {
        if (!add_define(&arguments.defines, define)) {
            sink_print(report, "more than %d names are defined\n", CMD_DEFINES);
            return false;
        }
    }
    if (*program->search) {
        arguments.folders.items = (const char **)program->search;
    }
    *object = cmd_read_program(&arguments, program->path, report);
    if (!*object) {
        return false;
    }
    *model = find_model(program->model ? program->model : arguments.model, report);
    return *model;
}

int cmd_debug_dap(const struct c205_arguments *arguments)
{
    char folder[PATH_MAX];
    struct c205_arguments copy = *arguments;
    struct dap_setup setup = { .read = read_stdin,
                               .ready = is_ready,
                               .open = open_program,
                               .context = &copy,
                               .out = { put, NULL },
                               .program = arguments->file,
                               .folder = getcwd(folder, sizeof folder) ? folder : "",
                               .warm = arguments->warm,
                               .clocks_most = UINT64_MAX };
    c205_error error;
    return dap_serve(&setup, &error)
               ? CMD_DONE
               : cmd_failed(arguments->command, "%s", error.message);
}
