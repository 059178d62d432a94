#include "rt/study/thread_pool.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "rt/platform/threads.h"

/* Progress of all is told in so many steps. */
enum { STEPS = 1000000 };

/* What is known of a run. */
struct state {
    struct crew *crew;
    size_t number;
    double weight, share; /* share: of it that is done, 0 to 1 */
};

struct crew {
    const struct tasks *tasks;
    struct lock *lock; /* of all below */
    size_t next;       /* the run to begin next */
    bool cancelled;    /* by who watches */
    size_t failed;     /* the lowest run that failed; SIZE_MAX: none */
    c205_error error;  /* of that one, whichever failed first in time */
    double weight;     /* of all */
    struct state *states;
};

static size_t steps_done(const struct crew *crew)
{
    double done = 0;

    for (size_t i = 0; i < crew->tasks->count; i++)
        done += crew->states[i].weight * crew->states[i].share;
    return (size_t)(STEPS * (done / crew->weight));
}

/* With lock held. What comes before a run that failed continues to its own end, and what
   comes after it is in vain: so the error is the same whoever is the faster. */
static bool wanted(const struct crew *crew, size_t number)
{
    return !crew->cancelled && number < crew->failed;
}

/* Never all of them: that is told once, at the end. */
static bool report_progress(void *context, size_t done, size_t all)
{
    struct state *state = context;
    struct crew *crew = state->crew;
    const struct tasks *tasks = crew->tasks;
    bool go_on;
    size_t steps;

    lock_take(crew->lock);
    state->share = (double)done / (double)all;
    steps = steps_done(crew);
    if (!tasks->progress(tasks->progress_context, steps < STEPS ? steps : STEPS - 1,
                         STEPS))
        crew->cancelled = true;
    go_on = wanted(crew, state->number);
    lock_give_back(crew->lock);
    return go_on;
}

/* False: there is nothing more to begin. */
static bool take_next(struct crew *crew, size_t *number)
{
    bool more;

    lock_take(crew->lock);
    more = crew->next < crew->tasks->count && wanted(crew, crew->next);
    if (more)
        *number = crew->next++;
    lock_give_back(crew->lock);
    return more;
}

static void run_one(struct crew *crew, size_t number)
{
    const struct tasks *tasks = crew->tasks;
    struct state *state = &crew->states[number];
    const struct task task = { number, tasks->progress ? report_progress : NULL,
                               state };
    c205_error error;
    bool good = tasks->run(tasks->context, &task, &error);

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

/* The caller's thread works, too; where no other can be had, alone. */
static void work_together(struct crew *crew)
{
    size_t jobs = crew->tasks->jobs, count = 0;
    size_t most = jobs < crew->tasks->count ? jobs : crew->tasks->count;
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
    const struct tasks *tasks = crew->tasks;

    for (size_t i = 0; i < tasks->count; i++) {
        struct state *state = &crew->states[i];

        state->crew = crew;
        state->number = i;
        state->weight = tasks->weight ? tasks->weight(tasks->context, i) : 1;
        crew->weight += state->weight;
    }
}

bool tasks_run(const struct tasks *tasks, c205_error *error)
{
    struct crew crew = { .tasks = tasks, .failed = SIZE_MAX };
    bool good;

    crew.states = calloc(tasks->count + 1, sizeof *crew.states);
    snprintf(error->message, sizeof error->message, "no memory");
    crew.lock = lock_new();
    if (!crew.states || !crew.lock) {
        free(crew.states);
        lock_free(crew.lock);
        return false;
    }
    weigh(&crew);
    work_together(&crew);
    lock_free(crew.lock);
    good = crew.failed == SIZE_MAX && crew.next == tasks->count;
    snprintf(error->message, sizeof error->message, "stopped");
    if (crew.failed != SIZE_MAX)
        *error = crew.error;
    free(crew.states);
    if (good && tasks->progress)
        tasks->progress(tasks->progress_context, STEPS, STEPS);
    return good;
}
