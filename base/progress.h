/* progress.h - one line on the terminal that shows the progress of a command.
 *
 * The line is on stderr, and only if that is a terminal and the work takes more than a
 * second. It shows the percentage done and the estimated remaining time. If some work
 * was already done at the start (by an earlier run), the estimate uses only the work
 * done since. The line is erased when the work is done.
 */
#ifndef BASE_PROGRESS_H
#define BASE_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

struct progress {
    FILE *file; /* NULL: stderr is not a terminal */
    struct timespec begin, shown;
    bool counting, line;
    size_t first; /* work done when the counting began */
};

void progress_begin(struct progress *progress);
/* Reports that done of all items are done; all must not be 0. If all are done, the next
 * call starts another count. */
void progress_update(struct progress *progress, size_t done, size_t all);
/* Does the work of progress_update as a callback with a struct progress. After Ctrl-C
 * (interrupt.h) it erases the line and returns false. */
bool progress_watch(void *progress, size_t done, size_t all);
/* Erases the line before other output. */
void progress_hide(struct progress *progress);

/* Writes "12 s", "3 min 5 s", "2 h 10 min". */
enum { PROGRESS_TIME_SIZE = 32 };
void progress_time(double seconds, char text[PROGRESS_TIME_SIZE]);

#endif
