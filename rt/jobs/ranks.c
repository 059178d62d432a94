/* ranks.c - sends and receives messages between the ranks of a run. */
#include "rt/jobs/ranks.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "vm/error.h"
#include "rt/platform/dynamic_library.h"

bool ranks_are_many(void)
{
    const char *count = getenv("OMPI_COMM_WORLD_SIZE");
    return count && strtol(count, NULL, 10) > 1;
}

/* Opens the MPI adapter with global symbols, because plugins of the MPI library refer
 * to symbols of the library. */
static const struct ranks_adapter *find_adapter(c205_error *error)
{
    char path[ADAPTER_PATH];
    c205_error why;
    const void *table;
    if (!dynamic_find(RANKS_FILE, path, &why)) {
        error_set(error,
                  "ranks: %.160s: build it with make mpi, which requires the package "
                  "libopenmpi-dev",
                  why.message);
        return NULL;
    }
    table = dynamic_open(path, RANKS_SYMBOL, true, &why);
    if (!table)
        error_set(error, "ranks: %.160s: install the package openmpi-bin", why.message);
    return table;
}

bool ranks_join(struct ranks *ranks, c205_error *error)
{
    *ranks = (struct ranks){ .adapter = find_adapter(error) };
    return ranks->adapter
           && (ranks->adapter->begin(&ranks->rank, &ranks->count)
               || error_set(error, "ranks: cannot start MPI"));
}

/* ---- Messages ------------------------------------------------------------ */

void ranks_send(const struct ranks *ranks, size_t to, enum rank_message message,
                uint64_t word, const struct serialized_result *more)
{
    size_t count = more ? more->count : 0;
    uint64_t *words = malloc((count + 2) * sizeof *words);
    if (!words)
        abort(); /* ends all ranks */
    words[0] = message;
    words[1] = word;
    if (count > 0)
        memcpy(words + 2, more->items, count * sizeof *words);
    ranks->adapter->send(to, words, count + 2);
    free(words);
}

bool ranks_receive(const struct ranks *ranks, size_t *from,
                   struct serialized_result *message)
{
    size_t count;
    if (!ranks->adapter->ready(from, &count))
        return false;
    if (!result_resize(message, count))
        abort();
    ranks->adapter->receive(*from, message->items, count);
    return true;
}

void ranks_wait(struct ranks_pause *pause)
{
    enum { MIN_MOMENT = 50000, MAX_MOMENT = 4000000 }; /* pauses in nanoseconds */
    struct timespec moment = { 0, MIN_MOMENT };
    if (pause->nanoseconds > 0)
        moment.tv_nsec = pause->nanoseconds;
    nanosleep(&moment, NULL);
    pause->nanoseconds = 2 * moment.tv_nsec < MAX_MOMENT ? 2 * moment.tv_nsec
                                                         : MAX_MOMENT;
}

enum rank_message ranks_await(struct ranks *ranks, uint64_t *word)
{
    struct serialized_result message = { .items = NULL };
    struct ranks_pause pause = { 0 };
    enum rank_message what;
    size_t from;
    while (!ranks_receive(ranks, &from, &message))
        ranks_wait(&pause);
    what = (enum rank_message)result_take(&message);
    *word = result_take(&message);
    result_free(&message);
    ranks->released |= what == RANK_FREE;
    return what;
}

bool ranks_agree(struct ranks *ranks, uint64_t *word)
{
    if (ranks->rank > 0)
        return !ranks->released && ranks_await(ranks, word) == RANK_AGREES;
    for (size_t to = 1; to < ranks->count; to++)
        ranks_send(ranks, to, RANK_AGREES, *word, NULL);
    return true;
}

/* ---- The end ------------------------------------------------------------- */

static void release(const struct ranks *ranks)
{
    struct serialized_result message = { .items = NULL };
    struct ranks_pause pause = { 0 };
    size_t left = ranks->count - 1, from;
    for (size_t to = 1; to < ranks->count; to++)
        ranks_send(ranks, to, RANK_FREE, 0, NULL);
    while (left > 0)
        if (ranks_receive(ranks, &from, &message))
            left -= result_take(&message) == RANK_LEAVES;
        else
            ranks_wait(&pause);
    result_free(&message);
}

void ranks_fail(const struct ranks *ranks, uint64_t unit, const char *failure)
{
    struct serialized_result letters = { .items = NULL };
    for (const char *at = failure; *at; at++)
        result_put(&letters, (unsigned char)*at);
    ranks_send(ranks, 0, RANK_FAILS, unit, &letters);
    result_free(&letters);
}

void ranks_leave(struct ranks *ranks, const char *failure)
{
    uint64_t word;
    if (ranks->rank == 0) {
        release(ranks);
    } else {
        if (failure && !ranks->released)
            ranks_fail(ranks, UINT64_MAX, failure);
        while (!ranks->released)
            ranks_await(ranks, &word);
        ranks_send(ranks, 0, RANK_LEAVES, 0, NULL);
    }
    ranks->adapter->end();
}
