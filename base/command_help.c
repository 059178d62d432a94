/* command_help.c - prints the help of programs and commands from their rows. */
#include <stdio.h>
#include <string.h>

#include "base/command_rows.h"

/* Columns of the help: COLUMN is the first column of explanations, WIDTH the length of
 * a line, the others are indents. */
enum { COLUMN = 23, WIDTH = 79, PARAGRAPH = 0, EXAMPLE = 6 };

/* ---- Texts of a row ----------------------------------------------------- */

void command_option_name(const struct command_option *option, const struct sink *sink)
{
    if (option->name)
        sink_print(sink, "--%s", option->name);
    else
        sink_put(sink, option->value);
}

/* Returns the first choice from `number` on whose name is not "", and sets *name to the
 * name, or to NULL after the last choice. */
size_t command_next_choice(command_choice *choice, size_t number, const char **name)
{
    while ((*name = choice(number)) != NULL && !**name)
        number++;
    return number;
}

/* Writes all choices, as in "scalar, vector or kernels". */
static void put_choices(command_choice *choice, const struct sink *sink)
{
    const char *name, *next, *before = "";
    size_t number = command_next_choice(choice, 0, &name);
    while (name) {
        number = command_next_choice(choice, number + 1, &next);
        sink_print(sink, "%s%s", before, name);
        size_t after = number;
        const char *behind = NULL;
        if (next)
            command_next_choice(choice, after + 1, &behind);
        before = behind ? ", " : " or ";
        name = next;
    }
}

static void put_range(const struct command_option *option, const struct sink *sink)
{
    if (option->kind == COMMAND_COUNT) {
        sink_print(sink, "a whole number from %.0f to %.0f", option->least,
                   option->most);
    } else {
        sink_print(sink, "a number above %g and below %g", option->least, option->most);
    }
}

void command_option_wants(const struct command_option *option, const struct sink *sink)
{
    switch (option->kind) {
    case COMMAND_COUNT:
    case COMMAND_NUMBER: put_range(option, sink); break;
    case COMMAND_CLOCKS: sink_put(sink, "a whole number"); break;
    case COMMAND_CHOICE: put_choices(option->choice, sink); break;
    case COMMAND_CUSTOM: sink_put(sink, option->wants); break;
    case COMMAND_FOLDER: sink_put(sink, "a folder"); break;
    case COMMAND_INPUT:
    case COMMAND_OUTPUT: sink_put(sink, "a file, or - for a stream"); break;
    case COMMAND_FILE: sink_put(sink, "the name of a file"); break;
    default: sink_put(sink, "a text");
    }
}

bool command_option_preset(const struct command_option *option, const struct sink *sink)
{
    if (option->preset_text)
        sink_put(sink, option->preset_text);
    else if (option->kind == COMMAND_CHOICE && option->preset >= 0 && option->name)
        sink_put(sink, option->choice((size_t)option->preset));
    else if (option->preset > 0)
        sink_print(sink, "%g", option->preset);
    else
        return false;
    return true;
}

/* ---- Lines -------------------------------------------------------------- */

/* The state of writing words between two columns: the indent and WIDTH. Newlines of the
 * text remain. */
struct filler {
    FILE *file;
    size_t indent, column;
};

static void new_line(struct filler *filler)
{
    putc('\n', filler->file);
    filler->column = 0;
}

static void put_word(struct filler *filler, const char *word, size_t length)
{
    if (filler->column > filler->indent && filler->column + 1 + length > WIDTH)
        new_line(filler);
    if (filler->column > filler->indent) {
        putc(' ', filler->file);
        filler->column++;
    } else {
        while (filler->column < filler->indent) {
            putc(' ', filler->file);
            filler->column++;
        }
    }
    fprintf(filler->file, "%.*s", (int)length, word);
    filler->column += length;
}

static void fill_lines(struct filler *filler, const char *text)
{
    while (*text) {
        if (*text == '\n')
            new_line(filler);
        text += strspn(text, " \n");
        size_t length = strcspn(text, " \n");
        if (length > 0)
            put_word(filler, text, length);
        text += length;
    }
}

/* Writes an entry, as in " -o, --output FILE where it goes". */
static void put_entry(FILE *file, const char *left, const char *meaning)
{
    struct filler filler = { file, COLUMN, 2 + strlen(left) };
    fprintf(file, "  %s", left);
    if (filler.column + 2 > COLUMN)
        new_line(&filler);
    while (filler.column > 0 && filler.column < COLUMN) {
        putc(' ', file);
        filler.column++;
    }
    fill_lines(&filler, meaning);
    new_line(&filler);
}

/* ---- Options ------------------------------------------------------------ */

/* Writes the help text, the choices and the default. */
void command_option_meaning(const struct command_option *option,
                            const struct sink *sink)
{
    struct text_line preset = { { 0 }, 0 };
    struct sink preset_sink = text_line_sink(&preset);
    sink_put(sink, option->help);
    if (option->kind == COMMAND_CHOICE) {
        sink_put(sink, ": ");
        put_choices(option->choice, sink);
    }
    if (command_option_preset(option, &preset_sink))
        sink_print(sink, " (%s)", preset.text);
}

static void put_option(FILE *file, const struct command_option *option)
{
    struct text_line left = { { 0 }, 0 };
    struct text_buffer meaning = { NULL, 0, 0, false };
    struct sink left_sink = text_line_sink(&left);
    struct sink meaning_sink = text_buffer_sink(&meaning);
    if (option->letter)
        sink_print(&left_sink, "-%c, ", option->letter);
    command_option_name(option, &left_sink);
    if (option->name && option->value)
        sink_print(&left_sink, " %s", option->value);
    command_option_meaning(option, &meaning_sink);
    put_entry(file, left.text, meaning.text ? meaning.text : "");
    text_buffer_free(&meaning);
}

static void put_options(FILE *file, const struct command_option *option)
{
    for (; command_is_row(option); option++)
        put_option(file, option);
}

/* Writes the operands, as in "SCENE" or "[FILE..]". */
static void put_operands(FILE *file, const struct command_option *operand)
{
    for (; command_is_row(operand); operand++) {
        fprintf(file, operand->optional ? " [%s%s]" : " %s%s", operand->value,
                operand->many ? ".." : "");
    }
}

/* ---- Pages -------------------------------------------------------------- */

static void put_paragraphs(FILE *file, const char *text)
{
    struct filler filler = { file, PARAGRAPH, 0 };
    fill_lines(&filler, text);
    new_line(&filler);
}

static void put_examples(FILE *file, const struct command_example *example)
{
    fputs(example ? "\n" : "", file);
    for (; example && example->line; example++) {
        struct filler filler = { file, EXAMPLE, 0 };
        fprintf(file, "  %s\n", example->line);
        fill_lines(&filler, example->meaning);
        new_line(&filler);
    }
}

void command_print_help(const struct command_program *program,
                        const struct command *command, FILE *file)
{
    char name[COMMAND_NAME_SIZE];
    command_full_name(program, command, name);
    fprintf(file, "%s - %s\n\nusage: %s [OPTION..]", name, command->summary, name);
    put_operands(file, command->operands);
    fputs("\n\n", file);
    if (command->details) {
        put_paragraphs(file, command->details);
        putc('\n', file);
    }
    put_options(file, command->operands);
    if (command_is_row(command->operands))
        putc('\n', file);
    put_options(file, command->options);
    put_option(file, &command_help_option);
    put_option(file, &command_version_option);
    put_examples(file, command->examples);
}

void command_print_summary(const struct command_program *program, FILE *file)
{
    const struct command *const *command = program->commands;
    fprintf(file, "%s - %s\n\nusage: %s COMMAND [OPTION..] [ARGUMENT..]\n\n",
            program->name, program->summary, program->name);
    for (; *command; command++)
        fprintf(file, "  %-8s %s\n", (*command)->name, (*command)->summary);
    fprintf(file, "\n%s help COMMAND describes a command\n", program->name);
}
