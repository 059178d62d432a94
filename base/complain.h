/* complain.h - how a command ends, and what it tells on stderr when it fails.
 *
 * c205 and rt205 share it; each defines cmd_program, its own name.
 */
#ifndef BASE_COMPLAIN_H
#define BASE_COMPLAIN_H

enum cmd_exit { CMD_DONE = 0, CMD_FAILED = 1, CMD_USAGE = 2 };

extern const char cmd_program[];

/* "c205 run: message" on stderr; both return the exit code. */
int cmd_usage(const char *command, const char *format, ...);
int cmd_failed(const char *command, const char *format, ...);

#endif
