/* watch.c - shows progress on the terminal while the machine runs, and handles
 * Ctrl-C. */
#include "base/interrupt.h"
#include "rt/command/session.h"

static bool watch_progress(void *context, size_t done, size_t all)
{
    struct progress *progress = context;

    if (interrupt_pending())
        progress_hide(progress);
    else
        progress_update(progress, done, all);
    return !interrupt_pending();
}

void session_watch(struct session *session)
{
    interrupt_catch();
    progress_begin(&session->progress);
    session->shared->trace.progress = watch_progress;
    session->shared->trace.context = &session->progress;
}
