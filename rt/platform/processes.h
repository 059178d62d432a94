/* processes.h - runs other programs, replaces this process by another program, and
 * locks files against other processes.
 *
 * No other file of rt starts processes.
 */
#ifndef RT_HOST_PROCESSES_H
#define RT_HOST_PROCESSES_H

#include <stdbool.h>
#include <stdio.h>

/* The exit codes that a shell uses for a program that cannot run, or does not
 * exist. */
enum { PROCESS_CANNOT_RUN = 126, PROCESS_NOT_FOUND = 127 };

/* Runs the program words[0] in the folder and waits for its end. The words end
 * with NULL; the others are its arguments. Its standard output is copied to
 * output, and *written is the number of bytes. Its error output can be read from
 * *messages, which the caller closes. Returns its exit code, or one of the above.
 * Returns -1, with errno set and no messages, if no process can be started. */
int process_run(const char *folder, char *const words[], FILE *output, size_t *written,
                FILE **messages);

/* Replaces this process by the program words[0]. Its arguments are the other
 * words, then this program's path, then this program's own arguments. Returns only
 * on failure, with errno set. */
void process_become(char *const words[]);

/* Locks an open file, exclusively (alone) or shared for reading. The system
 * releases the lock when the process ends, in any way. Returns false with errno
 * set. */
bool process_lock(int file, bool alone);
/* Returns true if errno means that another process holds a lock of the file. */
bool process_lock_is_held(void);

#endif
