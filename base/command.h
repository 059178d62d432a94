/* command.h - the command line interface of all programs: parsing, help and exit codes.
 *
 * A program is a list of commands. A command is a row with its options and operands,
 * and a structure of arguments. An option is a row with the kind of its value and the
 * offset of the value in this structure. Parsing, -h, --help, help COMMAND, --version
 * and the messages on wrong usage are generated from these rows. The messages name the
 * option and list the valid values. No other place lists commands or options.
 *
 * Results go to stdout. All other output goes to stderr. command_error.h defines the
 * exit codes. The rows also generate the man page ("help --man"), the shell completions
 * ("help --completion bash") and a list for scripts ("help --list"). make install
 * installs them.
 */
#ifndef BASE_COMMAND_H
#define BASE_COMMAND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/command_error.h"

/* The kinds of values of options and operands, with their types in C. */
enum command_kind {
    COMMAND_FLAG,   /* bool: true if it was given */
    COMMAND_TEXT,   /* const char *: the text */
    COMMAND_COUNT,  /* size_t: a count from least to most */
    COMMAND_CLOCKS, /* uint64_t: any number of clocks */
    COMMAND_NUMBER, /* double: a number above least and below most */
    COMMAND_CHOICE, /* int or an enum: the index of one of the names */
    COMMAND_INPUT,  /* const char *: an input file; "-" is stdin */
    COMMAND_OUTPUT, /* const char *: an output file; "-" is stdout */
    COMMAND_FILE,   /* const char *: an output file that has a name */
    COMMAND_FOLDER, /* const char *: a folder */
    COMMAND_CUSTOM  /* the type that the take function stores */
};

/* Returns the name of a value by its index. Returns "" if the index is not available in
 * this build, and NULL at the end of the list. */
typedef const char *command_choice(size_t number);

/* Converts a text and stores the value. It may modify the text and refer to it later.
 * Returns false if the text is invalid. */
typedef bool command_take(char *text, void *value);

struct command_option {
    const char *name;  /* long name, as in --name; NULL: an operand */
    char letter;       /* short name, as in -l, or 0 */
    const char *value; /* placeholder in help, such as FILE */
    enum command_kind kind;
    const char *help; /* help text of one line */
    size_t offset;    /* offset of the value in the arguments */

    bool many;     /* any number of texts or files: struct command_texts */
    bool optional; /* an operand that may be omitted, like all operands after it */
    double least, most;
    double preset;           /* default of a number or a choice; 0: none, or the first
                                choice; -1: no choice, or UINT64_MAX clocks */
    const char *preset_text; /* default of a text or file, or the default that help
                                shows */
    command_choice *choice;  /* names of a choice, or examples of a text */
    command_take *take;      /* for COMMAND_CUSTOM only */
    const char *wants;       /* description of valid input, for messages */
};
/* Ends a list of options or operands. */
/* clang-format off */
#define COMMAND_END { .help = NULL }
/* clang-format on */

struct command_texts {
    const char **items; /* NULL at the end */
    size_t count;
};

struct command_example {
    const char *line, *meaning;
};

/* Runs a command. The arguments are a structure of the command. Its first member is a
 * const char *, the full name of the command for error messages ("c205 run"). The
 * values of all rows are set, and all other members are zero. Returns the exit code. */
typedef int command_function(void *arguments);

struct command {
    const char *name; /* NULL: the program has no other command */
    const char *summary;
    command_function *function;
    size_t arguments_size;
    const struct command_option *options, *operands; /* NULL: none */
    const char *details;                             /* paragraphs, or NULL */
    const struct command_example *examples;          /* the last example has no line */
};

/* COMMANDS(ROW) is the table of commands of a program, with ROW(name) for each command.
 * COMMANDS(COMMAND_DECLARE) declares them, COMMANDS(COMMAND_ADDRESS) lists their
 * addresses. */
#define COMMAND_DECLARE(name) extern const struct command name##_command;
#define COMMAND_ADDRESS(name) &name##_command,

struct command_program {
    const char *name, *summary, *version;
    const struct command *const *commands; /* NULL at the end */
    const struct command_example *files;   /* for the man page: files and variables with
                                              their meaning, or NULL */
};

/* Parses the command line, runs the command and returns the exit code, for use as the
 * whole of main. */
int command_main(const struct command_program *program, int argc, char **argv);

#endif
