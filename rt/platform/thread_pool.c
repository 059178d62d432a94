/* thread_pool.c - runs independent tasks in threads. */
#include "rt/platform/thread_pool.h"

#include <stdint.h>
#include <stdlib.h>

#include "vm/error.h"
#include "rt/platform/threads.h"

/* The number of steps in which the common progress of all tasks is reported. */
enum { STEPS = 1000000 };

/* The progress of a task, and its weight in the common progress. */
struct state {
    struct crew *crew;
    size_t number;
    double weight, share; /* share: the finished fraction, 0 to 1 */
};

struct crew {
    const struct thread_pool *pool;
    struct lock *lock; /* protects all fields below */
    size_t next;       /* next task to start */
    bool cancelled;    /* cancelled by the progress function */
    size_t failed;     /* lowest task that failed; SIZE_MAX: none */
    c205_error error;  /* error of that task, even if another task failed earlier */
    double weight;     /* sum over all tasks */
    struct state *states;
};

static size_t steps_done(const struct crew *crew)
{
    double done = 0;
    for (size_t i = 0; i < crew->pool->count; i++)
        done += crew->states[i].weight * crew->states[i].share;
    return (size_t)(STEPS * (done / crew->weight));
}

/* Returns true if a task may run. The caller holds the lock. A task before a failed
 * task continues, and a task after it is stopped, so that the error does not depend on
 * timing. */
static bool wanted(const struct crew *crew, size_t number)
{
    return !crew->cancelled && number < crew->failed;
}

/* Reports the common progress. The number of reported steps stays below the total,
 * because thread_pool_run reports the end once. */
static bool report_progress(void *context, size_t done, size_t all)
{
    struct state *state = context;
    struct crew *crew = state->crew;
    const struct thread_pool *pool = crew->pool;
    bool go_on;
    size_t steps;
    lock_take(crew->lock);
    state->share = (double)done / (double)all;
    steps = steps_done(crew);
    if (!pool->progress(pool->progress_context, steps < STEPS ? steps : STEPS - 1,
                        STEPS))
        crew->cancelled = true;
    go_on = wanted(crew, state->number);
    lock_give_back(crew->lock);
    return go_on;
}

/* Takes the next task. Returns false if there is no task to start. */
static bool take_next(struct crew *crew, size_t *number)
{
    bool more;
    lock_take(crew->lock);
    more = crew->next < crew->pool->count && wanted(crew, crew->next);
    if (more)
        *number = crew->next++;
    lock_give_back(crew->lock);
    return more;
}

static void run_one(struct crew *crew, size_t number)
{
    const struct thread_pool *pool = crew->pool;
    struct state *state = &crew->states[number];
    const struct task task = { number, pool->progress ? report_progress : NULL, state };
    c205_error error;
    bool good = pool->run(pool->context, &task, &error);
    lock_take(crew->lock);
    state->share = 1;
    if (!good && number < crew->failed) {
        crew->failed = number;
        crew->error = error;
    }
    lock_give_back(crew->lock);
}

static void work(void *context)
{
    struct crew *crew = context;
    size_t number;
    while (take_next(crew, &number))
        run_one(crew, number);
}

/* Runs the tasks in threads. The caller's thread also works. If no thread can be
 * started, it works alone. */
static void work_together(struct crew *crew)
{
    size_t jobs = crew->pool->jobs, count = 0;
    size_t most = jobs < crew->pool->count ? jobs : crew->pool->count;
    struct thread **threads = most > 1 ? calloc(most, sizeof *threads) : NULL;
    while (threads && count + 1 < most && (threads[count] = thread_begin(work, crew)))
        count++;
    work(crew);
    while (count > 0)
        thread_end(threads[--count]);
    free(threads);
}

static void weigh(struct crew *crew)
{
    const struct thread_pool *pool = crew->pool;
    for (size_t i = 0; i < pool->count; i++) {
        struct state *state = &crew->states[i];
        state->crew = crew;
        state->number = i;
        state->weight = pool->weight ? pool->weight(pool->context, i) : 1;
        crew->weight += state->weight;
    }
}

bool thread_pool_run(const struct thread_pool *pool, c205_error *error)
{
    struct crew crew = { .pool = pool, .failed = SIZE_MAX };
    bool good;
    crew.states = calloc(pool->count + 1, sizeof *crew.states);
    error_set(error, "out of memory");
    crew.lock = lock_new();
    if (!crew.states || !crew.lock) {
        free(crew.states);
        lock_free(crew.lock);
        return false;
    }
    weigh(&crew);
    work_together(&crew);
    lock_free(crew.lock);
    good = crew.failed == SIZE_MAX && crew.next == pool->count;
    error_set(error, "stopped");
    if (crew.failed != SIZE_MAX)
        *error = crew.error;
    free(crew.states);
    if (good && pool->progress)
        pool->progress(pool->progress_context, STEPS, STEPS);
    return good;
}
