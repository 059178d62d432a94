/* interrupt.h - handles signals that end a program. Ctrl-C sets a flag that a command
 * polls. Incomplete files are removed if a signal ends the program.
 */
#ifndef BASE_INTERRUPT_H
#define BASE_INTERRUPT_H

#include <stdbool.h>

/* Lets the program continue after the first Ctrl-C, SIGTERM or SIGHUP from now on. The
 * second signal ends it. */
void interrupt_catch(void);
/* Like interrupt_catch, for a program that reads lines. Ctrl-C at a terminal never ends
 * the program. Reads and writes continue after a signal, so no output is lost; only
 * select and pselect return EINTR. */
void interrupt_catch_lines(bool terminal);
/* Returns true if Ctrl-C, SIGTERM or SIGHUP has arrived. */
bool interrupt_pending(void);
/* Returns true if SIGTERM or SIGHUP has arrived. The program must then end, even if
 * Ctrl-C has another meaning. */
bool interrupt_ends(void);
/* Clears the flag of Ctrl-C. */
void interrupt_clear(void);

/* Creates a new file for writing. Returns its descriptor, or -1 with errno. The file is
 * removed if a signal ends the program. The path must remain valid until the
 * release. */
int interrupt_create(const char *path);
void interrupt_release(const char *path); /* NULL has no effect */

#endif
