/* thread_pool.h - runs independent tasks in threads, with a common progress.
 *
 * A task stores its result at its own number, so the results do not depend on the order
 * in which tasks finish.
 */
#ifndef RT_PLATFORM_THREAD_POOL_H
#define RT_PLATFORM_THREAD_POOL_H

#include "vm/c205.h"

/* Like trace_options.progress. */
typedef bool task_progress(void *context, size_t done, size_t all);

/* A task: its number, and the function that receives its progress, which may be
 * NULL. */
struct task {
    size_t number;
    task_progress *progress;
    void *context;
};

struct thread_pool {
    size_t count, jobs; /* number of tasks, and of threads; 0 threads: one */
    /* Runs a task. On failure sets the error and returns false; no further tasks are
     * then started. */
    bool (*run)(void *context, const struct task *task, c205_error *error);
    /* Returns the relative cost of a task on the host. NULL: all tasks have the same
     * cost. */
    double (*weight)(const void *context, size_t number);
    void *context;
    /* Receives the progress of all tasks together. Calls never overlap. May be NULL. */
    task_progress *progress;
    void *progress_context;
};

/* Runs all tasks. On failure the failed task with the lowest number sets the error,
 * whatever the number of threads is. */
bool thread_pool_run(const struct thread_pool *pool, c205_error *error);

#endif
