/* test_recording.c - every test program and example is recorded and replayed. The
 * clocks on the model of the run, on other models and on projections are compared with
 * runs on these models. The clocks of projections are also compared with values
 * computed by hand. A clock of another cause or region fails here. */
#include "named_model.h"
#include "saved_machine.h"

#include <math.h>

#include "base/accounts.h"

enum { REGIONS = 16, PROJECTIONS = 2 };

#define PRIOR "cyber205-2pipe-prior"

struct run {
    c205_model *model;
    struct object *object;
    c205 *machine;
    c205_recording *recording;
};

static void assert_runs(c205 *machine)
{
    c205_stop stop = c205_run(machine, C205_NO_LIMIT);
    c205_describe_stop(machine, &stop, &failure);
    FAIL_IF(stop.trap != C205_TRAP_NONE, "%s", failure.message);
}

static struct object *program_of(const char *path)
{
    static const char *const folders[] = { "rt/kernels", NULL };
    struct asm_options options = { .search = folders };
    SCOPED_VALUE(diagnostics) errors = { 0 };
    struct object *object = assemble_file(path, &options, &errors);
    FAIL_IF(!object, "%s: %s", path, errors.items[0].message);
    return object;
}

/* Loads a program into a machine whose run is recorded. */
static struct run loaded(c205_model *model, struct object *object)
{
    struct run run = { .model = model,
                       .object = object,
                       .machine = machine_with(&object->program, model),
                       .recording = c205_recording_new(&failure) };
    assert_non_null(run.recording);
    assert_true(c205_listen(run.machine, c205_record, run.recording));
    return run;
}

static struct run run_of(c205_model *model, const char *path)
{
    struct run run = loaded(model, program_of(path));
    assert_runs(run.machine);
    return run;
}

static void run_free(struct run *run)
{
    c205_recording_free(run->recording);
    c205_free(run->machine);
    object_free(run->object);
    c205_model_free(run->model);
}

/* A replay of the recording, with a model and settings, must give the clocks of a
 * machine or a projection. Projections have no clocks for vector instructions, so
 * regions with vector instructions are skipped. */
static void assert_retimes(const char *name, const struct run *recorded,
                           const c205_model *model, const c205_setting *settings,
                           size_t setting_count, const c205 *machine,
                           const c205_projection *projection)
{
    double clocks[REGIONS];
    size_t count = machine ? c205_account_count(machine) : REGIONS;
    assert_true(count <= REGIONS);
    assert_true(c205_retime(recorded->recording, model, settings, setting_count, 1,
                            clocks, REGIONS, &failure));
    for (size_t i = 0; i < count; i++) {
        uint64_t expected = machine ? accounts_clocks(c205_account_at(machine, i))
                                    : c205_projected_clocks(projection, i);
        FAIL_IF(!(projection && isnan(clocks[i])) && clocks[i] != (double)expected,
                "%s on %s: %llu clocks in region %zu, played again %g", name,
                c205_model_name(model), (unsigned long long)expected, i, clocks[i]);
    }
}

/* ---- Programs ---------------------------------------------------------- */

/* Records a run. Compares replays on its model, on other pipes and on projections. */
static void check(const char *name, struct object *object)
{
    static const char *const names[PROJECTIONS] = { "cyber720-prior", "cdc6600" };
    SCOPED_VALUE(run) run = loaded(named_model(PRIOR), object);
    SCOPED(c205_model) *other = named_model("cyber205-4pipe-prior");
    SCOPED(c205) *other_machine = machine_with(&object->program, other);
    c205_model *models[PROJECTIONS];
    c205_projection *projection[PROJECTIONS];
    for (size_t i = 0; i < PROJECTIONS; i++) {
        models[i] = named_model(names[i]);
        projection[i] = c205_projection_new(models[i], &failure);
        assert_true(c205_listen(run.machine, c205_project, projection[i]));
    }
    assert_runs(run.machine);
    assert_runs(other_machine);
    assert_retimes(name, &run, run.model, NULL, 0, run.machine, NULL);
    assert_retimes(name, &run, other, NULL, 0, other_machine, NULL);
    for (size_t i = 0; i < PROJECTIONS; i++) {
        assert_retimes(name, &run, models[i], NULL, 0, NULL, projection[i]);
        c205_projection_free(projection[i]);
        c205_model_free(models[i]);
    }
}

static void check_program(const char *path)
{
    check(path, program_of(path));
}

TEST(programs)
{
    assert_true(each_file("tests/programs/*.s", check_program) > 40);
    assert_true(each_file("asm/examples/*.s", check_program) > 0);
    check_program("rt/study/fit/programs/linpack.s");
    check_program("rt/study/fit/programs/gather.s");
    check_program("rt/study/fit/programs/photons.s");
}

/* Each operand is on a separate page that has not been mapped. */
TEST(all_touches)
{
    check("touches", good("        .data\n"
                          "a:      .space 65536\n"
                          "b:      .space 65536\n"
                          "c:      .space 65536\n"
                          "d:      .space 65536\n"
                          "        .code\n"
                          "        EX   r10, a\n"
                          "        EX   r11, b\n"
                          "        EX   r12, c\n"
                          "        EX   r13, d\n"
                          "        ELEN r10, 8\n"
                          "        ELEN r11, 8\n"
                          "        ELEN r12, 8\n"
                          "        ELEN r13, 2\n"
                          "        ADDNV [r10], [r11], [r12]\n"
                          "        SWAP [r10], r20, [r13]\n"
                          "        EXIT\n"));
}

/* Code that is overwritten while it runs: additions become divisions. */
TEST(changed_code)
{
    check("changed", good("        EX   r10, here\n"
                          "        EX   r11, other\n"
                          "        ES   r13, 1\n"
                          "        ES   r14, 2\n"
                          "        ES   r12, 0\n"
                          "        BIM  here\n"
                          "        .align 64\n"
                          "here:   ADDN r1, r2, r3\n"
                          "        ADDN r3, r2, r3\n"
                          "        LOD  [r11], r20\n"
                          "        STO  [r10], r20\n"
                          "        IBXLT r12, r13, r14, here, r12\n"
                          "        EXIT\n"
                          "        .align 64\n"
                          "other:  DIVS r1, r2, r3\n"
                          "        DIVS r3, r2, r3\n"));
}

/* ---- Other models ------------------------------------------------------ */

TEST(settings)
{
    static const char path[] = "rt/study/fit/programs/photons.s";
    static const c205_setting pipes[] = { { "machine.pipes", 4 } };
    SCOPED_VALUE(run) recorded = run_of(named_model(PRIOR), path);
    SCOPED_VALUE(run) ran = run_of(named_model("cyber205-4pipe-prior"), path);
    assert_retimes(path, &recorded, recorded.model, pipes, 1, ran.machine, NULL);
}

/* A run with other page sizes, given as settings and as a changed model, is compared
 * with a machine of these sizes. The clocks of the recorded run must differ. */
static void compare_pages(const char *path, const c205_setting *settings, size_t count)
{
    SCOPED_VALUE(run) recorded = run_of(named_model(PRIOR), path);
    c205_model *changed = NON_NULL(
        c205_model_change(recorded.model, settings, count, &failure));
    SCOPED_VALUE(run) ran = run_of(changed, path);
    assert_true(c205_clock(ran.machine) > c205_clock(recorded.machine));
    assert_retimes(path, &recorded, recorded.model, settings, count, ran.machine, NULL);
    assert_retimes(path, &recorded, changed, NULL, 0, ran.machine, NULL);
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
    assert_true(c205_retime(run->recording, run->model, setting, setting != NULL, ticks,
                            clocks, REGIONS, &failure));
    return clocks[1];
}

/* Integer constants give the same clocks with 1 tick and with 1,000 ticks per clock,
 * except for rounding up to full clocks. Fractions give values in between. */
TEST(ticks)
{
    static const c205_setting settings[] = { { "latency.load", 15.5 },
                                             { "latency.load", 16 } };
    SCOPED_VALUE(run) run = run_of(named_model(PRIOR),
                                   "rt/study/fit/programs/linpack.s");
    double whole = retimed(&run, NULL, 1), fine = retimed(&run, NULL, 1000);
    double between = retimed(&run, &settings[0], 1000);
    double low = retimed(&run, &settings[1], 1000);
    assert_true(fabs(whole - fine) < .003 * whole);
    assert_true(fabs(2 * between - fine - low) < 1);
    assert_true(fine < between && between < low);
}

TEST(gather_in_ticks)
{
    SCOPED_VALUE(run) run = run_of(named_model(PRIOR),
                                   "rt/study/fit/programs/gather.s");
    assert_true(retimed(&run, NULL, 1) == retimed(&run, NULL, 100));
}

TEST(errors)
{
    static const c205_setting unknown = { "latency.none", 1 };
    static const c205_setting too_small = { "latency.load", -1 };
    c205_error error;
    double clocks[REGIONS];
    SCOPED(c205_model) *projection = named_model("cyber720");
    SCOPED_VALUE(run) run = loaded(named_model(PRIOR),
                                   program_of("asm/examples/dot.s"));
    SCOPED(c205_projection) *charged = NON_NULL(
        c205_projection_new(projection, &error));
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

static uint64_t projected(const char *text, const char *model_text)
{
    SCOPED(object) *object = good(text);
    SCOPED(c205_model) *model = named_model(PRIOR);
    SCOPED(c205_model) *projection_model = parsed_model(model_text);
    SCOPED(c205) *machine = machine_with(&object->program, model);
    SCOPED(c205_projection) *projection = NON_NULL(
        c205_projection_new(projection_model, &failure));
    assert_true(c205_listen(machine, c205_project, projection));
    assert_runs(machine);
    assert_true(c205_projection_holds(projection, &failure));
    assert_int_equal(c205_projected_clocks(projection, 5), 0);
    return c205_projected_clocks(projection, 0);
}

/* The operations of `chain` follow one another: four of the class single, two loads,
 * two stores, a product, two sums, a branch that is not taken, and the monitor. */
TEST_CALL(serial,
          assert_true(projected(chain, "title t\nlike cyber720\n"
                                       "time.single 2 clk R\ntime.load 100 clk R\n"
                                       "time.store 1000 clk R\ntime.multiply 30 clk R\n"
                                       "time.add 20 clk R\nbranch.not_taken 7 clk R\n"
                                       "time.monitor 1 clk R\n")
                      == 8 + 200 + 2000 + 30 + 40 + 27 + 1))

/* The clocks of `chain` on the 6600 with one increment unit and one adder. EX issues at
 * 0. ELEN waits for the unit and r10, 3 .. 6. EX r11 takes 6 .. 9, ELEN 9 .. 12; issue
 * ends at 10. SWAP begins at 12: four addresses of 3, then the last store 10, until 34.
 * MPYS takes 34 .. 44. ADDN waits in its unit for r22, 44 .. 52; the other ADDN waits
 * for the adder, 52 .. 60, and its issue ends at 53. The branch waits for r24: 60 + 8 +
 * 8 = 76. EXIT issues one clock later. */
TEST_CALL(scoreboard,
          assert_true(projected(chain,
                                "title t\nlike cdc6600\nunits.single 1 units R\n")
                      == 77))

static const char operations[] =
    "        .data\n"
    "a:      .word 4.0\n"
    "        .code\n"
    "        EX   r10, a\n"            /* single */
    "        LOD  [r10], r11\n"        /* load */
    "        SQRT r11, r12\n"          /* sqrt */
    "        DIVS r11, r12, r13\n"     /* divide */
    "        MPYX r10, r0, r14\n"      /* multiply */
    "        AND  r10, r11, r15\n"     /* logical */
    "        STO  [r10], r13\n"        /* store */
    "        IBXEQ r0, r0, r0, over\n" /* single, taken forward */
    "        ES   r16, 1\n"
    "over:   ES   r16, 0\n"                     /* single */
    "        ES   r17, 1\n"                     /* single */
    "again:  IBXEQ r16, r17, r17, again, r16\n" /* single twice: taken backward, not
                                                 * taken */
    "        EXIT\n";                           /* monitor */

static const char powers[] = "title t\nlike cyber720-prior\n"
                             "time.single 1 clk R\n"
                             "time.sqrt 10 clk R\nbranch.out_of_stack 20 clk R\n"
                             "time.divide 100 clk R\nbranch.taken 200 clk R\n"
                             "time.multiply 1000 clk R\nbranch.not_taken 2000 clk R\n"
                             "time.logical 10000 clk R\n"
                             "time.load 100000 clk R\ntime.store 200000 clk R\n"
                             "time.monitor 300000 clk R\n"
                             "branch.stack_halves 8 halves R\n";

/* Each operation has its own power of ten, so that the sum shows all charges. */
TEST_CALL(operations, assert_int_equal(projected(operations, powers),
                                       6 + 30 + 300 + 3000 + 10000 + 600000))

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
