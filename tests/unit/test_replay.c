/* test_replay.c - every test program and example is recorded and replayed: the clocks
 * on the model of the run, on another one and on projections are compared with runs on
 * these models, and the time of each operation with its constant. A replay with other
 * clocks fails here. */
#include "named_model.h"
#include "saved_machine.h"

#include <math.h>

#include "base/accounts.h"

enum { REGIONS = 16, PROJECTIONS = 2 };

static const char *const projections[PROJECTIONS] = { "cyber720-prior", "cdc6600" };

SCOPED_BY_FREE(c205_recording);

/* Compares the clocks of the recording with those of a machine or a projection.
 * Projections have no clocks for vector instructions; regions with them are skipped. */
static void assert_same_clocks(const char *name, const c205_recording *recording,
                               const c205_model *model, const c205 *machine,
                               const c205_projection *projection)
{
    double clocks[REGIONS];
    size_t count = machine ? c205_account_count(machine) : REGIONS;
    c205_error error;
    assert_true(count <= REGIONS);
    assert_true(c205_retime(recording, model, NULL, 0, 1, clocks, REGIONS, &error));
    for (size_t i = 0; i < count; i++) {
        uint64_t expected = machine ? accounts_clocks(c205_account_at(machine, i))
                                    : c205_projected_clocks(projection, i);
        if (!(projection && isnan(clocks[i])) && clocks[i] != (double)expected)
            fail_msg("%s on %s: %llu clocks in region %zu, played again %g", name,
                     c205_model_name(model), (unsigned long long)expected, i,
                     clocks[i]);
    }
}

/* ---- One program ------------------------------------------------------- */

static void assert_runs(const char *name, c205 *machine)
{
    if (c205_run(machine, C205_NO_LIMIT).trap != C205_TRAP_NONE)
        fail_msg("%s does not run", name);
}

static void check(const char *name, struct object *program)
{
    SCOPED(object) *object = program;
    SCOPED(c205_model) *model = named_model("cyber205-2pipe-prior");
    SCOPED(c205_model) *other = named_model("cyber205-4pipe-prior");
    SCOPED(c205) *machine = machine_with(&object->program, model);
    SCOPED(c205) *other_machine = machine_with(&object->program, other);
    c205_model *models[PROJECTIONS];
    c205_projection *projection[PROJECTIONS];
    c205_error error;
    SCOPED(c205_recording) *recording = c205_recording_new(&error);
    assert_true(c205_listen(machine, c205_record, recording));
    for (size_t i = 0; i < PROJECTIONS; i++) {
        models[i] = named_model(projections[i]);
        projection[i] = c205_projection_new(models[i], &error);
        assert_true(c205_listen(machine, c205_project, projection[i]));
    }
    assert_runs(name, machine);
    assert_runs(name, other_machine);
    assert_same_clocks(name, recording, model, machine, NULL);
    assert_same_clocks(name, recording, other, other_machine, NULL);
    for (size_t i = 0; i < PROJECTIONS; i++) {
        assert_same_clocks(name, recording, models[i], NULL, projection[i]);
        c205_projection_free(projection[i]);
        c205_model_free(models[i]);
    }
}

/* ---- Programs ---------------------------------------------------------- */

static void check_program(const char *path)
{
    check(path, good_file(path));
}

TEST(programs)
{
    assert_true(each_file("tests/programs/*.s", check_program) > 40);
    assert_true(each_file("asm/examples/*.s", check_program) > 0);
}

/* Each operand is in a separate page that is not mapped yet. */
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

/* ---- Operations of a projection ------------------------------------------ */

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

/* Each operation has its own power of ten, so that the sum shows which operations were
 * charged. */
TEST(operations)
{
    SCOPED(object) *object = good(operations);
    SCOPED(c205_model) *model = named_model("cyber205-2pipe-prior");
    SCOPED(c205_model) *times = parsed_model(powers);
    SCOPED(c205) *machine = machine_with(&object->program, model);
    c205_error error;
    SCOPED(c205_projection) *projection = c205_projection_new(times, &error);
    assert_true(c205_listen(machine, c205_project, projection));
    assert_runs("operations", machine);
    assert_int_equal(c205_projected_clocks(projection, 0),
                     6 + 30 + 300 + 3000 + 10000 + 600000);
}
