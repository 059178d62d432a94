/* progress.h - one line on the terminal that shows the progress of a command.
 *
 * The line is on stderr. It appears if stderr is a terminal and the work takes more
 * than a second. It shows the percentage done and the estimated remaining time. The
 * estimate ignores work that an earlier run has done. The line is erased when the work
 * is done.
 */
#ifndef BASE_PROGRESS_H
#define BASE_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

struct progress {
    FILE *file; /* stderr; NULL: it is not a terminal */
    struct timespec begin, shown;
    bool counting, line;
    size_t first; /* work done when the clock started */
};

void progress_begin(struct progress *progress);
/* Reports that `done` of `all` items are done; `all` must not be 0. After all items are
 * done, the next call starts a new count. */
void progress_update(struct progress *progress, size_t done, size_t all);
/* Calls progress_update for a struct progress, as a callback. After Ctrl-C
 * (interrupt.h) it erases the line and returns false. */
bool progress_watch(void *progress, size_t done, size_t all);
/* Erases the line before other output. */
void progress_hide(struct progress *progress);

/* Writes a time as in "12 s", "3 min 5 s" or "2 h 10 min". */
enum { PROGRESS_TIME_SIZE = 32 };
void progress_time(double seconds, char text[PROGRESS_TIME_SIZE]);

#endif
