/* test_replay.c - every test program and example is recorded and replayed: the clocks
 * on the model of the run, on another one and on projections are compared with runs on
 * these models, and the time of each operation with its constant. A replay with other
 * clocks fails here. */
#include "asm_helper.h"

#include <math.h>
#include <string.h>

#include "base/accounts.h"

enum { REGIONS = 16, PROJECTIONS = 2 };

static const char *const projections[PROJECTIONS] = { "cyber720-prior", "cdc6600" };

static c205_model *find(const char *name)
{
    c205_error error;
    c205_model *model = c205_model_find(name, &error);
    if (!model)
        fail_msg("%s", error.message);
    return model;
}

/* Returns a machine with the program loaded; the caller frees it. */
static c205 *loaded(const struct object *object, const c205_model *model)
{
    c205_error error;
    c205 *machine = c205_new(model, &error);
    assert_non_null(machine);
    assert_true(c205_load(machine, &object->program, &error));
    assert_true(c205_account_count(machine) <= REGIONS);
    return machine;
}

static void assert_same_clocks(const char *name, const c205 *machine,
                               const c205_recording *recording, const c205_model *model)
{
    double clocks[REGIONS];
    c205_error error;
    assert_true(c205_retime(recording, model, NULL, 0, 1, clocks, REGIONS, &error));
    for (size_t i = 0; i < c205_account_count(machine); i++) {
        double expected = (double)accounts_clocks(c205_account_at(machine, i));
        if (clocks[i] != expected)
            fail_msg("%s on %s: %g clocks in region %zu, played again %g", name,
                     c205_model_name(model), expected, i, clocks[i]);
    }
}

/* Vector instructions have no clocks on such a machine; regions with them are
 * skipped. */
static void assert_same_projected(const char *name, const c205_projection *projection,
                                  const c205_recording *recording,
                                  const c205_model *model)
{
    double clocks[REGIONS];
    c205_error error;
    assert_true(c205_retime(recording, model, NULL, 0, 1, clocks, REGIONS, &error));
    for (size_t i = 0; i < REGIONS; i++) {
        double expected = (double)c205_projected_clocks(projection, i);
        if (!isnan(clocks[i]) && clocks[i] != expected)
            fail_msg("%s on %s: %g clocks in region %zu, played again %g", name,
                     c205_model_name(model), expected, i, clocks[i]);
    }
}

/* ---- One program ------------------------------------------------------- */

static void check_on_other(const char *name, const struct object *object,
                           const c205_recording *recording)
{
    c205_model *other = find("cyber205-4pipe-prior");
    c205 *machine = loaded(object, other);
    assert_int_equal(c205_run(machine, C205_NO_LIMIT).trap, C205_TRAP_NONE);
    assert_same_clocks(name, machine, recording, other);
    c205_free(machine);
    c205_model_free(other);
}

static void check(const char *name, const struct object *object)
{
    c205_model *model = find("cyber205-2pipe-prior");
    c205_model *models[PROJECTIONS];
    c205_projection *projection[PROJECTIONS];
    c205_error error;
    c205_recording *recording = c205_recording_new(&error);
    c205 *machine = loaded(object, model);
    assert_true(c205_listen(machine, c205_record, recording));
    for (size_t i = 0; i < PROJECTIONS; i++) {
        models[i] = find(projections[i]);
        projection[i] = c205_projection_new(models[i], &error);
        assert_true(c205_listen(machine, c205_project, projection[i]));
    }
    if (c205_run(machine, C205_NO_LIMIT).trap != C205_TRAP_NONE)
        fail_msg("%s does not run", name);
    assert_same_clocks(name, machine, recording, model);
    check_on_other(name, object, recording);
    for (size_t i = 0; i < PROJECTIONS; i++) {
        assert_same_projected(name, projection[i], recording, models[i]);
        c205_projection_free(projection[i]);
        c205_model_free(models[i]);
    }
    c205_recording_free(recording);
    c205_free(machine);
    c205_model_free(model);
}

static void check_text(const char *name, const char *text)
{
    struct object *object = good(text);
    check(name, object);
    object_free(object);
}

/* ---- Programs ---------------------------------------------------------- */

static void check_program(const char *path)
{
    struct object *object = good_file(path);
    check(path, object);
    object_free(object);
}

TEST(programs)
{
    assert_true(each_file("tests/programs/*.s", check_program) > 40);
    assert_true(each_file("asm/examples/*.s", check_program) > 0);
}

/* Each operand is in a separate page that is not mapped yet. */
TEST(all_touches)
{
    check_text("touches", "        .data\n"
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
                          "        EXIT\n");
}

/* Code that is overwritten while it runs: additions become divisions. */
TEST(changed_code)
{
    check_text("changed", "        EX   r10, here\n"
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
                          "        DIVS r3, r2, r3\n");
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
    struct object *object = good(operations);
    c205_error error;
    c205_model *model = find("cyber205-2pipe-prior");
    c205_model *times = c205_model_parse("powers", powers, &error);
    assert_non_null(times);
    c205 *machine = loaded(object, model);
    c205_projection *projection = c205_projection_new(times, &error);
    assert_true(c205_listen(machine, c205_project, projection));
    assert_int_equal(c205_run(machine, C205_NO_LIMIT).trap, C205_TRAP_NONE);
    assert_int_equal(c205_projected_clocks(projection, 0),
                     6 + 30 + 300 + 3000 + 10000 + 600000);
    c205_projection_free(projection);
    c205_free(machine);
    c205_model_free(times);
    c205_model_free(model);
    object_free(object);
}
