/* command_rows.h - the rows of command.h for parsing, help and generated pages; only
 * for base/command*.c.
 */
#ifndef BASE_COMMAND_ROWS_H
#define BASE_COMMAND_ROWS_H

#include <stdio.h>

#include "base/command.h"
#include "base/sink.h"

/* The options of every command. */
extern const struct command_option command_help_option, command_version_option;

/* Returns true for a row, false for the end of a list. The list may be NULL. */
bool command_is_row(const struct command_option *option);
size_t command_count_rows(const struct command_option *options);

/* Writes "c205 run", or only the program's name if the command is NULL or has no
 * name. */
enum { COMMAND_NAME_SIZE = 64 };
void command_full_name(const struct command_program *program,
                       const struct command *command, char name[COMMAND_NAME_SIZE]);
/* NULL: there is no command with that name. */
const struct command *command_named(const struct command_program *program,
                                    const char *name);

/* Writes "--queue", or the value of an operand, "SCENE". */
void command_option_name(const struct command_option *option, const struct sink *sink);
/* Writes the valid values: "scalar, vector or kernels", "a whole number from 1 to
 * 9". */
void command_option_wants(const struct command_option *option, const struct sink *sink);
/* Writes the default: "2000". Returns false if there is none. */
bool command_option_preset(const struct command_option *option,
                           const struct sink *sink);

/* Parses the command line into the arguments, whose first member is already the full
 * name. Returns CMD_DONE, CMD_USAGE or CMD_FAILED after an error message, or one of
 * these codes. */
enum { COMMAND_ASKS_HELP = CMD_USAGE + 1, COMMAND_ASKS_VERSION };
int command_parse(const struct command_program *program, const struct command *command,
                  int argc, char **argv, void *arguments);
/* Frees the memory that parsing allocated. */
void command_free(const struct command *command, void *arguments);

/* Print the help of a program or a command. */
void command_print_summary(const struct command_program *program, FILE *file);
void command_print_help(const struct command_program *program,
                        const struct command *command, FILE *file);
/* Prints the page of "help --list", --man, --completion bash|zsh|fish or --complete.
 * Returns the exit code. */
int command_print_page(const struct command_program *program, int argc, char **argv);
void command_print_list(const struct command_program *program, FILE *file);
void command_print_man(const struct command_program *program, FILE *file);
void command_print_bash(const struct command_program *program, FILE *file);
void command_print_zsh(const struct command_program *program, FILE *file);
void command_print_fish(const struct command_program *program, FILE *file);
/* Completes the last of the words that follow the program's name. Prints "-f" if a file
 * can be there, "-d" for a folder, or nothing; then a line for each candidate with a
 * tab before its explanation. Returns the exit code. */
int command_complete(const struct command_program *program, int count, char **words);

/* Returns the index of the next value with a name, from this index on. Sets *name to
 * NULL if there is none. */
size_t command_next_choice(command_choice *choice, size_t number, const char **name);
/* Writes the explanation after the name of an operand or option in help. */
void command_option_meaning(const struct command_option *option,
                            const struct sink *sink);

#endif
