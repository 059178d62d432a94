/* processes.h - other processes: programs that are run, that this one becomes, and
 * those that are kept out of a file.
 *
 * The only file of rt that begins processes.
 */
#ifndef RT_HOST_PROCESSES_H
#define RT_HOST_PROCESSES_H

#include <stdbool.h>
#include <stdio.h>

/* How a shell tells that a program is not one, or is nowhere. */
enum { PROCESS_CANNOT_RUN = 126, PROCESS_NOT_FOUND = 127 };

/* Run the first of the words, which end with NULL, in the folder, with the
 * others for arguments, and wait for its end.  What it writes, so many bytes, goes to
 * output; what it complains of is read from *messages, which the caller closes.
 * Its exit code, or one of the above; -1: no process can be had, errno says why,
 * and there are no messages. */
int process_run(const char *folder, char *const words[], FILE *output, size_t *written,
                FILE **messages);

/* Become the first of the words, whose arguments are the others, then this
 * program's path, then its own arguments.  Comes back only where that cannot be: errno
 * says why. */
void process_become(char *const words[]);

/* Lock an open file, for this process alone or for all that read.  The lock goes
 * with the process, however it ends.  False: errno says why. */
bool process_lock(int file, bool alone);
/* Whether errno says of a lock that another process has the file. */
bool process_lock_is_held(void);

#endif
