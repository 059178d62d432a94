/* command_error.h - exit codes of commands, and their error messages on stderr.
 *
 * Messages escape all characters that a terminal would interpret, because names may
 * contain any character (base/visible_text.h).
 */
#ifndef BASE_COMMAND_ERROR_H
#define BASE_COMMAND_ERROR_H

#include <stdio.h>

enum cmd_exit { CMD_DONE = 0, CMD_FAILED = 1, CMD_USAGE = 2 };

/* Print "c205 run: message" on stderr for the command "c205 run". Return the exit
 * code. */
int cmd_usage(const char *command, const char *format, ...);
int cmd_failed(const char *command, const char *format, ...);
/* Prints a formatted line. The format does not end with a newline. */
void cmd_print_line(FILE *file, const char *format, ...);

#endif
