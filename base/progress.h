/* progress.h - one line on the terminal while a command works.
 *
 * It is on stderr, only if that is a terminal and the work takes more than
 * a second, and tells how much is done and how long the rest takes at that
 * pace.  Work that begins with something done (from another day) is timed by
 * what is done since.  The line is gone when the work is.
 */
#ifndef BASE_PROGRESS_H
#define BASE_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

struct progress {
    FILE *file; /* NULL: nobody looks at it */
    struct timespec begin, shown;
    bool counting, line;
    size_t first; /* what was done when the counting began */
};

void progress_begin(struct progress *progress);
/* So many of all are done; all of them: the work is done, and what comes next
 * is another.  all is not 0. */
void progress_update(struct progress *progress, size_t done, size_t all);
/* Clears the line, so that something else can be said. */
void progress_hide(struct progress *progress);

/* "12 s", "3 min 5 s", "2 h 10 min". */
enum { PROGRESS_TIME_SIZE = 32 };
void progress_time(double seconds, char text[PROGRESS_TIME_SIZE]);

#endif
