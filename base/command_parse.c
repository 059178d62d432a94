/* command_parse.c - converts options and operands to their values. */
#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/command_rows.h"
#include "base/file.h"
#include "base/spelling.h"
#include "base/outputs.h"

const struct command_option command_help_option = { .name = "help",
                                                    .letter = 'h',
                                                    .kind = COMMAND_FLAG,
                                                    .help = "print this help" },
                            command_version_option = { .name = "version",
                                                       .kind = COMMAND_FLAG,
                                                       .help = "print the version" };

bool command_is_row(const struct command_option *option)
{
    return option && option->help;
}

size_t command_count_rows(const struct command_option *options)
{
    size_t count = 0;
    while (command_is_row(options)) {
        options++;
        count++;
    }
    return count;
}

static void *place_of(const struct command_option *option, void *arguments)
{
    return (char *)arguments + option->offset;
}

/* ---- Values ------------------------------------------------------------- */

static bool take_count(const char *text, const struct command_option *option,
                       void *place)
{
    char *end;
    errno = 0;
    unsigned long long value = strtoull(text, &end, 10);
    size_t count = (size_t)value;
    memcpy(place, &count, sizeof count);
    return *text >= '0' && *text <= '9' && *end == '\0' && errno == 0
           && (double)value >= option->least && (double)value <= option->most;
}

static bool take_clocks(const char *text, void *place)
{
    char *end;
    errno = 0;
    uint64_t value = strtoull(text, &end, 10);
    memcpy(place, &value, sizeof value);
    return *text >= '0' && *text <= '9' && *end == '\0' && errno == 0;
}

static bool take_number(const char *text, const struct command_option *option,
                        void *place)
{
    char *end;
    double value = strtod(text, &end);
    memcpy(place, &value, sizeof value);
    return end != text && *end == '\0' && value > option->least && value < option->most;
}

/* Stores a choice in an int or an enum. */
static void put_choice(int value, void *place)
{
    memcpy(place, &value, sizeof value);
}

static bool take_choice(const char *text, const struct command_option *option,
                        void *place)
{
    const char *name;
    for (size_t i = 0; *text && (name = option->choice(i)) != NULL; i++) {
        if (strcmp(name, text) == 0) {
            put_choice((int)i, place);
            return true;
        }
    }
    return false;
}

static void take_text(const char *text, const struct command_option *option,
                      void *place)
{
    struct command_texts *texts = place;
    if (option->many)
        texts->items[texts->count++] = text;
    else
        memcpy(place, &text, sizeof text);
}

/* Converts a text and stores the value. text is NULL for a flag. */
static bool store_option(char *text, const struct command_option *option, void *place)
{
    static const bool yes = true;
    switch (option->kind) {
    case COMMAND_FLAG: memcpy(place, &yes, sizeof yes); return true;
    case COMMAND_COUNT: return take_count(text, option, place);
    case COMMAND_CLOCKS: return take_clocks(text, place);
    case COMMAND_NUMBER: return take_number(text, option, place);
    case COMMAND_CHOICE: return take_choice(text, option, place);
    case COMMAND_CUSTOM: return option->take(text, place);
    case COMMAND_FILE:
        if (strcmp(text, "-") == 0)
            return false;
        break;
    default: break;
    }
    take_text(text, option, place);
    return *text != '\0';
}

/* ---- Defaults ----------------------------------------------------------- */

static bool prepare_row(const struct command_option *option, size_t room, void *place)
{
    size_t count = option->preset > 0 ? (size_t)option->preset : 0;
    uint64_t clocks = option->preset < 0 ? UINT64_MAX : (uint64_t)option->preset;
    if (option->many) {
        struct command_texts *texts = place;
        texts->items = calloc(room, sizeof *texts->items);
        return texts->items != NULL;
    }
    switch (option->kind) {
    case COMMAND_FLAG:
    case COMMAND_CUSTOM: break;
    case COMMAND_CLOCKS: memcpy(place, &clocks, sizeof clocks); break;
    case COMMAND_COUNT: memcpy(place, &count, sizeof count); break;
    case COMMAND_NUMBER: memcpy(place, &option->preset, sizeof option->preset); break;
    case COMMAND_CHOICE: put_choice((int)option->preset, place); break;
    default: memcpy(place, &option->preset_text, sizeof option->preset_text);
    }
    return true;
}

static bool prepare(const struct command_option *row, size_t room, void *arguments)
{
    for (; command_is_row(row); row++)
        if (!prepare_row(row, room, place_of(row, arguments)))
            return false;
    return true;
}

static void free_rows(const struct command_option *row, void *arguments)
{
    for (; command_is_row(row); row++) {
        if (row->many) {
            struct command_texts *texts = place_of(row, arguments);
            free(texts->items);
        }
    }
}

void command_free(const struct command *command, void *arguments)
{
    free_rows(command->options, arguments);
    free_rows(command->operands, arguments);
}

/* ---- Errors ------------------------------------------------------------- */

/* The state while a command line is parsed. */
struct parsing {
    const struct command_program *program;
    const struct command *command;
    char name[COMMAND_NAME_SIZE];
    void *arguments;
};

static int wrong_value(const struct parsing *parsing,
                       const struct command_option *option, const char *text)
{
    struct text_line name = { { 0 }, 0 }, wants = { { 0 }, 0 };
    struct sink name_sink = text_line_sink(&name);
    struct sink wants_sink = text_line_sink(&wants);
    command_option_name(option, &name_sink);
    command_option_wants(option, &wants_sink);
    return cmd_usage(parsing->name, "%s: expected %s, found '%s'", name.text,
                     wants.text, text);
}

/* Returns another command that has an option of this name, or NULL. */
static const struct command *owner_of(const struct parsing *parsing, const char *name)
{
    const struct command *const *command = parsing->program->commands;
    for (; *command; command++) {
        const struct command_option *option = (*command)->options;
        for (; command_is_row(option); option++)
            if (strcmp(option->name, name) == 0)
                return *command;
    }
    return NULL;
}

/* Lists the options that begin with a name. Returns false if there are none. */
static bool find_beginnings(const struct parsing *parsing, const char *name,
                            const struct sink *sink)
{
    const struct command_option *option = parsing->command->options;
    const char *before = "";
    for (; command_is_row(option); option++) {
        if (*name && strncmp(option->name, name, strlen(name)) == 0) {
            sink_print(sink, "%s--%s", before, option->name);
            before = ", ";
        }
    }
    return *before != '\0';
}

/* Returns the closest name among the command's options, help and version. */
static const char *nearest_option(const struct parsing *parsing, const char *name)
{
    struct spelling nearest = { .word = name };
    const struct command_option *option = parsing->command->options;
    for (; command_is_row(option); option++)
        spelling_try(&nearest, option->name);
    spelling_try(&nearest, command_help_option.name);
    spelling_try(&nearest, command_version_option.name);
    return nearest.name;
}

static int no_long_option(const struct parsing *parsing, const char *word)
{
    char name[COMMAND_NAME_SIZE];
    struct text_line several = { { 0 }, 0 };
    struct sink sink = text_line_sink(&several);
    snprintf(name, sizeof name, "%.*s", (int)strcspn(word + 2, "="), word + 2);
    const struct command *owner = owner_of(parsing, name);
    const char *nearest = nearest_option(parsing, name);
    if (find_beginnings(parsing, name, &sink))
        return cmd_usage(parsing->name, "--%s is ambiguous: %s", name, several.text);
    if (owner) {
        return cmd_usage(parsing->name, "unknown option --%s; it is an option of %s",
                         name, owner->name);
    }
    return cmd_usage(parsing->name, "unknown option %s%s%s%s", word,
                     nearest ? "; did you mean --" : "", nearest ? nearest : "",
                     nearest ? "?" : "");
}

/* Reports a flag with a value, or an unknown option. */
static int wrong_option(const struct parsing *parsing, const char *word)
{
    const struct command_option *option = parsing->command->options;
    if (word[0] != '-' || word[1] != '-')
        return cmd_usage(parsing->name, "unknown option -%c", optopt);
    size_t length = strcspn(word + 2, "=");
    for (; word[2 + length] && command_is_row(option); option++)
        if (option->kind == COMMAND_FLAG && strlen(option->name) == length
            && strncmp(option->name, word + 2, length) == 0)
            return cmd_usage(parsing->name, "--%s takes no argument", option->name);
    return no_long_option(parsing, word);
}

/* ---- Options ------------------------------------------------------------ */

/* getopt identifies long options by values from this one on, and short options by their
 * letters, which have smaller values. */
enum { FIRST_ROW = 256 };

/* The options of a command as getopt expects them, followed by help, version and an end
 * mark. */
struct getopt_tables {
    struct option *options;
    char *letters;
    size_t count; /* number of options of the command */
};

static void add_option(struct getopt_tables *tables, size_t place,
                       const struct command_option *option)
{
    bool has_value = option->kind != COMMAND_FLAG;
    tables->options[place] = (struct option){ option->name,
                                              has_value ? required_argument
                                                        : no_argument,
                                              NULL, FIRST_ROW + (int)place };
    if (option->letter) {
        char *end = tables->letters + strlen(tables->letters);
        snprintf(end, 3, "%c%s", option->letter, has_value ? ":" : "");
    }
}

static bool make_tables(const struct command *command, struct getopt_tables *tables)
{
    tables->count = command_count_rows(command->options);
    tables->options = calloc(tables->count + 3, sizeof *tables->options);
    tables->letters = calloc(tables->count + 3, 3);
    if (!tables->options || !tables->letters)
        return false;
    tables->letters[0] = ':'; /* getopt then reports a missing value differently from a
                                 wrong option */
    for (size_t i = 0; i < tables->count; i++)
        add_option(tables, i, &command->options[i]);
    add_option(tables, tables->count, &command_help_option);
    add_option(tables, tables->count + 1, &command_version_option);
    return true;
}

/* Returns the row that a value of getopt identifies: a row of the command, help or
 * version. */
static const struct command_option *
row_of(const struct command *command, const struct getopt_tables *tables, int value)
{
    for (size_t i = 0; i < tables->count; i++) {
        const struct command_option *option = &command->options[i];
        if (value == FIRST_ROW + (int)i || value == option->letter)
            return option;
    }
    return value == FIRST_ROW + (int)tables->count + 1 ? &command_version_option
                                                       : &command_help_option;
}

static int take_option(const struct parsing *parsing,
                       const struct command_option *option)
{
    if (option == &command_help_option)
        return COMMAND_ASKS_HELP;
    if (option == &command_version_option)
        return COMMAND_ASKS_VERSION;
    return store_option(optarg, option, place_of(option, parsing->arguments))
               ? CMD_DONE
               : wrong_value(parsing, option, optarg);
}

static int parse_options(const struct parsing *parsing,
                         const struct getopt_tables *tables, int argc, char **argv)
{
    int code = CMD_DONE, value;
    opterr = 0;
    optind = 0;
    while (code == CMD_DONE
           && (value = getopt_long(argc, argv, tables->letters, tables->options, NULL))
                  != -1) {
        const char *word = argv[optind - 1];
        if (value == ':')
            code = cmd_usage(parsing->name, "%s requires an argument", word);
        else if (value == '?')
            code = wrong_option(parsing, word);
        else
            code = take_option(parsing, row_of(parsing->command, tables, value));
    }
    return code;
}

/* ---- Operands ----------------------------------------------------------- */

static int parse_operands(const struct parsing *parsing, char **words)
{
    const struct command_option *operand = parsing->command->operands;
    for (; command_is_row(operand); operand++) {
        void *place = place_of(operand, parsing->arguments);
        if (!*words && !operand->optional) {
            return cmd_usage(parsing->name, "%s is missing: %s", operand->value,
                             operand->help);
        }
        while (*words) {
            if (!store_option(*words, operand, place))
                return wrong_value(parsing, operand, *words);
            words++;
            if (!operand->many)
                break;
        }
    }
    return !*words ? CMD_DONE
                   : cmd_usage(parsing->name, "too many arguments: %s", *words);
}

/* ---- Conflicts between files -------------------------------------------- */

static bool is_output(const struct command_option *row)
{
    return row->kind == COMMAND_OUTPUT || row->kind == COMMAND_FILE;
}

/* Returns file i of an option or operand, or NULL if there are no more files. */
static const char *path_of(const struct parsing *parsing,
                           const struct command_option *row, size_t i)
{
    const struct command_texts *texts = place_of(row, parsing->arguments);
    const char *path = NULL;
    if (!is_output(row) && row->kind != COMMAND_INPUT)
        return NULL;
    if (row->many)
        return i < texts->count ? texts->items[i] : NULL;
    memcpy(&path, texts, sizeof path);
    return i == 0 ? path : NULL;
}

/* Returns true if an argument of the row is the path of this file. The name of a
 * built-in model is not a path. */
static bool names(const struct parsing *parsing, const struct command_option *row,
                  const char *path)
{
    const char *other;
    int number;
    for (size_t i = 0; (other = path_of(parsing, row, i)); i++) {
        bool is_name = row->choice && take_choice(other, row, &number);
        if (!is_name && file_is_one(path, other))
            return true;
    }
    return false;
}

/* Returns the first of these rows that has the file as an output (if `output` is true)
 * or as an input. Returns NULL if there is none. */
static const struct command_option *row_naming(const struct parsing *parsing,
                                               const struct command_option *row,
                                               bool output, const char *path)
{
    while (command_is_row(row)
           && !((output ? is_output(row) : row->kind == COMMAND_INPUT)
                && names(parsing, row, path)))
        row++;
    return command_is_row(row) ? row : NULL;
}

/* Checks that no later option writes the same file and that no row reads the file. */
static int check_output(const struct parsing *parsing,
                        const struct command_option *option, const char *path)
{
    const struct command *command = parsing->command;
    const struct command_option *other = row_naming(parsing, option + 1, true, path);
    if (other) {
        return cmd_usage(parsing->name, "--%s and --%s cannot write the same file",
                         option->name, other->name);
    }
    if (!file_is_stream(path) && !outputs_add(path))
        return cmd_failed(parsing->name, "out of memory");
    if (outputs_has(path)
        && (row_naming(parsing, command->options, false, path)
            || row_naming(parsing, command->operands, false, path))) {
        return cmd_usage(parsing->name, "--%s would overwrite the input %s",
                         option->name, path);
    }
    return CMD_DONE;
}

static int check_outputs(const struct parsing *parsing)
{
    const struct command_option *option = parsing->command->options;
    int code = CMD_DONE;
    for (; command_is_row(option); option++) {
        const char *path;
        for (size_t i = 0; is_output(option) && code == CMD_DONE
                           && (path = path_of(parsing, option, i));
             i++)
            code = check_output(parsing, option, path);
    }
    return code;
}

/* Returns the number of inputs in these rows that are stdin ("-"). */
static size_t streams_in(const struct parsing *parsing,
                         const struct command_option *row)
{
    size_t count = 0;
    for (; command_is_row(row); row++) {
        const char *path;
        for (size_t i = 0;
             row->kind == COMMAND_INPUT && (path = path_of(parsing, row, i)); i++)
            count += file_is_stream(path);
    }
    return count;
}

static int check_inputs(const struct parsing *parsing)
{
    size_t streams = streams_in(parsing, parsing->command->options)
                     + streams_in(parsing, parsing->command->operands);
    return streams <= 1 ? CMD_DONE
                        : cmd_usage(parsing->name, "only one file can be - (stdin)");
}

/* ---- The whole command line --------------------------------------------- */

static int parse(struct parsing *parsing, int argc, char **argv)
{
    const struct command *command = parsing->command;
    struct getopt_tables tables = { NULL, NULL, 0 };
    size_t room = (size_t)argc + 1;
    int code = CMD_FAILED;
    if (!prepare(command->options, room, parsing->arguments)
        || !prepare(command->operands, room, parsing->arguments)
        || !make_tables(command, &tables))
        cmd_failed(parsing->name, "out of memory");
    else
        code = parse_options(parsing, &tables, argc, argv);
    free(tables.options);
    free(tables.letters);
    if (code == CMD_DONE)
        code = parse_operands(parsing, argv + optind);
    if (code == CMD_DONE)
        code = check_outputs(parsing);
    return code == CMD_DONE ? check_inputs(parsing) : code;
}

int command_parse(const struct command_program *program, const struct command *command,
                  int argc, char **argv, void *arguments)
{
    struct parsing parsing = { program, command, "", arguments };
    command_full_name(program, command, parsing.name);
    return parse(&parsing, argc, argv);
}
