/* command_rows.h - functions on the rows of commands and options (command.h), for
 * parsing, help and generated pages. Only base/command*.c include it.
 */
#ifndef BASE_COMMAND_ROWS_H
#define BASE_COMMAND_ROWS_H

#include <stdio.h>

#include "base/command.h"
#include "base/sink.h"

/* Options that every command has. */
extern const struct command_option command_help_option, command_version_option;

/* Returns true for a row, and false for the end of a list. A NULL list has no rows. */
bool command_is_row(const struct command_option *option);
size_t command_count_rows(const struct command_option *options);

/* Writes the full name, as in "c205 run". It is the name of the program if the command
 * is NULL or has no name. */
enum { COMMAND_NAME_SIZE = 64 };
void command_full_name(const struct command_program *program,
                       const struct command *command, char name[COMMAND_NAME_SIZE]);
/* Returns the command with a name, or NULL. */
const struct command *command_named(const struct command_program *program,
                                    const char *name);

/* Writes the name of an option ("--queue") or of an operand ("SCENE"). */
void command_option_name(const struct command_option *option, const struct sink *sink);
/* Writes the valid values, as in "scalar, vector or kernels" or "a whole number from 1
 * to 9". */
void command_option_wants(const struct command_option *option, const struct sink *sink);
/* Writes the default, as in "2000". Returns false if there is none. */
bool command_option_preset(const struct command_option *option,
                           const struct sink *sink);

/* Parses the command line into the arguments, whose first member must be set to the
 * full name. Returns CMD_DONE, an exit code after an error message, or one of the
 * following codes. */
enum { COMMAND_ASKS_HELP = CMD_USAGE + 1, COMMAND_ASKS_VERSION };
int command_parse(const struct command_program *program, const struct command *command,
                  int argc, char **argv, void *arguments);
/* Frees the memory that parsing allocated. */
void command_free(const struct command *command, void *arguments);

/* Print the help of a program or a command. */
void command_print_summary(const struct command_program *program, FILE *file);
void command_print_help(const struct command_program *program,
                        const struct command *command, FILE *file);
/* Prints the page for "help --list", --man, --completion SHELL or --complete. Returns
 * the exit code. */
int command_print_page(const struct command_program *program, int argc, char **argv);
void command_print_list(const struct command_program *program, FILE *file);
void command_print_man(const struct command_program *program, FILE *file);
void command_print_bash(const struct command_program *program, FILE *file);
void command_print_zsh(const struct command_program *program, FILE *file);
void command_print_fish(const struct command_program *program, FILE *file);
/* Prints the completions of the last of the given words, which are the words after the
 * name of the program. The first line is "-f" if the word may be a file, "-d" if it may
 * be a folder, and otherwise empty. Each further line is a candidate, a tab and its
 * explanation. Returns the exit code. */
int command_complete(const struct command_program *program, int count, char **words);

/* Returns the index of the next value that has a name, from this index on. Sets *name
 * to NULL if there is none. */
size_t command_next_choice(command_choice *choice, size_t number, const char **name);
/* Writes the explanation of an operand or option for help. */
void command_option_meaning(const struct command_option *option,
                            const struct sink *sink);

#endif
