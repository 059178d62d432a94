/* progress.c - shows and erases the progress line. */
#include "base/progress.h"

#include <unistd.h>

#include "base/interrupt.h"

/* Seconds before the line is first shown, and between two updates of the line. */
#define PATIENCE 1.0
#define PAUSE 0.2

static double seconds_since(const struct timespec *then)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - then->tv_sec)
           + 1e-9 * (double)(now.tv_nsec - then->tv_nsec);
}

void progress_time(double seconds, char text[PROGRESS_TIME_SIZE])
{
    unsigned long whole = (unsigned long)(seconds + 0.5);
    if (whole < 60) {
        snprintf(text, PROGRESS_TIME_SIZE, "%lu s", whole);
    } else if (whole < 3600) {
        snprintf(text, PROGRESS_TIME_SIZE, "%lu min %lu s", whole / 60, whole % 60);
    } else {
        snprintf(text, PROGRESS_TIME_SIZE, "%lu h %lu min", whole / 3600,
                 whole / 60 % 60);
    }
}

void progress_begin(struct progress *progress)
{
    *progress = (struct progress){ .file = isatty(STDERR_FILENO) == 1 ? stderr : NULL };
    clock_gettime(CLOCK_MONOTONIC, &progress->shown);
}

static void begin_counting(struct progress *progress, size_t done)
{
    progress->counting = true;
    progress->first = done;
    clock_gettime(CLOCK_MONOTONIC, &progress->begin);
}

static void show_progress(struct progress *progress, size_t done, size_t all)
{
    char left[PROGRESS_TIME_SIZE];
    double passed = seconds_since(&progress->begin);
    size_t fresh = done > progress->first ? done - progress->first : 0;
    if (passed < PATIENCE || fresh == 0 || seconds_since(&progress->shown) < PAUSE)
        return;
    clock_gettime(CLOCK_MONOTONIC, &progress->shown);
    progress_time(passed * (double)(all - done) / (double)fresh, left);
    fprintf(progress->file, "\r%3.0f %% done, %s left   ",
            100.0 * (double)done / (double)all, left);
    progress->line = true;
}

void progress_hide(struct progress *progress)
{
    if (progress->line) {
        fprintf(progress->file, "\r%40s\r", "");
        fflush(progress->file);
    }
    progress->line = false;
}

void progress_update(struct progress *progress, size_t done, size_t all)
{
    if (!progress->file)
        return;
    if (!progress->counting)
        begin_counting(progress, done);
    if (done < all) {
        show_progress(progress, done, all);
    } else {
        progress_hide(progress);
        progress->counting = false;
    }
}

bool progress_watch(void *progress, size_t done, size_t all)
{
    if (interrupt_pending())
        progress_hide(progress);
    else
        progress_update(progress, done, all);
    return !interrupt_pending();
}
