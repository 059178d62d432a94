/* job_set.c - runs units of work in threads and in other ranks. */
#include "rt/jobs/job_set.h"

#include <stdlib.h>
#include <string.h>

#include "vm/error.h"
#include "base/fnv_hash.h"
#include "base/plural.h"
#include "rt/platform/threads.h"

/* ---- Files and keys ------------------------------------------------------ */

static bool is_first(const struct job_set *job_set)
{
    return !job_set->ranks || job_set->ranks->rank == 0;
}

bool job_set_collects(const struct job_set *job_set)
{
    return is_first(job_set) && job_set->parts == 0;
}

bool job_set_open(struct job_set *job_set, uint64_t key, c205_error *error)
{
    if (job_set->path_count == 0 || job_set->file || !is_first(job_set))
        return true;
    if (key == 0)
        return error_set(error, "out of memory");
    job_set->file = checkpoint_open(job_set->paths[0], key, error);
    for (size_t i = 1; job_set->file && i < job_set->path_count; i++)
        if (!checkpoint_merge(job_set->file, job_set->paths[i], error))
            job_set_close(job_set, false);
    job_set->kept = job_set->file ? checkpoint_count(job_set->file) : 0;
    return job_set->file;
}

void job_set_close(struct job_set *job_set, bool remove_it)
{
    checkpoint_close(job_set->file, remove_it);
    job_set->file = NULL;
}

bool job_set_agree(struct job_set *job_set, uint64_t *word)
{
    return !job_set->ranks || ranks_agree(job_set->ranks, word);
}

static bool add_to_key(void *context, const void *bytes, size_t count)
{
    uint64_t *key = context;
    *key = hash_bytes(*key, bytes, count);
    return true;
}

uint64_t job_set_key(const char *kind, const c205 *machine, const uint64_t *options,
                     size_t count)
{
    uint64_t key = HASH_START;
    c205_error error;
    add_to_key(&key, kind, strlen(kind) + 1);
    add_to_key(&key, C205_VERSION, sizeof C205_VERSION);
    key = hash_words(key, options, count);
    return c205_save(machine, add_to_key, &key, &error) ? key : 0;
}

/* ---- Units --------------------------------------------------------------- */

struct pool {
    const struct job_set_work *work;
    struct lock *lock; /* protects all fields below */
    bool *begun;
    size_t next;   /* all earlier units have been started */
    size_t done;   /* number of units that are finished and, if required, taken */
    bool stopped;  /* stopped by the progress function, or after an error of a file or
                    * memory */
    size_t failed; /* lowest unit that failed; work->count: none */
    size_t active; /* number of running threads */
    c205_error error;
};

struct hand {
    struct pool *pool;
    size_t number;
    struct thread *thread; /* NULL: the caller's thread */
};

static bool is_mine(const struct job_set *job_set, size_t unit)
{
    return job_set->parts == 0 || unit % job_set->parts == job_set->part - 1;
}

/* Takes the next unit. The caller of this function, and of the others in this section,
 * holds the lock. Units before a failed unit still run, so the error does not depend on
 * timing. */
static bool take_next(struct pool *pool, size_t *unit)
{
    const struct job_set_work *work = pool->work;
    while (pool->next < work->count && pool->begun[pool->next])
        pool->next++;
    if (pool->stopped || pool->next >= pool->failed || pool->next >= work->count)
        return false;
    *unit = pool->next;
    return pool->begun[*unit] = true;
}

static void fail_unit(struct pool *pool, size_t unit, const c205_error *why)
{
    if (!pool->stopped && unit < pool->failed) {
        pool->failed = unit;
        pool->error = *why;
    }
}

static void stop(struct pool *pool, const c205_error *why)
{
    if (!pool->stopped)
        pool->error = *why;
    pool->stopped = true;
}

static bool may_go_on(const struct job_set_work *work, size_t done, c205_error *why)
{
    if (work->progress && !work->progress(work->progress_context, done, work->count))
        return error_set(why, "stopped after %zu of %zu packet%s", done, work->count,
                         plural(work->count));
    return !work->go_on || work->go_on(work->context, done, why);
}

static void ask(struct pool *pool)
{
    c205_error why = { "stopped" };
    if (!pool->stopped && pool->done < pool->work->count
        && !may_go_on(pool->work, pool->done, &why))
        stop(pool, &why);
}

static void take_unit(struct pool *pool, size_t unit, struct serialized_result *words)
{
    const struct job_set_work *work = pool->work;
    c205_error why = { "out of memory" };
    if (words->failed
        || (job_set_collects(work->job_set)
            && !work->take(work->context, unit, words, &why))
        || (work->job_set->file
            && !checkpoint_add(work->job_set->file, work->first + unit, words, &why))) {
        stop(pool, &why);
        return;
    }
    pool->done++;
    ask(pool);
}

/* Returns true if the file contains the unit, and its result is valid. */
static bool has_unit(const struct job_set_work *work, size_t unit,
                     struct serialized_result *words)
{
    const struct job_set *job_set = work->job_set;
    c205_error why;
    return job_set->file && checkpoint_read(job_set->file, work->first + unit, words)
           && (!job_set_collects(job_set)
               || work->take(work->context, unit, words, &why));
}

/* Skips the units of other shares, and takes the units that are in the file. */
static void take_kept(struct pool *pool)
{
    const struct job_set_work *work = pool->work;
    struct serialized_result words = { .items = NULL };
    for (size_t unit = 0; unit < work->count && !pool->stopped; unit++) {
        pool->begun[unit] = !is_mine(work->job_set, unit);
        if (has_unit(work, unit, &words)) {
            pool->begun[unit] = true;
            pool->done++;
            ask(pool);
        }
    }
    result_free(&words);
}

/* ---- Threads ------------------------------------------------------------- */

static void do_unit(struct hand *hand, size_t unit)
{
    struct pool *pool = hand->pool;
    const struct job_set_work *work = pool->work;
    struct serialized_result words = { .items = NULL };
    c205_error why = { "out of memory" };
    bool good = work->run(work->context, hand->number, unit, &words, &why);
    lock_take(pool->lock);
    if (good)
        take_unit(pool, unit, &words);
    else
        fail_unit(pool, unit, &why);
    lock_give_back(pool->lock);
    result_free(&words);
}

static void do_units(void *context)
{
    struct hand *hand = context;
    struct pool *pool = hand->pool;
    size_t unit;
    bool more = true;
    while (more) {
        lock_take(pool->lock);
        more = take_next(pool, &unit);
        pool->active -= !more;
        lock_give_back(pool->lock);
        if (more)
            do_unit(hand, unit);
    }
}

static size_t begin_hands(struct hand *hands, size_t first, size_t count)
{
    size_t begun = first;
    while (begun < count
           && (hands[begun].thread = thread_begin(do_units, &hands[begun])))
        begun++;
    return begun;
}

/* ---- Ranks --------------------------------------------------------------- */

/* The number of units that rank 0 assigns to another rank in advance. A rank can thus
 * run one unit while the next unit is sent.
 *
 * Each other rank begins with this number of requests. Rank 0 answers a request with a
 * unit, or with RANK_ENDS if there is none. The result of a unit is also a request for
 * another unit. A round is over when all requests have been answered with RANK_ENDS,
 * and the threads of rank 0 have stopped.
 */
enum { AHEAD = 2 };

struct service {
    struct pool *pool;
    struct ranks *ranks;
    size_t *open; /* for each rank: number of requested units that are not finished */
    size_t left;  /* sum of `open` over all ranks */
};

static void close_asked(struct service *service, size_t rank, size_t count)
{
    service->open[rank] -= count;
    service->left -= count;
}

static void give_unit(struct service *service, size_t to)
{
    size_t unit;
    if (take_next(service->pool, &unit)) {
        ranks_send(service->ranks, to, RANK_DOES, unit, NULL);
    } else {
        ranks_send(service->ranks, to, RANK_ENDS, 0, NULL);
        close_asked(service, to, 1);
    }
}

/* Handles a failed unit. If a rank fails before it has a unit, the run stops. */
static void receive_failure(struct service *service, size_t from, uint64_t unit,
                            struct serialized_result *letters)
{
    size_t count = letters->count - letters->at, i = 0;
    char text[sizeof((c205_error *)0)->message];
    c205_error why;
    for (; i < count && i + 1 < sizeof text; i++)
        text[i] = (char)result_take(letters);
    text[i] = '\0';
    if (unit < service->pool->work->count) {
        error_set(&why, "%s", text);
        fail_unit(service->pool, (size_t)unit, &why);
    } else if (service->open[from] > 0) {
        error_set(&why, "rank %zu: %.200s", from, text);
        stop(service->pool, &why);
    }
    close_asked(service, from, service->open[from]);
}

/* Stores the result of a unit: the words after the first two words of the message. */
static void receive_unit(struct service *service, uint64_t unit,
                         struct serialized_result *message)
{
    struct serialized_result words = { .items = NULL };
    result_put_all(&words, message->items + message->at, message->count - message->at);
    take_unit(service->pool, (size_t)unit, &words);
    result_free(&words);
}

static void answer(struct service *service, size_t from,
                   struct serialized_result *message)
{
    uint64_t what = result_take(message), unit = result_take(message);
    if (what == RANK_FAILS) {
        receive_failure(service, from, unit, message);
        return;
    }
    if (what == RANK_DONE)
        receive_unit(service, unit, message);
    give_unit(service, from);
}

/* Serves the other ranks until they and the threads of this process have finished. */
static void serve(struct service *service)
{
    struct pool *pool = service->pool;
    struct serialized_result message = { .items = NULL };
    struct ranks_pause pause = { 0 };
    bool busy = true;
    size_t from;
    while (busy) {
        bool received = ranks_receive(service->ranks, &from, &message);
        lock_take(pool->lock);
        if (received)
            answer(service, from, &message);
        else
            ask(pool);
        busy = service->left > 0 || pool->active > 0;
        lock_give_back(pool->lock);
        if (received)
            pause = (struct ranks_pause){ 0 };
        else if (busy)
            ranks_wait(&pause);
    }
    result_free(&message);
}

static void serve_ranks(struct pool *pool, struct ranks *ranks)
{
    size_t *open = calloc(ranks->count, sizeof *open);
    struct service service = {
        .pool = pool, .ranks = ranks, .open = open, .left = AHEAD * (ranks->count - 1)
    };
    if (!open)
        abort(); /* ends all ranks */
    for (size_t rank = 1; rank < ranks->count; rank++)
        open[rank] = AHEAD;
    serve(&service);
    free(open);
}

static bool do_for_other(const struct job_set_work *work, size_t unit,
                         c205_error *error)
{
    struct serialized_result words = { .items = NULL };
    bool good = work->run(work->context, 0, unit, &words, error) && !words.failed;
    if (good)
        ranks_send(work->job_set->ranks, 0, RANK_DONE, unit, &words);
    else
        ranks_fail(work->job_set->ranks, unit, error->message);
    result_free(&words);
    return good;
}

/* Runs the units that rank 0 assigns to this rank. */
static bool work_for_first(const struct job_set_work *work, c205_error *error)
{
    struct ranks *ranks = work->job_set->ranks;
    size_t open = AHEAD;
    uint64_t unit;
    for (size_t i = 0; i < AHEAD; i++)
        ranks_send(ranks, 0, RANK_ASKS, 0, NULL);
    while (open > 0) {
        enum rank_message what = ranks_await(ranks, &unit);
        if (what == RANK_ENDS)
            open--;
        else if (what != RANK_DOES)
            return error_set(error, "released");
        else if (!do_for_other(work, (size_t)unit, error))
            return false;
    }
    return true;
}

/* ---- All units ----------------------------------------------------------- */

/* Runs all units. If there are other ranks, this thread serves them. Otherwise this
 * thread is the first of the threads that run units. */
static void do_all(struct pool *pool, struct hand *hands, size_t count)
{
    struct ranks *ranks = pool->work->job_set->ranks;
    size_t first = ranks ? 0 : 1, begun;
    pool->active = count;
    begun = begin_hands(hands, first, count);
    lock_take(pool->lock);
    pool->active -= count - begun;
    lock_give_back(pool->lock);
    if (ranks)
        serve_ranks(pool, ranks);
    else
        do_units(&hands[0]);
    for (size_t i = first; i < begun; i++)
        thread_end(hands[i].thread);
}

static bool run_all(struct pool *pool, c205_error *error)
{
    const struct job_set_work *work = pool->work;
    size_t most = work->jobs < work->count ? work->jobs : work->count;
    size_t count = most > 1 ? most : 1;
    struct hand *hands = calloc(count, sizeof *hands);
    pool->begun = calloc(work->count + 1, sizeof *pool->begun);
    pool->lock = lock_new();
    if (!hands || !pool->begun || !pool->lock) {
        free(hands);
        lock_free(pool->lock);
        return error_set(error, "out of memory");
    }
    for (size_t i = 0; i < count; i++)
        hands[i] = (struct hand){ .pool = pool, .number = i };
    take_kept(pool);
    do_all(pool, hands, count);
    lock_free(pool->lock);
    free(hands);
    if (pool->stopped || pool->failed < work->count)
        *error = pool->error;
    return !pool->stopped && pool->failed == work->count;
}

bool job_set_run(const struct job_set_work *work, c205_error *error)
{
    struct job_set alone = { .parts = 0 };
    struct job_set_work mine = *work;
    struct pool pool = { .work = &mine, .failed = work->count };
    bool good;
    if (!mine.job_set)
        mine.job_set = &alone;
    if (!is_first(mine.job_set))
        return work_for_first(&mine, error);
    good = run_all(&pool, error);
    free(pool.begun);
    return good;
}
