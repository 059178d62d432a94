/* thread_pool.h - runs that do not depend on one another, several at a time in
 * threads, with one progress over all of them.
 *
 * A run puts what it finds where its number says, so that nothing depends on
 * which ends first.
 */
#ifndef RT_STUDY_THREAD_POOL_H
#define RT_STUDY_THREAD_POOL_H

#include "vm/c205.h"

/* As trace_options.progress. */
typedef bool task_progress(void *context, size_t done, size_t all);

/* One run: which, and what it tells its own progress to.  progress is NULL if
 * nobody wants to know. */
struct task {
    size_t number;
    task_progress *progress;
    void *context;
};

struct tasks {
    size_t count, jobs; /* jobs: so many at a time; 0: one */
    /* False: the error says why, and no more are begun. */
    bool (*run)(void *context, const struct task *task, c205_error *error);
    /* How much of the host's work it is, beside the others; NULL: all are
     * alike. */
    double (*weight)(const void *context, size_t number);
    void *context;
    /* Of all together; never called twice at a time; NULL: nobody wants to
     * know. */
    task_progress *progress;
    void *progress_context;
};

/* Run them all.  False: the error is that of the lowest number that
 * failed, however many jobs there are. */
bool tasks_run(const struct tasks *tasks, c205_error *error);

#endif
