/* command_pages.c - prints the list of options for scripts, and the man page. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "base/command_rows.h"

/* Prints a page for make and the tests. The command line selects it, as in "help
 * --man". */
int command_print_page(const struct command_program *program, int argc, char **argv)
{
    static const struct {
        const char *option, *shell; /* shell: argument of the option, or NULL */
        void (*print)(const struct command_program *program, FILE *file);
    } pages[] = {
        { "--list", NULL, command_print_list },
        { "--man", NULL, command_print_man },
        { "--completion", "bash", command_print_bash },
        { "--completion", "zsh", command_print_zsh },
        { "--completion", "fish", command_print_fish },
    };
    const char *shell = argc > 1 ? argv[1] : "";
    if (strcmp(argv[0], "--complete") == 0)
        return command_complete(program, argc - 1, argv + 1);
    for (size_t i = 0; i < sizeof pages / sizeof *pages; i++) {
        if (strcmp(argv[0], pages[i].option) == 0
            && (!pages[i].shell || strcmp(shell, pages[i].shell) == 0)) {
            pages[i].print(program, stdout);
            return CMD_DONE;
        }
    }
    fprintf(stderr,
            "%s help: --list, --man or --completion bash, zsh or "
            "fish\n",
            program->name);
    return CMD_USAGE;
}

/* ---- The list ----------------------------------------------------------- */

/* Prints the rows as lines such as "option run --limit - clocks": "option" or
 * "operand", the command ("-" if it has no name), the name, the letter or "-", the
 * kind, and the choices. */
static void list_rows(FILE *file, const char *what, const char *command,
                      const struct command_option *row)
{
    static const char *const kinds[] = {
        [COMMAND_FLAG] = "flag",     [COMMAND_TEXT] = "text",
        [COMMAND_COUNT] = "count",   [COMMAND_CLOCKS] = "clocks",
        [COMMAND_NUMBER] = "number", [COMMAND_CHOICE] = "choice",
        [COMMAND_INPUT] = "input",   [COMMAND_OUTPUT] = "output",
        [COMMAND_FILE] = "file",     [COMMAND_FOLDER] = "folder",
        [COMMAND_CUSTOM] = "own"
    };
    for (; command_is_row(row); row++) {
        const char *name;
        fprintf(file, "%s %s %s%s %c %s", what, command, row->name ? "--" : "",
                row->name ? row->name : row->value, row->letter ? row->letter : '-',
                kinds[row->kind]);
        for (size_t i = 0; row->kind == COMMAND_CHOICE; i++) {
            i = command_next_choice(row->choice, i, &name);
            if (!name)
                break;
            fprintf(file, " %s", name);
        }
        putc('\n', file);
    }
}

void command_print_list(const struct command_program *program, FILE *file)
{
    const struct command *const *command = program->commands;
    for (; *command; command++) {
        const char *name = (*command)->name ? (*command)->name : "-";
        fprintf(file, "command %s\n", name);
        list_rows(file, "option", name, (*command)->options);
        list_rows(file, "operand", name, (*command)->operands);
    }
}

/* ---- The man page ------------------------------------------------------- */

/* Writes a text for roff. Characters that roff would interpret are escaped. */
static void put_roff(FILE *file, const char *text)
{
    for (const char *c = text; *c; c++) {
        if ((*c == '.' || *c == '\'') && (c == text || c[-1] == '\n'))
            fputs("\\&", file);
        switch (*c) {
        case '\\': fputs("\\e", file); break;
        case '-': fputs("\\-", file); break;
        default: putc(*c, file);
        }
    }
}

static void put_capitals(FILE *file, const char *text)
{
    for (; *text; text++)
        putc(toupper((unsigned char)*text), file);
}

static void put_roff_name(FILE *file, const struct command_option *option)
{
    fputs(".TP\n", file);
    if (option->letter)
        fprintf(file, "\\fB\\-%c\\fR, ", option->letter);
    if (option->name) {
        fputs("\\fB\\-\\-", file);
        put_roff(file, option->name);
        fputs("\\fR", file);
    }
    if (option->value) {
        fputs(option->name ? " \\fI" : "\\fI", file);
        put_roff(file, option->value);
        fputs("\\fR", file);
    }
    putc('\n', file);
}

static void put_roff_row(FILE *file, const struct command_option *row)
{
    struct text_buffer meaning = { NULL, 0, 0, false };
    struct sink sink = text_buffer_sink(&meaning);
    put_roff_name(file, row);
    command_option_meaning(row, &sink);
    put_roff(file, meaning.text ? meaning.text : "");
    putc('\n', file);
    text_buffer_free(&meaning);
}

static void put_roff_rows(FILE *file, const struct command_option *row)
{
    for (; command_is_row(row); row++)
        put_roff_row(file, row);
}

static void put_roff_synopsis(FILE *file, const char *name,
                              const struct command *command)
{
    const struct command_option *row = command->operands;
    fputs("\\fB", file);
    put_roff(file, name);
    fputs("\\fR [\\fIOPTION\\fR]...", file);
    for (; command_is_row(row); row++) {
        fprintf(file, row->optional ? " [\\fI" : " \\fI");
        put_roff(file, row->value);
        fprintf(file, "\\fR%s%s", row->many ? "..." : "", row->optional ? "]" : "");
    }
    putc('\n', file);
}

static void put_roff_examples(FILE *file, const struct command_example *example)
{
    for (; example && example->line; example++) {
        fputs(".TP\n\\fB", file);
        put_roff(file, example->line);
        fputs("\\fR\n", file);
        put_roff(file, example->meaning);
        putc('\n', file);
    }
}

static void put_roff_command(FILE *file, const struct command_program *program,
                             const struct command *command)
{
    char name[COMMAND_NAME_SIZE];
    command_full_name(program, command, name);
    if (command->name) {
        fputs(".SS ", file);
        put_roff(file, name);
        fputs("\n", file);
        put_roff_synopsis(file, name, command);
        fputs(".PP\n", file);
        put_roff(file, command->summary);
        fputs(".\n", file);
    }
    if (command->details) {
        fputs(".PP\n", file);
        put_roff(file, command->details);
        putc('\n', file);
    }
    put_roff_rows(file, command->operands);
    put_roff_rows(file, command->options);
    put_roff_row(file, &command_help_option);
    put_roff_row(file, &command_version_option);
}

/* Prints the examples of all commands together. */
static void put_roff_all_examples(FILE *file, const struct command_program *program)
{
    const struct command *const *command = program->commands;
    const char *heading = ".SH EXAMPLES\n";
    for (; *command; command++) {
        if ((*command)->examples) {
            fputs(heading, file);
            put_roff_examples(file, (*command)->examples);
            heading = "";
        }
    }
}

static void put_roff_head(FILE *file, const struct command_program *program)
{
    const struct command *first = program->commands[0];
    fputs(".TH ", file);
    put_capitals(file, program->name);
    fprintf(file, " 1 \"\" \"%s %s\" \"User Commands\"\n", program->name,
            program->version);
    fprintf(file, ".SH NAME\n%s \\- ", program->name);
    put_roff(file, program->summary);
    fputs("\n.SH SYNOPSIS\n", file);
    if (!first->name) {
        put_roff_synopsis(file, program->name, first);
        return;
    }
    fprintf(file,
            "\\fB%s\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR]... "
            "[\\fIARGUMENT\\fR]...\n.br\n"
            "\\fB%s help\\fR [\\fICOMMAND\\fR]\n.br\n"
            "\\fB%s \\-\\-version\\fR\n",
            program->name, program->name, program->name);
}

void command_print_man(const struct command_program *program, FILE *file)
{
    const struct command *const *command = program->commands;
    put_roff_head(file, program);
    fputs((*command)->name ? ".SH COMMANDS\n" : ".SH OPTIONS\n", file);
    for (; *command; command++)
        put_roff_command(file, program, *command);
    fputs(".SH EXIT STATUS\n"
          ".TP\n0\nThe work is done.\n"
          ".TP\n1\nThe command failed. Standard error gives the reason.\n"
          ".TP\n2\nThe command line is invalid.\n",
          file);
    if (program->files) {
        fputs(".SH FILES\n", file);
        put_roff_examples(file, program->files);
    }
    put_roff_all_examples(file, program);
}
