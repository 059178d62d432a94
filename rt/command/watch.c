/* watch.c - shows progress on the terminal while the machine runs, and handles
 * Ctrl-C. */
#include "base/interrupt.h"
#include "rt/command/session.h"

void session_watch(struct trace_session *session)
{
    interrupt_catch();
    progress_begin(&session->progress);
    session->shared->trace.progress = progress_watch;
    session->shared->trace.context = &session->progress;
}
