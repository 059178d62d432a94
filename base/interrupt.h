/* interrupt.h - signals that end a program. Ctrl-C becomes a flag that a command polls,
 * and files that are incomplete are removed if a signal ends the program.
 */
#ifndef BASE_INTERRUPT_H
#define BASE_INTERRUPT_H

#include <stdbool.h>

/* From now on, the first Ctrl-C, SIGTERM or SIGHUP does not end the program; the second
 * one does. */
void interrupt_catch(void);
/* Does the work of interrupt_catch for a program that reads lines. At a terminal,
 * Ctrl-C never ends the program. Reads and writes continue after a signal, so that no
 * output is lost; only select and pselect return EINTR. */
void interrupt_catch_lines(bool terminal);
/* Returns true if one of these signals has arrived. */
bool interrupt_pending(void);
/* Returns true if it was SIGTERM or SIGHUP: the program must end, whatever Ctrl-C means
 * to it. */
bool interrupt_ends(void);
/* Resets the flag of a Ctrl-C. */
void interrupt_clear(void);

/* Creates a new file for writing. Returns its descriptor, or -1 with errno. The file is
 * removed if a signal ends the program. The path must remain valid until the
 * release. */
int interrupt_create(const char *path);
void interrupt_release(const char *path); /* NULL: nothing */

#endif
