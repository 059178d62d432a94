/* test_recording.c - recorded runs that are replayed on other models are compared with
 * runs on these models, and projections with clocks computed by hand. A clock of
 * another cause or region fails here. */
#include "named_model.h"
#include "saved_machine.h"

#include <math.h>

#include "base/accounts.h"

enum { REGIONS = 8 };

struct run {
    c205_model *model;
    struct object *object;
    c205 *machine;
    c205_recording *recording;
};

static void assert_runs(c205 *machine)
{
    c205_error error;
    c205_stop stop = c205_run(machine, C205_NO_LIMIT);
    c205_describe_stop(machine, &stop, &error);
    if (stop.trap != C205_TRAP_NONE)
        fail_msg("%s", error.message);
}

/* Loads a program into a machine, which is recorded. */
static struct run loaded(c205_model *model, const char *path)
{
    static const char *const folders[] = { "rt/kernels", NULL };
    struct asm_options options = { .search = folders };
    SCOPED_VALUE(diagnostics) errors = { 0 };
    c205_error error;
    struct run run = { .model = model,
                       .object = assemble_file(path, &options, &errors),
                       .machine = c205_new(model, &error),
                       .recording = c205_recording_new(&error) };
    if (!run.object)
        fail_msg("%s: %s", path, errors.items[0].message);
    assert_non_null(run.machine);
    assert_non_null(run.recording);
    assert_true(c205_load(run.machine, &run.object->program, &error));
    assert_true(c205_listen(run.machine, c205_record, run.recording));
    return run;
}

static struct run run_of(c205_model *model, const char *path)
{
    struct run run = loaded(model, path);
    assert_runs(run.machine);
    return run;
}

static struct run prior_run(const char *path)
{
    return run_of(named_model("cyber205-2pipe-prior"), path);
}

static void run_free(struct run *run)
{
    c205_recording_free(run->recording);
    c205_free(run->machine);
    object_free(run->object);
    c205_model_free(run->model);
}

/* Replayed with a model and settings, the recording must give the clocks of the run. */
static void assert_retimes(const struct run *recorded, const struct run *ran,
                           const c205_model *model, const c205_setting *settings,
                           size_t count)
{
    double clocks[REGIONS];
    c205_error error;
    assert_true(c205_retime(recorded->recording, model, settings, count, 1, clocks,
                            REGIONS, &error));
    for (size_t i = 0; i < c205_account_count(ran->machine); i++)
        assert_true(clocks[i]
                    == (double)accounts_clocks(c205_account_at(ran->machine, i)));
}

/* A recording that is made on one model gives the clocks of a run on another. */
static void compare(const char *path, const char *other, const c205_setting *settings,
                    size_t count)
{
    SCOPED_VALUE(run) recorded = prior_run(path);
    SCOPED_VALUE(run) ran = run_of(named_model(other), path);
    assert_retimes(&recorded, &ran, settings ? recorded.model : ran.model, settings,
                   count);
}

TEST(same_clocks)
{
    static const char *const paths[] = {
        "asm/examples/sieve.s",           "asm/examples/lookup.s",
        "asm/examples/saxpy_linked.s",    "rt/study/fit/programs/linpack.s",
        "rt/study/fit/programs/gather.s", "rt/study/fit/programs/photons.s",
        "tests/programs/recurrence.s",    "tests/programs/link_recurrence.s"
    };
    for (size_t i = 0; i < COUNT(paths); i++) {
        compare(paths[i], "cyber205-2pipe-prior", NULL, 0);
        compare(paths[i], "cyber205-4pipe-prior", NULL, 0);
    }
}

TEST(settings)
{
    static const c205_setting pipes[] = { { "machine.pipes", 4 } };
    compare("rt/study/fit/programs/photons.s", "cyber205-4pipe-prior", pipes, 1);
}

/* Other page sizes, as settings and as a changed model, are compared with a machine
 * that has them. Its clocks must differ from those of the recorded run. */
static void compare_pages(const char *path, const c205_setting *settings, size_t count)
{
    SCOPED_VALUE(run) recorded = prior_run(path);
    c205_error error;
    c205_model *changed = c205_model_change(recorded.model, settings, count, &error);
    assert_non_null(changed);
    SCOPED_VALUE(run) ran = run_of(changed, path);
    assert_true(c205_clock(ran.machine) > c205_clock(recorded.machine));
    assert_retimes(&recorded, &ran, recorded.model, settings, count);
    assert_retimes(&recorded, &ran, changed, NULL, 0);
}

TEST(pages)
{
    static const c205_setting small[] = { { "page.words", 512 } };
    static const c205_setting fixture[] = { { "page.words", 2048 },
                                            { "memory.real_words", 9000 },
                                            { "translation.registers", 2 } };
    static const char *const paths[] = { "rt/study/fit/programs/linpack.s",
                                         "rt/study/fit/programs/gather.s",
                                         "rt/study/fit/programs/photons.s" };
    for (size_t i = 0; i < COUNT(paths); i++) {
        compare_pages(paths[i], small, 1);
        compare_pages(paths[i], fixture, 3);
    }
}

/* Returns the clocks of the second region, with `ticks` ticks per clock. */
static double retimed(const struct run *run, const c205_setting *setting,
                      unsigned ticks)
{
    double clocks[REGIONS];
    c205_error error;
    assert_true(c205_retime(run->recording, run->model, setting, setting != NULL, ticks,
                            clocks, REGIONS, &error));
    return clocks[1];
}

/* With a thousand ticks per clock, integer constants give the same clocks except for
 * rounding up to full clocks. Fractional constants give values in between. */
TEST(ticks)
{
    static const c205_setting settings[] = { { "latency.load", 15.5 },
                                             { "latency.load", 16 } };
    SCOPED_VALUE(run) run = prior_run("rt/study/fit/programs/linpack.s");
    double whole = retimed(&run, NULL, 1), fine = retimed(&run, NULL, 1000);
    double between = retimed(&run, &settings[0], 1000);
    double low = retimed(&run, &settings[1], 1000);

    assert_true(fabs(whole - fine) < .003 * whole);
    assert_true(fabs(2 * between - fine - low) < 1);
    assert_true(fine < between && between < low);
}

TEST(gather_in_ticks)
{
    SCOPED_VALUE(run) run = prior_run("rt/study/fit/programs/gather.s");
    assert_true(retimed(&run, NULL, 1) == retimed(&run, NULL, 100));
}

TEST(errors)
{
    static const c205_setting unknown = { "latency.none", 1 };
    static const c205_setting too_small = { "latency.load", -1 };
    c205_error error;
    double clocks[REGIONS];
    SCOPED(c205_model) *projection = named_model("cyber720");
    SCOPED_VALUE(run) run = loaded(named_model("cyber205-2pipe-prior"),
                                   "asm/examples/dot.s");
    SCOPED(c205_projection) *charged = c205_projection_new(projection, &error);
    assert_non_null(charged);
    assert_true(c205_listen(run.machine, c205_project, charged));
    assert_runs(run.machine);
    assert_false(c205_projection_holds(charged, &error));
    assert_string_equal(error.message, "3 vector instructions cannot be projected");
    assert_false(
        c205_retime(run.recording, run.model, &unknown, 1, 1, clocks, 1, &error));
    assert_string_equal(error.message, "unknown constant 'latency.none'");
    assert_false(
        c205_retime(run.recording, run.model, &too_small, 1, 1, clocks, 1, &error));
    assert_string_equal(error.message, "latency.load must be between 1 and 1000000");
    assert_true(
        c205_retime(run.recording, projection, NULL, 0, 1, clocks, REGIONS, &error));
    assert_true(isnan(clocks[0]) || isnan(clocks[1]));
    assert_null(c205_new(projection, &error));
    assert_string_equal(error.message,
                        "cyber720 is a projection and cannot run programs");
    assert_null(c205_projection_new(run.model, &error));
}

/* ---- Projections --------------------------------------------------------- */

static const char chain[] =
    "        .data\n"
    "a:      .word 1.0, 2.0\n"
    "save:   .space 2\n"
    "        .code\n"
    "        EX   r10, a\n"            /* single */
    "        ELEN r10, 2\n"            /* single */
    "        EX   r11, save\n"         /* single */
    "        ELEN r11, 2\n"            /* single */
    "        SWAP [r10], r20, [r11]\n" /* two loads, two stores */
    "        MPYS r20, r21, r22\n"     /* multiply */
    "        ADDN r22, r21, r23\n"     /* add */
    "        ADDN r20, r21, r24\n"     /* add */
    "        CFPLT r23, r24, next\n"   /* add, not taken: 4 and 3 */
    "next:   EXIT\n";                  /* monitor */

static double projected(const char *model_text)
{
    c205_error error;
    SCOPED(object) *object = good(chain);
    SCOPED(c205_model) *model = named_model("cyber205-2pipe-prior");
    SCOPED(c205_model) *projection_model = parsed_model(model_text);
    SCOPED(c205) *machine = machine_with(&object->program, model);
    SCOPED(c205_projection) *projection = c205_projection_new(projection_model, &error);
    assert_non_null(projection);
    assert_true(c205_listen(machine, c205_project, projection));
    assert_runs(machine);
    assert_true(c205_projection_holds(projection, &error));
    double clocks = (double)c205_projected_clocks(projection, 0);
    assert_int_equal(c205_projected_clocks(projection, 5), 0);
    return clocks;
}

/* 4 x 2, 2 x 100, 2 x 1000, 30, 2 x 20 and 20 + 7, monitor 1. */
TEST_CALL(serial,
          assert_true(projected("title t\nlike cyber720\n"
                                "time.single 2 clk R\ntime.load 100 clk R\n"
                                "time.store 1000 clk R\ntime.multiply 30 clk R\n"
                                "time.add 20 clk R\nbranch.not_taken 7 clk R\n"
                                "time.monitor 1 clk R\n")
                      == 8 + 200 + 2000 + 30 + 40 + 27 + 1))

/* The 6600 with one increment unit and an adder. EX issues at 0. ELEN waits for the
 * unit and r10, 3 .. 6. EX r11 takes 6 .. 9, ELEN 9 .. 12; issue ends at 10. SWAP
 * begins at 12: four addresses of 3, then the last store 10, until 34. MPYS takes 34 ..
 * 44. ADDN waits in its unit for r22, 44 .. 52; the other ADDN waits for the adder, 52
 * .. 60, and its issue ends at 53. The branch waits for r24: 60 + 8 + 8 = 76. EXIT
 * issues one clock later. */
TEST_CALL(scoreboard,
          assert_true(projected("title t\nlike cdc6600\nunits.single 1 units R\n")
                      == 77))

TEST(projection_models)
{
    static const char *const rows[][2] = {
        { "title t\nprojection\nstartup.vadd 3 clk R\n",
          "t:3: unknown constant 'startup.vadd'" },
        { "title t\nprojection here\n",
          "t:2: expected the end of the line, found 'here'" },
        { "title t\nlike cyber205-2pipe-prior\nprojection\n",
          "t:3: 'projection' must be before the constants" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        c205_error error;
        assert_null(c205_model_parse("t", rows[i][0], &error));
        assert_string_equal(error.message, rows[i][1]);
    }
}
