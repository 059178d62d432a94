/* test_thread_pool.c - tasks in threads. The tasks that ran and the reported progress
 * are compared with random expectations. Each task must run once, in its place. A task
 * that runs twice or is lost, or a progress that decreases, fails here. */
#include <time.h>
#include <unistd.h>

#include "vm/error.h"
#include "rt/platform/thread_pool.h"
#include "rt/platform/processors.h"
#include "tests/random.h"
#include "tests/unit/unit.h"

enum { MAX = 40, STEPS = 5 };

struct bench {
    size_t count;
    int times[MAX]; /* number of runs of each task */
    size_t bad;     /* index of the task that fails; MAX: none */
    bool slow;      /* the failing task is slow, and all later tasks fail at once */
    size_t last, all, ends;
    size_t stop_at; /* progress requests a stop at this value; SIZE_MAX: never */
    bool falls;     /* the progress decreased */
};

static bool watch(void *context, size_t done, size_t all)
{
    struct bench *bench = context;
    bench->falls |= done < bench->last || bench->ends > 0;
    bench->last = done;
    bench->all = all;
    bench->ends += done == all;
    return done < bench->stop_at;
}

static bool run(void *context, const struct task *task, c205_error *error)
{
    const struct timespec while_others_fail = { 0, 2000000 };
    struct bench *bench = context;
    bench->times[task->number]++;
    if (bench->slow && task->number == bench->bad)
        nanosleep(&while_others_fail, NULL);
    if (bench->slow && task->number > bench->bad)
        return error_set(error, "worse");
    for (size_t step = 0; step <= STEPS; step++)
        if (task->progress && !task->progress(task->context, step, STEPS)
            && step < STEPS) /* a complete run continues */
            return error_set(error, "stopped");
    if (task->number == bench->bad)
        return error_set(error, "bad %zu", task->number);
    return true;
}

static double weight(const void *context UNUSED, size_t number)
{
    return (double)(1 + number % 7);
}

static bool go(struct bench *bench, size_t jobs, bool watched, c205_error *error)
{
    const struct thread_pool tasks = { .count = bench->count,
                                       .jobs = jobs,
                                       .run = run,
                                       .weight = jobs % 2 ? weight : NULL,
                                       .context = bench,
                                       .progress = watched ? watch : NULL,
                                       .progress_context = bench };
    return thread_pool_run(&tasks, error);
}

TEST(each_once)
{
    uint64_t random = RANDOM_SEED + 1;
    for (int i = 0; i < 200; i++) {
        struct bench bench = { .count = xorshift_below(&random, MAX + 1),
                               .bad = MAX,
                               .stop_at = SIZE_MAX };
        bool watched = xorshift_below(&random, 2) > 0;
        assert_true(go(&bench, xorshift_below(&random, 9), watched, &failure));
        for (size_t k = 0; k < MAX; k++)
            assert_int_equal(bench.times[k], k < bench.count);
        assert_false(bench.falls);
        assert_int_equal(bench.ends, watched);
    }
}

TEST(a_bad_one)
{
    uint64_t random = RANDOM_SEED + 2;
    c205_error error;
    for (int i = 0; i < 100; i++) {
        struct bench bench = { .count = 1 + xorshift_below(&random, MAX),
                               .stop_at = SIZE_MAX };
        size_t jobs = xorshift_below(&random, 5);
        bench.bad = xorshift_below(&random, bench.count);
        const char *expected = formatted("bad %zu", bench.bad);
        assert_false(go(&bench, jobs, xorshift_below(&random, 2) > 0, &error));
        assert_string_equal(error.message, expected);
        assert_int_equal(bench.ends, 0);
        for (size_t k = 0; jobs < 2 && k < bench.count; k++)
            assert_int_equal(bench.times[k], k <= bench.bad);
    }
}

/* Many tasks fail. The lowest of them fails last, and its error is reported. */
TEST(the_lowest_of_many)
{
    uint64_t random = RANDOM_SEED + 3;
    c205_error error;
    for (int i = 0; i < 100; i++) {
        struct bench bench = { .count = 1 + xorshift_below(&random, MAX),
                               .slow = true,
                               .stop_at = SIZE_MAX };
        bench.bad = xorshift_below(&random, bench.count);
        const char *expected = formatted("bad %zu", bench.bad);
        assert_false(go(&bench, 2 + xorshift_below(&random, 7), i % 2, &error));
        assert_string_equal(error.message, expected);
    }
}

TEST(reported_to_stop)
{
    c205_error error;
    for (size_t jobs = 0; jobs < 5; jobs++) {
        struct bench bench = { .count = MAX, .bad = MAX, .stop_at = 500000 };
        int ran = 0;
        assert_false(go(&bench, jobs, true, &error));
        assert_string_equal(error.message, "stopped");
        for (size_t k = 0; k < MAX; k++)
            ran += bench.times[k];
        assert_true(ran < MAX * 3 / 4);
        assert_int_equal(bench.ends, 0);
    }
}

TEST(jobs_wanted)
{
    size_t online = (size_t)sysconf(_SC_NPROCESSORS_ONLN);
    assert_int_equal(jobs_wanted(0, SIZE_MAX), online);
    assert_int_equal(jobs_wanted(0, 1), 1);
    assert_int_equal(jobs_wanted(3, 256), 3);
    assert_int_equal(jobs_wanted(300, 256), 256);
}
