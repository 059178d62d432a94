/* command_completion.c - prints the completion scripts for bash, zsh and fish. */
#include <stdio.h>
#include <string.h>

#include "base/command_rows.h"

/* Writes the names of a row's values, separated by blanks; nothing if it has none. */
static void put_choices(FILE *file, const struct command_option *row)
{
    const char *name = NULL, *before = "";
    for (size_t i = 0; row->choice; i++) {
        i = command_next_choice(row->choice, i, &name);
        if (!name) {
            break;
        }
        fprintf(file, "%s%s", before, name);
        before = " ";
    }
}

static bool is_file(const struct command_option *row)
{
    return row->kind == COMMAND_INPUT || row->kind == COMMAND_OUTPUT
           || row->kind == COMMAND_FILE;
}

/* Returns true if the program has a single command without a name. */
static bool is_nameless(const struct command_program *program)
{
    return program->commands[0]->name == NULL;
}

static void put_command_names(FILE *file, const struct command_program *program)
{
    const struct command *const *command = program->commands;
    for (; *command; command++) {
        fprintf(file, "%s ", (*command)->name);
    }
    fputs("help --help --version", file);
}

/* ---- bash --------------------------------------------------------------- */

static void put_bash_words(FILE *file, const struct command *command)
{
    const struct command_option *row = command->options;
    for (; command_is_row(row); row++) {
        fprintf(file, "--%s ", row->name);
        if (row->letter) {
            fprintf(file, "-%c ", row->letter);
        }
    }
    fputs("--help --version", file);
}

/* Writes the arguments of compgen for a value: words, files or folders; otherwise no
 * words. */
static void put_bash_values(FILE *file, const struct command_option *row)
{
    const char *kind = is_file(row) ? " -f" : row->kind == COMMAND_FOLDER ? " -d" : "";
    if (row->choice || !*kind) {
        fputs(" -W '", file);
        put_choices(file, row);
        putc('\'', file);
    }
    fputs(kind, file);
}

static void put_bash_options(FILE *file, const struct command *command)
{
    const struct command_option *row = command->options;
    for (; command_is_row(row); row++) {
        if (row->kind == COMMAND_FLAG) {
            continue;
        }
        fprintf(file, "        '%s --%s'", command->name ? command->name : "",
                row->name);
        if (row->letter) {
            fprintf(file, "|'%s -%c'", command->name ? command->name : "", row->letter);
        }
        fputs(") values=\"", file);
        put_bash_values(file, row);
        fputs("\";;\n", file);
    }
}

static void put_bash_operands(FILE *file, const struct command *command)
{
    const struct command_option *row = command->operands;
    fprintf(file, "        %s) options='", command->name ? command->name : "''");
    put_bash_words(file, command);
    fputs("' operands=\"", file);
    for (; command_is_row(row); row++) {
        put_bash_values(file, row);
    }
    fputs("\";;\n", file);
}

void command_print_bash(const struct command_program *program, FILE *file)
{
    const struct command *const *command;
    const char *name = program->name;
    fprintf(file,
            "# bash completion of %s, made by %s help --completion bash\n"
            "_%s() {\n"
            "    local word=${COMP_WORDS[COMP_CWORD]} command= values= "
            "options= operands=\n"
            "    local before=${COMP_WORDS[COMP_CWORD - 1]}\n"
            "    if [ \"$word\" = = ]; then word=\n"
            "    elif [ \"$before\" = = ]; then "
            "before=${COMP_WORDS[COMP_CWORD - 2]}\n"
            "    fi\n",
            name, name, name);
    if (!is_nameless(program)) {
        fputs("    command=${COMP_WORDS[1]}\n"
              "    if [ \"$COMP_CWORD\" -eq 1 ] || { [ \"$COMP_CWORD\" -eq 2 ] "
              "&& [ \"$command\" = help ]; }; then\n"
              "        mapfile -t COMPREPLY < <(compgen -W '",
              file);
        put_command_names(file, program);
        fputs("' -- \"$word\")\n        return\n    fi\n", file);
    }
    fputs("    case \"$command $before\" in\n", file);
    for (command = program->commands; *command; command++) {
        put_bash_options(file, *command);
    }
    fputs("    esac\n    case \"$command\" in\n", file);
    for (command = program->commands; *command; command++) {
        put_bash_operands(file, *command);
    }
    fprintf(file,
            "    esac\n"
            "    if [ -z \"$values\" ]; then\n"
            "        case \"$word\" in\n"
            "        -*) values=\" -W '$options'\";;\n"
            "        *) values=$operands;;\n"
            "        esac\n"
            "    fi\n"
            "    [ -z \"$values\" ] || "
            "eval \"mapfile -t COMPREPLY < <(compgen$values -- "
            "\\\"\\$word\\\")\"\n"
            "}\n"
            "complete -o filenames -F _%s %s\n",
            name, name);
}

/* ---- zsh ---------------------------------------------------------------- */

/* Writes a text inside single quotes and brackets of _arguments. */
static void put_zsh_text(FILE *file, const char *text)
{
    for (; *text; text++) {
        if (*text == '\'') {
            fputs("'\\''", file);
        } else {
            fputs(strchr("[]:\\", *text) ? "\\" : "", file);
            putc(*text, file);
        }
    }
}

static void put_zsh_action(FILE *file, const struct command_option *row)
{
    putc(':', file);
    put_zsh_text(file, row->value);
    putc(':', file);
    if (row->choice && is_file(row)) {
        fputs("_alternative \"names:name:(", file);
        put_choices(file, row);
        fputs(")\" \"files:file:_files\"", file);
    } else if (row->choice) {
        putc('(', file);
        put_choices(file, row);
        putc(')', file);
    } else if (is_file(row)) {
        fputs("_files", file);
    } else if (row->kind == COMMAND_FOLDER) {
        fputs("_files -/", file);
    }
}

static void put_zsh_option(FILE *file, const struct command_option *row)
{
    const char *again = row->many ? "*" : "";
    const char *forms[2] = { row->name, NULL };
    char letter[2] = { row->letter, '\0' };
    forms[1] = row->letter ? letter : NULL;
    for (int i = 0; i < 2 && forms[i]; i++) {
        fprintf(file, " \\\n            '%s%s%s%s[", again, i ? "-" : "--", forms[i],
                row->kind == COMMAND_FLAG ? ""
                : i                       ? "+"
                                          : "=");
        put_zsh_text(file, row->help);
        putc(']', file);
        if (row->kind != COMMAND_FLAG) {
            put_zsh_action(file, row);
        }
        putc('\'', file);
    }
}

static void put_zsh_command(FILE *file, const struct command *command)
{
    const struct command_option *row = command->options;
    fputs("        _arguments -s", file);
    for (; command_is_row(row); row++) {
        put_zsh_option(file, row);
    }
    put_zsh_option(file, &command_help_option);
    put_zsh_option(file, &command_version_option);
    for (row = command->operands; command_is_row(row); row++) {
        fprintf(file, " \\\n            '%s",
                row->many       ? "*"
                : row->optional ? ":"
                                : "");
        put_zsh_action(file, row);
        putc('\'', file);
    }
    putc('\n', file);
}

static void put_zsh_commands(FILE *file, const struct command_program *program)
{
    const struct command *const *command = program->commands;
    fputs("    local line state\n    _arguments -C '1:command:((", file);
    for (; *command; command++) {
        fprintf(file, "%s\\:\"", (*command)->name);
        put_zsh_text(file, (*command)->summary);
        fputs("\" ", file);
    }
    fputs("help\\:\"print the help of a command\"))' '*::argument:->rest'\n"
          "    case $line[1] in\n",
          file);
    for (command = program->commands; *command; command++) {
        fprintf(file, "    %s)\n", (*command)->name);
        put_zsh_command(file, *command);
        fputs("        ;;\n", file);
    }
    fputs("    help)\n        _values command", file);
    for (command = program->commands; *command; command++) {
        fprintf(file, " %s", (*command)->name);
    }
    fputs("\n        ;;\n    esac\n", file);
}

void command_print_zsh(const struct command_program *program, FILE *file)
{
    const char *name = program->name;
    fprintf(file,
            "#compdef %s\n"
            "# zsh completion of %s, made by %s help --completion zsh\n"
            "_%s() {\n",
            name, name, name, name);
    if (is_nameless(program)) {
        put_zsh_command(file, program->commands[0]);
    } else {
        put_zsh_commands(file, program);
    }
    fprintf(file, "}\n_%s \"$@\"\n", name);
}

/* ---- fish --------------------------------------------------------------- */

/* Writes a text in single quotes. */
static void put_fish_text(FILE *file, const char *text)
{
    putc('\'', file);
    for (; *text; text++) {
        fputs(*text == '\'' || *text == '\\' ? "\\" : "", file);
        putc(*text, file);
    }
    putc('\'', file);
}

static void put_fish_begin(FILE *file, const struct command_program *program,
                           const struct command *command)
{
    fprintf(file, "complete -c %s", program->name);
    if (command->name) {
        fprintf(file, " -n '__fish_seen_subcommand_from %s'", command->name);
    }
}

static void put_fish_values(FILE *file, const struct command_option *row)
{
    if (row->choice) {
        fputs(" -a '", file);
        put_choices(file, row);
        putc('\'', file);
    }
    if (row->kind == COMMAND_FOLDER) {
        fputs(" -a '(__fish_complete_directories)'", file);
    }
    fputs(is_file(row) ? " -F" : " -f", file);
}

static void put_fish_row(FILE *file, const struct command_program *program,
                         const struct command *command,
                         const struct command_option *row)
{
    put_fish_begin(file, program, command);
    if (row->name) {
        fprintf(file, " -l %s", row->name);
    }
    if (row->letter) {
        fprintf(file, " -s %c", row->letter);
    }
    if (row->name && row->kind != COMMAND_FLAG) {
        fputs(" -r", file);
    }
    if (row->kind != COMMAND_FLAG) {
        put_fish_values(file, row);
    }
    fputs(" -d ", file);
    put_fish_text(file, row->help);
    putc('\n', file);
}

static void put_fish_command(FILE *file, const struct command_program *program,
                             const struct command *command)
{
    const struct command_option *row;
    if (command->name) {
        fprintf(file, "complete -c %s -n __fish_use_subcommand -f -a %s -d ",
                program->name, command->name);
        put_fish_text(file, command->summary);
        putc('\n', file);
    }
    for (row = command->options; command_is_row(row); row++) {
        put_fish_row(file, program, command, row);
    }
    put_fish_row(file, program, command, &command_help_option);
    put_fish_row(file, program, command, &command_version_option);
    for (row = command->operands; command_is_row(row); row++) {
        put_fish_row(file, program, command, row);
    }
}

void command_print_fish(const struct command_program *program, FILE *file)
{
    const struct command *const *command = program->commands;
    const char *name = program->name;
    fprintf(file, "# fish completion of %s, made by %s help --completion fish\n", name,
            name);
    for (; *command; command++) {
        put_fish_command(file, program, *command);
    }
}
