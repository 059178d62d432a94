/* command.c - selects the command, runs it, and returns the exit code. */
#include "base/command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/command_rows.h"
#include "base/spelling.h"
#include "base/outputs.h"

static bool is_one_command(const struct command_program *program)
{
    return program->commands[0]->name == NULL;
}

void command_full_name(const struct command_program *program,
                       const struct command *command, char name[COMMAND_NAME_SIZE])
{
    bool has_name = command && command->name;
    snprintf(name, COMMAND_NAME_SIZE, "%s%s%s", program->name, has_name ? " " : "",
             has_name ? command->name : "");
}

const struct command *command_named(const struct command_program *program,
                                    const char *name)
{
    const struct command *const *command = program->commands;
    while (*command && strcmp((*command)->name, name) != 0)
        command++;
    return *command;
}

static int print_version(const struct command_program *program)
{
    printf("%s %s\n", program->name, program->version);
    return CMD_DONE;
}

static int finish_command(const char *name, int code)
{
    if (fflush(stdout) != 0 || ferror(stdout))
        return cmd_failed(name, "cannot write standard output: write error");
    return code;
}

/* ---- Selecting a command ------------------------------------------------ */

static int no_command(const struct command_program *program, const char *word)
{
    struct spelling nearest = { .word = word };
    const struct command *const *command = program->commands;
    for (; *command; command++)
        spelling_try(&nearest, (*command)->name);
    cmd_print_line(stderr,
                   nearest.name ? "%s: unknown command '%s'; did you mean '%s'?"
                                : "%s: unknown command '%s'",
                   program->name, word, nearest.name);
    putc('\n', stderr);
    command_print_summary(program, stderr);
    return CMD_USAGE;
}

/* Executes "help" and "help COMMAND". */
static int help(const struct command_program *program, int argc, char **argv)
{
    if (argc < 2) {
        command_print_summary(program, stdout);
        return CMD_DONE;
    }
    const struct command *command = command_named(program, argv[1]);
    if (!command)
        return no_command(program, argv[1]);
    command_print_help(program, command, stdout);
    return CMD_DONE;
}

static bool is_option(const char *word, const struct command_option *option)
{
    return (word[0] == '-' && word[1] == '-' && strcmp(word + 2, option->name) == 0)
           || (option->letter && word[0] == '-' && word[1] == option->letter
               && word[2] == '\0');
}

/* Returns true for "help --man" and similar requests of scripts. The help does not list
 * them. */
static bool asks_for_page(int argc, char **argv)
{
    return argc > 2 && strcmp(argv[1], "help") == 0 && strncmp(argv[2], "--", 2) == 0;
}

/* Returns the command that the command line selects. If the line requests help, the
 * version or a page, or is wrong, performs the request, sets *code and returns NULL. */
static const struct command *select_command(const struct command_program *program,
                                            int argc, char **argv, int *code)
{
    const struct command *command = NULL;
    if (asks_for_page(argc, argv)) {
        *code = command_print_page(program, argc - 2, argv + 2);
    } else if (is_one_command(program)) {
        command = program->commands[0];
    } else if (argc < 2) {
        command_print_summary(program, stderr);
        *code = CMD_USAGE;
    } else if (is_option(argv[1], &command_version_option)) {
        *code = print_version(program);
    } else if (is_option(argv[1], &command_help_option)
               || strcmp(argv[1], "help") == 0) {
        *code = help(program, argc - 1, argv + 1);
    } else {
        command = command_named(program, argv[1]);
        if (!command)
            *code = no_command(program, argv[1]);
    }
    return command;
}

int command_main(const struct command_program *program, int argc, char **argv)
{
    int code = CMD_DONE;
    const struct command *command = select_command(program, argc, argv, &code);
    if (!command)
        return finish_command(program->name, code);
    char name[COMMAND_NAME_SIZE];
    const char *full_name = name;
    int words = command->name ? 1 : 0; /* number of words before the arguments of the
                                          command */
    void *arguments = calloc(1, command->arguments_size);
    command_full_name(program, command, name);
    if (!arguments)
        return cmd_failed(name, "out of memory");
    memcpy(arguments, &full_name, sizeof full_name);
    code = command_parse(program, command, argc - words, argv + words, arguments);
    if (code == CMD_DONE) {
        code = command->function(arguments);
    } else if (code == COMMAND_ASKS_HELP) {
        command_print_help(program, command, stdout);
        code = CMD_DONE;
    } else if (code == COMMAND_ASKS_VERSION) {
        code = print_version(program);
    }
    command_free(command, arguments);
    outputs_clear();
    free(arguments);
    return finish_command(name, code);
}
