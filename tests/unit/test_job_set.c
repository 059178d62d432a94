/* test_job_set.c - results of jobs in threads, in shares and in killed processes are
 * compared with the jobs' numbers, over random counts, errors and kills. Each unit must
 * run once and be taken once. A unit that is lost or run twice fails here. */
#include "rt/jobs/job_set.h"

#include <signal.h>
#include <time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "vm/error.h"
#include "tests/unit/draw.h"
#include "tests/unit/unit.h"

enum { MAX = 50, TRIES = 80, KILLS = 20, SHARES = 5, KEY = 205 };

static char path[SHARES][40];
static const char *const paths[SHARES] = { path[0], path[1], path[2], path[3],
                                           path[4] };

struct bench {
    size_t count;
    size_t bad;  /* index of the first unit that fails; count: none */
    size_t last; /* index of the unit in which the process kills itself; count: none */
    int run[MAX], taken[MAX];
    uint64_t sum; /* sum of the units' results, weighted by their numbers */
};

static uint64_t worth(size_t unit)
{
    uint64_t one = unit + 1;
    return xorshift(&one);
}

static bool run(void *context, size_t job UNUSED, size_t unit,
                struct serialized_result *words, c205_error *error)
{
    struct bench *bench = context;
    bench->run[unit]++;
    if (unit == bench->last) {
        struct timespec moment = { 0, (long)count_between(0, 300000) };
        nanosleep(&moment, NULL);
        raise(SIGKILL);
    }
    if (unit >= bench->bad && unit % 3 == bench->bad % 3)
        return error_set(error, "bad %zu", unit);
    result_put(words, worth(unit));
    return true;
}

static bool take(void *context, size_t unit, struct serialized_result *words,
                 c205_error *error)
{
    struct bench *bench = context;
    uint64_t word = result_take(words);
    assert_true(word == worth(unit));
    bench->taken[unit]++;
    bench->sum += word * (unit + 1);
    return !words->failed || error_set(error, "no word");
}

static bool do_job_set(struct job_set *job_set, struct bench *bench, size_t jobs,
                       c205_error *error)
{
    const struct job_set_work work = { .job_set = job_set,
                                       .count = bench->count,
                                       .jobs = jobs,
                                       .first = 7,
                                       .run = run,
                                       .take = take,
                                       .context = bench };
    return job_set_open(job_set, KEY, error) && job_set_run(&work, error);
}

/* Each unit is taken once and runs once, or again after a killed process. */
static void assert_all_taken(const struct bench *bench, bool killed)
{
    for (size_t unit = 0; unit < bench->count; unit++) {
        assert_int_equal(bench->taken[unit], 1);
        assert_true(killed || bench->run[unit] == 1);
    }
}

static struct bench new_bench(size_t count)
{
    return (struct bench){ .count = count, .bad = count, .last = count };
}

/* ---- Tests --------------------------------------------------------------- */

TEST(threads)
{
    for (int i = 0; i < TRIES; i++) {
        struct bench bench = new_bench(count_between(0, MAX));
        struct job_set job_set = { .parts = 0 };
        assert_true(do_job_set(&job_set, &bench, count_between(0, 5), &failure));
        assert_all_taken(&bench, false);
    }
}

/* The lowest failing unit sets the error for any threads; earlier ones are taken. */
TEST(bad)
{
    for (int i = 0; i < TRIES; i++) {
        struct bench bench = new_bench(count_between(1, MAX));
        struct job_set job_set = { .parts = 0 };
        c205_error error = { "" };
        bench.bad = count_between(0, bench.count - 1);
        const char *text = formatted("bad %zu", bench.bad);
        assert_false(do_job_set(&job_set, &bench, count_between(1, 5), &error));
        assert_string_equal(error.message, text);
        for (size_t unit = 0; unit < bench.bad; unit++)
            assert_int_equal(bench.taken[unit], 1);
        assert_int_equal(bench.taken[bench.bad], 0);
    }
}

/* Shares run in any order. No unit is in two shares, and each unit is in a share. */
TEST(shares)
{
    for (int i = 0; i < TRIES; i++) {
        struct bench bench = new_bench(count_between(0, MAX));
        size_t parts = count_between(1, SHARES), first = count_between(0, parts - 1);
        struct job_set all = { .paths = paths, .path_count = parts };
        for (size_t k = 0; k < parts; k++) {
            size_t part = (first + k) % parts;
            struct job_set job_set = {
                .part = part + 1, .parts = parts, .paths = &paths[part], .path_count = 1
            };
            assert_false(job_set_collects(&job_set));
            assert_true(do_job_set(&job_set, &bench, count_between(1, 3), &failure));
            job_set_close(&job_set, false);
        }
        assert_true(do_job_set(&all, &bench, 2, &failure));
        assert_int_equal(all.kept, bench.count);
        assert_all_taken(&bench, false);
        job_set_close(&all, true);
        for (size_t k = 1; k < parts; k++)
            remove(paths[k]);
    }
}

TEST(killed)
{
    struct bench whole = new_bench(MAX);
    struct job_set alone = { .parts = 0 };
    size_t kept = 0;
    assert_true(do_job_set(&alone, &whole, 1, &failure));
    for (int i = 0; i < KILLS; i++) {
        struct bench bench = new_bench(MAX), killed = new_bench(MAX);
        struct job_set job_set = { .paths = paths, .path_count = 1 };
        killed.last = count_between(0, MAX - 1);
        pid_t child = fork();
        int status;

        /* The process ends in a random unit while its other thread works. */
        assert_true(child >= 0);
        if (child == 0) {
            do_job_set(&job_set, &killed, 2, &failure);
            _exit(1);
        }
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFSIGNALED(status));
        assert_true(do_job_set(&job_set, &bench, 2, &failure));
        assert_all_taken(&bench, true);
        assert_int_equal(bench.sum, whole.sum);
        kept += job_set.kept;
        job_set_close(&job_set, true);
    }
    assert_true(kept > 0 && kept < KILLS * MAX);
}

FIXTURE(name_paths)
{
    for (size_t i = 0; i < SHARES; i++)
        snprintf(path[i], sizeof path[i], "/tmp/rt205-jobs-%ld-%zu", (long)getpid(), i);
    return 0;
}

GROUP(name_paths, NULL);
