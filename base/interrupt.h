/* interrupt.h - signals that end a program: Ctrl-C as a question that a command asks now and
 * then, and files that must not be left when the program ends at once. */
#ifndef BASE_INTERRUPT_H
#define BASE_INTERRUPT_H

#include <stdbool.h>

/* From now on Ctrl-C, SIGTERM or SIGHUP does not end the program, but the second one does. */
void interrupt_catch(void);
/* The same for a program that reads lines.  At a terminal Ctrl-C ends the reading of a line with
 * EINTR, and never the program; elsewhere the reading continues. */
void interrupt_catch_lines(bool terminal);
/* One of them has come. */
bool interrupt_pending(void);
/* It was SIGTERM or SIGHUP: the program has to end, whatever Ctrl-C means to it. */
bool interrupt_ends(void);
/* A Ctrl-C counts as not pressed yet. */
void interrupt_clear(void);

/* Creates a file that does not exist yet, for writing: its descriptor, or -1 with errno.  It is
 * removed if a signal ends the program.  The path must last until the release. */
int interrupt_create(const char *path);
void interrupt_release(const char *path); /* NULL: nothing */

#endif
