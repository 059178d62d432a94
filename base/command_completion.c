/* command_completion.c - completes command lines for bash, zsh and fish. Their scripts
 * call "help --complete WORD..". */
#include <stdio.h>
#include <string.h>

#include "base/command_rows.h"

/* ---- Candidates --------------------------------------------------------- */

/* Prints a candidate and its explanation if the candidate begins with the word. */
static void put_candidate(const char *word, const char *dashes, const char *name,
                          const char *meaning)
{
    char text[COMMAND_NAME_SIZE];
    snprintf(text, sizeof text, "%s%s", dashes, name);
    if (strncmp(text, word, strlen(word)) == 0)
        printf("%s\t%s\n", text, meaning);
}

static void put_option(const char *word, const struct command_option *row)
{
    char letter[2] = { row->letter, '\0' };
    put_candidate(word, "--", row->name, row->help);
    if (row->letter)
        put_candidate(word, "-", letter, row->help);
}

static void put_commands(const struct command_program *program, const char *word)
{
    const struct command *const *command = program->commands;
    putchar('\n');
    for (; *command; command++)
        put_candidate(word, "", (*command)->name, (*command)->summary);
    put_candidate(word, "", "help", "print the help of a command");
    put_option(word, &command_help_option);
    put_option(word, &command_version_option);
}

static void put_options(const char *word, const struct command_option *row)
{
    putchar('\n');
    for (; command_is_row(row); row++)
        put_option(word, row);
    put_option(word, &command_help_option);
    put_option(word, &command_version_option);
}

/* Prints -f if a value of the rows is a file, -d if it is a folder, and the names of
 * all choices. */
static void put_values(const char *word, const struct command_option *rows,
                       size_t count)
{
    const char *name, *kind = "";
    for (size_t i = 0; i < count; i++) {
        bool file = rows[i].kind == COMMAND_INPUT || rows[i].kind == COMMAND_OUTPUT
                    || rows[i].kind == COMMAND_FILE;
        kind = file ? "-f" : rows[i].kind == COMMAND_FOLDER && !*kind ? "-d" : kind;
    }
    puts(kind);
    for (size_t i = 0; i < count; i++) {
        for (size_t number = 0; rows[i].choice; number++) {
            number = command_next_choice(rows[i].choice, number, &name);
            if (!name)
                break;
            put_candidate(word, "", name, rows[i].value);
        }
    }
}

/* ---- The word that is completed ----------------------------------------- */

/* Returns the option with a value that a word names as "--name", "--name=value" or
 * "-letter". NULL: there is none. */
static const struct command_option *option_with_value(const struct command *command,
                                                      const char *word)
{
    const struct command_option *row = command->options;
    size_t length = strcspn(word, "=");
    char letter = word[0] == '-' && length == 2 ? word[1] : '\0';
    bool is_long = length > 2 && strncmp(word, "--", 2) == 0;
    for (; command_is_row(row); row++) {
        bool named = is_long && strlen(row->name) == length - 2
                     && strncmp(row->name, word + 2, length - 2) == 0;
        if (row->kind != COMMAND_FLAG && (named || (letter && letter == row->letter)))
            return row;
    }
    return NULL;
}

int command_complete(const struct command_program *program, int count, char **words)
{
    const struct command *command = program->commands[0];
    const char *word = count > 0 ? words[count - 1] : "";
    const char *before = count > 1 ? words[count - 2] : "";
    if (command->name && (count < 2 || (count == 2 && strcmp(words[0], "help") == 0))) {
        put_commands(program, word);
        return CMD_DONE;
    }
    command = command->name ? command_named(program, words[0]) : command;
    if (!command)
        return CMD_DONE;
    /* bash splits "--name=value" into three words. */
    if (strcmp(word, "=") == 0) {
        word = "";
    } else if (strcmp(before, "=") == 0 && count > 2) {
        before = words[count - 3];
    } else if (word[0] == '-' && strchr(word, '=')) {
        before = word;
        word = strchr(word, '=') + 1;
    }
    const struct command_option *option = option_with_value(command, before);
    if (option)
        put_values(word, option, 1);
    else if (word[0] == '-')
        put_options(word, command->options);
    else
        put_values(word, command->operands, command_count_rows(command->operands));
    return CMD_DONE;
}

/* ---- Scripts ------------------------------------------------------------ */

void command_print_bash(const struct command_program *program, FILE *file)
{
    const char *name = program->name;
    fprintf(file,
            "# bash completion of %s, made by %s help --completion bash\n"
            "_%s() {\n"
            "    local word=${COMP_WORDS[COMP_CWORD]} kind\n"
            "    { read -r kind; mapfile -t COMPREPLY; } < <(\n"
            "        %s help --complete \"${COMP_WORDS[@]:1:COMP_CWORD}\")\n"
            "    COMPREPLY=(\"${COMPREPLY[@]%%%%$'\\t'*}\")\n"
            "    [ -z \"$kind\" ] || mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(\n"
            "        compgen \"$kind\" -- \"${word#=}\")\n"
            "}\n"
            "complete -o filenames -F _%s %s\n",
            name, name, name, name, name, name);
}

void command_print_zsh(const struct command_program *program, FILE *file)
{
    const char *name = program->name;
    fprintf(file,
            "#compdef %s\n"
            "# zsh completion of %s, made by %s help --completion zsh\n"
            "local -a lines\n"
            "lines=(\"${(@f)$(%s help --complete \"${(@)words[2,CURRENT]}\")}\")\n"
            "compset -P '--*='\n"
            "case $lines[1] in\n"
            "-f) _files;;\n"
            "-d) _files -/;;\n"
            "esac\n"
            "lines=(\"${(@)${(@)lines[2,-1]//:/\\\\:}/$'\\t'/:}\")\n"
            "_describe value lines\n",
            name, name, name, name);
}

void command_print_fish(const struct command_program *program, FILE *file)
{
    const char *name = program->name;
    fprintf(file,
            "# fish completion of %s, made by %s help --completion fish\n"
            "function __%s_complete\n"
            "    set -l word (commandline -ct)\n"
            "    set -l words (commandline -opc)\n"
            "    set -l lines (%s help --complete $words[2..] \"$word\")\n"
            "    set -l option (string match -r -- '^--[^=]*=' \"$word\")\n"
            "    set -l path (string replace -r -- '^--[^=]*=' '' \"$word\")\n"
            "    switch \"$lines[1]\"\n"
            "        case -f\n"
            "            set -a lines (__fish_complete_path \"$path\")\n"
            "        case -d\n"
            "            set -a lines (__fish_complete_directories \"$path\" '')\n"
            "    end\n"
            "    for line in $lines[2..]\n"
            "        echo \"$option$line\"\n"
            "    end\n"
            "end\n"
            "complete -c %s -f -a '(__%s_complete)'\n",
            name, name, name, name, name, name);
}
