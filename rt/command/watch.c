/* watch.c - shows progress on the terminal while the machine runs, and handles
 * Ctrl-C. */
#include "base/interrupt.h"
#include "rt/command/rt205_command.h"

static bool watch_progress(void *context, size_t done, size_t all)
{
    struct progress *progress = context;

    if (interrupt_pending())
        progress_hide(progress);
    else
        progress_update(progress, done, all);
    return !interrupt_pending();
}

void cmd_watch(struct rt205_arguments *arguments)
{
    interrupt_catch();
    progress_begin(&arguments->progress);
    arguments->trace.progress = watch_progress;
    arguments->trace.context = &arguments->progress;
}
