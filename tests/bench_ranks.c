/* bench_ranks.c - the work of rank 0 for a unit of another rank: it receives the
 * message, takes the words and sends the next unit.
 *
 *     mpirun -n RANKS bench_ranks UNITS WORDS
 *
 * Prints the wall seconds and the processor seconds of rank 0 per unit. The units
 * themselves take no time. RT205_LIBDIR is the folder of the dynamic library.
 */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "rt/jobs/job_set.h"

static double now(clockid_t clock)
{
    struct timespec time;
    clock_gettime(clock, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

struct load {
    struct ranks *ranks;
    size_t units, words;
    pthread_mutex_t lock;
    size_t taken; /* units, protected by lock */
};

static size_t count_taken(struct load *load, size_t more)
{
    pthread_mutex_lock(&load->lock);
    size_t taken = load->taken += more;
    pthread_mutex_unlock(&load->lock);
    return taken;
}

/* The own thread of rank 0 holds the last unit until all other units are done. */
static bool run_unit(void *context, size_t job, size_t unit,
                     struct serialized_result *words, c205_error *error)
{
    struct load *load = context;
    struct ranks_pause pause = { 0 };
    (void)job, (void)error;
    while (load->ranks->rank == 0 && count_taken(load, 0) + 1 < load->units)
        ranks_wait(&pause);
    for (size_t i = 0; i < load->words; i++)
        result_put(words, unit + i);
    return true;
}

static bool take_unit(void *context, size_t unit, struct serialized_result *words,
                      c205_error *error)
{
    struct load *load = context;
    (void)unit, (void)error;
    count_taken(load, 1);
    return words->count == load->words;
}

int main(int argc, char **argv)
{
    struct ranks ranks = { .adapter = NULL };
    struct job_set job_set = { .ranks = &ranks };
    struct load load = { .ranks = &ranks, .lock = PTHREAD_MUTEX_INITIALIZER };
    struct job_set_work work = { .job_set = &job_set,
                                 .jobs = 1,
                                 .run = run_unit,
                                 .take = take_unit,
                                 .context = &load };
    c205_error error = { "usage: mpirun -n RANKS bench_ranks UNITS WORDS" };
    double began, worked;
    if (argc != 3 || !ranks_are_many() || !ranks_join(&ranks, &error)) {
        fprintf(stderr, "bench_ranks: %s\n", error.message);
        return 1;
    }
    work.count = strtoull(argv[1], NULL, 10);
    load.units = work.count;
    load.words = strtoull(argv[2], NULL, 10);
    began = now(CLOCK_MONOTONIC);
    worked = now(CLOCK_PROCESS_CPUTIME_ID);
    bool good = job_set_run(&work, &error);
    if (ranks.rank == 0 && good)
        printf("%.3e %.3e\n", (now(CLOCK_MONOTONIC) - began) / (double)work.count,
               (now(CLOCK_PROCESS_CPUTIME_ID) - worked) / (double)work.count);
    ranks_leave(&ranks, good ? NULL : error.message);
    return good ? 0 : 1;
}
