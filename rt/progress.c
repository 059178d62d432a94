/* progress.c - a line on the terminal while a frame is traced, and Ctrl-C. */
#include <signal.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include "rt/cmd.h"

static volatile sig_atomic_t interrupted;

static void on_interrupt(int number)
{
    (void)number;
    interrupted = 1;
}

struct watch {
    struct timespec begin, shown;
    bool terminal, line;
};

static double seconds_since(const struct timespec *then)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - then->tv_sec)
           + 1e-9 * (double)(now.tv_nsec - then->tv_nsec);
}

/* Only for work of more than a second, a few times each second. */
static void show(struct watch *watch, size_t done, size_t pixels)
{
    double passed = seconds_since(&watch->begin);
    double left = done > 0 ? passed * (double)(pixels - done) / (double)done
                           : 0;

    if (passed < 1 || seconds_since(&watch->shown) < 0.2)
        return;
    clock_gettime(CLOCK_MONOTONIC, &watch->shown);
    fprintf(stderr, "\r%3.0f %% traced, %.0f s left ",
            100.0 * (double)done / (double)pixels, left);
    watch->line = true;
}

static bool watch_progress(void *context, size_t done, size_t pixels)
{
    struct watch *watch = context;

    if (watch->terminal && !interrupted)
        show(watch, done, pixels);
    if ((interrupted || done == pixels) && watch->line) {
        fputs("\r                              \r", stderr);
        watch->line = false;
    }
    return !interrupted;
}

void cmd_watch(struct trace_options *options)
{
    static struct watch watch;
    struct sigaction action = { .sa_handler = on_interrupt };

    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    clock_gettime(CLOCK_MONOTONIC, &watch.begin);
    watch.shown = watch.begin;
    watch.terminal = isatty(STDERR_FILENO) == 1;
    options->progress = watch_progress;
    options->context = &watch;
}
