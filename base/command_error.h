/* command_error.h - how a command ends, and what it tells on stderr when it fails.
 *
 * All of them escape what a terminal would take as a command: names may hold
 * any character (base/visible.h).
 */
#ifndef BASE_COMMAND_ERROR_H
#define BASE_COMMAND_ERROR_H

#include <stdio.h>

enum cmd_exit { CMD_DONE = 0, CMD_FAILED = 1, CMD_USAGE = 2 };

/* "c205 run: message" on stderr, for the command "c205 run"; both return the
 * exit code. */
int cmd_usage(const char *command, const char *format, ...);
int cmd_failed(const char *command, const char *format, ...);
/* A line, without its end in the format. */
void cmd_print_line(FILE *file, const char *format, ...);

#endif
