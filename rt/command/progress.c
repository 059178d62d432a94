/* progress.c - a line on the terminal while the machine works, and Ctrl-C. */
#include <signal.h>

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

static bool watch_progress(void *context, size_t done, size_t all)
{
    struct progress *progress = context;

    if (interrupted)
        progress_hide(progress);
    else
        progress_tell(progress, done, all);
    return !interrupted;
}

void cmd_watch(struct rt205_arguments *arguments)
{
    struct sigaction action = { .sa_handler = on_interrupt };

    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    progress_begin(&arguments->progress);
    arguments->trace.progress = watch_progress;
    arguments->trace.context = &arguments->progress;
}
