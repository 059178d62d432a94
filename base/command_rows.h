/* command_rows.h - the rows of command.h as parsing, help and generated pages
 * see them: only for base/command*.c.
 */
#ifndef BASE_COMMAND_ROWS_H
#define BASE_COMMAND_ROWS_H

#include <stdio.h>

#include "base/command.h"
#include "base/sink.h"

/* What every command takes besides its own options. */
extern const struct command_option command_help_option, command_version_option;

/* Whether a row is there, or the list has ended; the list may be NULL. */
bool command_is_row(const struct command_option *option);

/* "c205 run", or the program's name alone; command NULL: likewise. */
enum { COMMAND_NAME_SIZE = 64 };
void command_full_name(const struct command_program *program,
                       const struct command *command, char name[COMMAND_NAME_SIZE]);
/* NULL: there is none of that name. */
const struct command *command_named(const struct command_program *program,
                                    const char *name);

/* "--queue", "-W"; an operand's "SCENE". */
void command_option_name(const struct command_option *option, const struct sink *sink);
/* What is right: "scalar, vector or kernels", "a whole number from 1 to 9". */
void command_option_wants(const struct command_option *option, const struct sink *sink);
/* What it is when it is not given: "2000".  False: nothing to tell. */
bool command_option_preset(const struct command_option *option,
                           const struct sink *sink);

/* Fills the arguments in, whose first member is the full name already.
 * CMD_DONE; or CMD_USAGE or CMD_FAILED, after telling why; or .. */
enum { COMMAND_ASKS_HELP = CMD_USAGE + 1, COMMAND_ASKS_VERSION };
int command_parse(const struct command_program *program, const struct command *command,
                  int argc, char **argv, void *arguments);
/* What parsing took from the heap. */
void command_free(const struct command *command, void *arguments);

/* What a program, and what a command tells of itself. */
void command_print_summary(const struct command_program *program, FILE *file);
void command_print_help(const struct command_program *program,
                        const struct command *command, FILE *file);
/* "help --list", --man, --completion bash|zsh|fish: the exit code. */
int command_print_page(const struct command_program *program, int argc, char **argv);
void command_print_list(const struct command_program *program, FILE *file);
void command_print_man(const struct command_program *program, FILE *file);
void command_print_bash(const struct command_program *program, FILE *file);
void command_print_zsh(const struct command_program *program, FILE *file);
void command_print_fish(const struct command_program *program, FILE *file);

/* The number of the next value that has a name, from this one on.  *name is
 * NULL: there is none. */
size_t command_next_choice(command_choice *choice, size_t number, const char **name);
/* What is behind an operand's or option's name in help. */
void command_option_meaning(const struct command_option *option,
                            const struct sink *sink);

#endif
