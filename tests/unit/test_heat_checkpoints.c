/* test_heat_checkpoints.c - packets of heat, by rays and by lines, that are saved in
 * files. Interrupted runs and shares are compared with a run in one piece, bit for bit.
 * A packet that is lost, computed twice or taken from another run fails here.
 *
 *     test_heat_checkpoints [SEED]
 */
#include <unistd.h>

#include "rt/heat/factors.h"
#include "rt/heat/global_lines.h"
#include "tests/random.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

enum { SHARES = 3, REPEATS = 6, PRIMITIVES = 3, UNITS = REPEATS * PRIMITIVES };
enum { WORDS = 512 };

static uint64_t seed = 1;
static char path[SHARES][40];
static const char *const paths[SHARES] = { path[0], path[1], path[2] };

static const char text[] = "sphere { 0, 1 } sphere { <2.2, 0, 0>, .8 }"
                           "disc { <0, -2, 0>, y, 3 }";

/* A run of packets: the request and its result. */
struct run {
    bool lines;
    size_t jobs, seed;
    struct job_set *job_set;
    size_t stop;     /* stops after this number of packets; 0: never */
    size_t reported; /* largest reported number of finished packets */
    uint64_t clocks; /* clocks of all packets */
    uint64_t words[WORDS];
    size_t count;
    c205_error error;
};

static void put(struct run *run, const void *value, size_t size)
{
    assert_true(run->count + size / sizeof run->words[0] <= WORDS);
    memcpy(&run->words[run->count], value, size);
    run->count += size / sizeof run->words[0];
}

static bool tell(void *context, size_t done, size_t all UNUSED)
{
    struct run *run = context;
    run->reported = done > run->reported ? done : run->reported;
    return run->stop == 0 || done < run->stop;
}

static bool run_rays(struct run *run, const struct scene *scene)
{
    static const size_t all[PRIMITIVES] = { 0, 1, 2 };
    struct sampling_options options = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 100,
                                               .points = 64, .repeats = REPEATS,
                                               .lattice = true, .seed = run->seed,
                                               .jobs = run->jobs,
                                               .job_set = run->job_set,
                                               .progress = tell, .context = run);
    SCOPED(factors) *factors = factors_new(scene, &options, &run->error);
    struct factor_row rows[PRIMITIVES];
    bool good = factors && factors_find(factors, all, PRIMITIVES, rows, &run->error);
    assert_int_equal(factors_units(factors, PRIMITIVES), UNITS);
    for (size_t i = 0; good && i < PRIMITIVES; i++) {
        run->clocks += rows[i].accounts.clocks;
        put(run, &rows[i].area, sizeof rows[i].area);
        put(run, &rows[i].sent, sizeof rows[i].sent);
        put(run, &rows[i].accounts.clocks, sizeof rows[i].accounts.clocks);
        put(run, rows[i].factor, rows[i].receivers * sizeof *rows[i].factor);
        put(run, rows[i].count, rows[i].receivers * sizeof *rows[i].count);
        factor_row_free(&rows[i]);
    }
    return good;
}

static bool run_lines(struct run *run, const struct scene *scene)
{
    struct sampling_options options = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 100,
                                               .lines_log = 6, .repeats = UNITS,
                                               .lattice = true, .seed = run->seed,
                                               .jobs = run->jobs,
                                               .job_set = run->job_set,
                                               .progress = tell, .context = run);
    struct global_lines found;
    if (!global_lines_find(scene, &options, &found, &run->error))
        return false;
    assert_int_equal(found.units, UNITS);
    run->clocks = found.accounts.clocks;
    put(run, &found.accounts.clocks, sizeof found.accounts.clocks);
    put(run, found.ends,
        UNITS * (PRIMITIVES + 1) * (PRIMITIVES + 1) * sizeof *found.ends);
    global_lines_free(&found);
    return true;
}

static bool do_run(struct run *run)
{
    SCOPED(scene) *scene = read_scene(text);
    bool good = run->lines ? run_lines(run, scene) : run_rays(run, scene);
    if (run->job_set)
        job_set_close(run->job_set, false);
    return good;
}

static struct run begin(bool lines, struct job_set *job_set)
{
    size_t jobs = 1 + (size_t)(xorshift(&seed) % 3);
    return (struct run){ .lines = lines, .jobs = jobs, .seed = 7, .job_set = job_set };
}

static void assert_same(const struct run *run, const struct run *other)
{
    assert_int_equal(run->count, other->count);
    assert_memory_equal(run->words, other->words, run->count * sizeof run->words[0]);
}

static struct run find_alone(bool lines)
{
    struct run alone = begin(lines, NULL);
    assert_true(do_run(&alone));
    assert_true(alone.clocks > 0);
    return alone;
}

/* ---- Stopped at random ---------------------------------------------------------- */

TEST(stopped)
{
    for (int lines = 0; lines < 2; lines++) {
        struct run alone = find_alone(lines);
        for (int i = 0; i < 3; i++) {
            struct job_set first = { .paths = paths, .path_count = 1 };
            struct job_set second = first;
            struct run stopped = begin(lines, &first), next = begin(lines, &second);
            stopped.stop = 1 + (size_t)(xorshift(&seed) % (UNITS - 1));
            assert_false(do_run(&stopped));
            assert_non_null(strstr(stopped.error.message, "stopped after"));
            assert_true(do_run(&next));
            assert_true(second.kept >= stopped.stop && second.kept < UNITS);
            assert_same(&next, &alone);
            remove(path[0]);
        }
    }
}

/* ---- Shares ---------------------------------------------------------------------- */

TEST(shares)
{
    for (int lines = 0; lines < 2; lines++) {
        struct run alone = find_alone(lines);
        struct job_set all = { .paths = paths, .path_count = SHARES };
        for (size_t i = 0; i < SHARES; i++) {
            struct job_set job_set = {
                .part = i + 1, .parts = SHARES, .paths = &paths[i], .path_count = 1
            };
            struct run share = begin(lines, &job_set);
            assert_true(do_run(&share));
            assert_int_equal(share.reported, (size_t)UNITS / SHARES);
        }
        struct run together = begin(lines, &all);
        assert_true(do_run(&together));
        assert_int_equal(all.kept, UNITS);
        assert_same(&together, &alone);
        for (size_t i = 0; i < SHARES; i++)
            remove(path[i]);
    }
}

/* ---- Packets of another run ------------------------------------------------------ */

TEST(others)
{
    for (int lines = 0; lines < 2; lines++) {
        struct job_set first = { .paths = paths, .path_count = 1 };
        struct job_set second = first, third = first;
        struct run run = begin(lines, &first), seeded = begin(lines, &second),
                   other = begin(!lines, &third);
        assert_true(do_run(&run));
        seeded.seed++;
        assert_false(do_run(&seeded));
        assert_non_null(strstr(seeded.error.message, "another"));
        assert_false(do_run(&other));
        assert_non_null(strstr(other.error.message, "another"));
        remove(path[0]);
    }
}

FIXTURE(name_paths)
{
    for (size_t i = 0; i < SHARES; i++)
        snprintf(path[i], sizeof path[i], "/tmp/rt205-kept-%ld-%zu", (long)getpid(), i);
    return set_up_model(test_state);
}

ARGUMENTS(argc, argv)
{
    seed = argument(argc, argv, 1, seed);
}

GROUP(name_paths, tear_down_model);
