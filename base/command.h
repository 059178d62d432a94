/* command.h - one shell for all programs: what a command line means, what a
 * command tells of itself, how it ends.
 *
 * A program is a list of commands; a command is a row with its options and
 * operands; an option is a row, too, with the kind of its value and where the
 * value goes.  From these rows come the parsing, -h and --help, help COMMAND,
 * --version, and the messages on wrong usage, which name the option and list
 * what is right; nothing else lists commands or options.
 *
 * Results go to stdout, all else to stderr; the exit codes are those of
 * command_error.h.  The rows make the man page and the completion of shells, too:
 * "help --man", "help --completion bash", and "help --list" for scripts; make
 * install puts them where they belong.
 */
#ifndef BASE_COMMAND_H
#define BASE_COMMAND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/command_error.h"

/* What kind of value an option or operand has, and what it is in C. */
enum command_kind {
    COMMAND_FLAG,   /* bool: it was given */
    COMMAND_TEXT,   /* const char * */
    COMMAND_COUNT,  /* size_t, from least to most */
    COMMAND_CLOCKS, /* uint64_t, any */
    COMMAND_NUMBER, /* double, above least, below most */
    COMMAND_CHOICE, /* int or an enum: the number of one of the names */
    COMMAND_INPUT,  /* const char *: a file to read, "-" is stdin */
    COMMAND_OUTPUT, /* const char *: a file to write, "-" is stdout */
    COMMAND_FILE,   /* const char *: a file to write that has a name */
    COMMAND_FOLDER, /* const char * */
    COMMAND_CUSTOM  /* whatever take makes of the text */
};

/* The names that a value may have, by their numbers.  "": that number is not
 * to be had here; NULL: there are no more. */
typedef const char *command_choice(size_t number);

/* Puts what a text means where it belongs; may cut it up, and keep it.  False:
 * it is wrong. */
typedef bool command_take(char *text, void *value);

struct command_option {
    const char *name;  /* --name; NULL: an operand, known by its place */
    char letter;       /* -letter, or 0 */
    const char *value; /* what stands for it in help: FILE */
    enum command_kind kind;
    const char *help; /* one line */
    size_t offset;    /* of the value in the arguments */

    bool many;     /* texts and files, any number: struct command_texts */
    bool optional; /* an operand that may be missing, as all behind it */
    double least, most;
    double preset;           /* of counts, numbers and choices; 0: none, but of a choice
                      its first; -1: no choice */
    const char *preset_text; /* of texts and files, or told in help */
    command_choice *choice;  /* of a choice; of a text: for example these */
    command_take *take;      /* COMMAND_CUSTOM only, .. */
    const char *wants;       /* .. and what it takes, for messages */
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

/* The arguments begin with a const char *, the name of the command as
 * complaints need it: "c205 run".  All values are in place.  Returns the exit
 * code. */
typedef int command_function(void *arguments);

struct command {
    const char *name; /* NULL: the program is its only command */
    const char *summary;
    command_function *function;
    const struct command_option *options, *operands; /* NULL: none */
    const char *details;                             /* paragraphs, or NULL */
    const struct command_example *examples;          /* the last has no line */
};

struct command_program {
    const char *name, *summary, *version;
    const struct command *const *commands; /* NULL at the end */
    const struct command_example *files;   /* for the man page: what files and
                                              variables mean; or NULL */
    size_t arguments_size;
    const void *arguments; /* as they are before anything is given, or NULL:
                              zero */
};

/* All that main has to do: the exit code. */
int command_main(const struct command_program *program, int argc, char **argv);

#endif
