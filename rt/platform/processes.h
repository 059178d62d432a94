/* processes.h - runs other programs, replaces this process by another program, and
 * locks files.
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

/* Runs the program words[0] in the folder, and waits for its end. The other words are
 * its arguments, and NULL follows the last word. Copies its standard output to
 * `output`, and sets *written to the number of bytes. *messages receives its error
 * output; the caller closes it. Returns the exit code of the program, or one of the
 * codes above. If no process can be started, returns -1 with errno set, without
 * messages. */
int process_run(const char *folder, char *const words[], FILE *output, size_t *written,
                FILE **messages);

/* Replaces this process by the program words[0]. The arguments of the new program are
 * the other words, the path of this program, and the arguments of this program. Returns
 * only on failure, with errno set. */
void process_become(char *const words[]);

/* Locks an open file, exclusively (alone) or shared for reading. The system releases
 * the lock when the process ends, even after a crash. On failure returns false with
 * errno set. */
bool process_lock(int file, bool alone);
/* Returns true if errno means that another process has locked the file. */
bool process_lock_is_held(void);

#endif
