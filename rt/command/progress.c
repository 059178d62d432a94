/* progress.c - a line on the terminal while the machine works, and Ctrl-C. */
#include <signal.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include "rt/command/rt205_command.h"

static volatile sig_atomic_t interrupted;

/* The second time it is as if nobody had asked for the first. */
static void on_interrupt(int number)
{
    if (interrupted) {
        signal(number, SIG_DFL);
        raise(number);
    }
    interrupted = 1;
}

bool cmd_interrupted(void)
{
    return interrupted;
}

struct watch {
    struct timespec begin, shown;
    bool terminal, line, counting;
    size_t first; /* what was done when the counting began */
};

static double seconds_since(const struct timespec *then)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - then->tv_sec)
           + 1e-9 * (double)(now.tv_nsec - then->tv_nsec);
}

/* Only for work of more than a second, a few times each second. */
static void show(struct watch *watch, size_t done, size_t all)
{
    double passed = seconds_since(&watch->begin);
    size_t fresh = done > watch->first ? done - watch->first : 0;
    double left = fresh > 0 ? passed * (double)(all - done) / (double)fresh
                            : 0;

    if (passed < 1 || fresh == 0 || seconds_since(&watch->shown) < 0.2)
        return;
    clock_gettime(CLOCK_MONOTONIC, &watch->shown);
    fprintf(stderr, "\r%3.0f %% done, %.0f s left ",
            100.0 * (double)done / (double)all, left);
    watch->line = true;
}

static void hide(struct watch *watch)
{
    if (watch->line)
        fputs("\r                              \r", stderr);
    watch->line = false;
}

static void begin_counting(struct watch *watch, size_t done)
{
    watch->counting = true;
    watch->first = done;
    clock_gettime(CLOCK_MONOTONIC, &watch->begin);
}

/* A command may run several programs, one after another, and a frame may have
 * bands from another day: the time counts from the first word of each. */
static bool watch_progress(void *context, size_t done, size_t all)
{
    struct watch *watch = context;

    if (!watch->counting)
        begin_counting(watch, done);
    if (interrupted || done == all)
        hide(watch);
    else if (watch->terminal)
        show(watch, done, all);
    if (done == all)
        watch->counting = false;
    return !interrupted;
}

void cmd_watch(struct trace_options *options)
{
    static struct watch watch;
    struct sigaction action = { .sa_handler = on_interrupt };

    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    clock_gettime(CLOCK_MONOTONIC, &watch.shown);
    watch.terminal = isatty(STDERR_FILENO) == 1;
    options->progress = watch_progress;
    options->context = &watch;
}
