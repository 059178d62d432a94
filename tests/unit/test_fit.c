/* test_fit.c - the observations, free constants and runs of the fit are compared with
 * values computed by hand and with runs of more rays. A wrong unit, a region that is
 * not counted or a report at another place fails here. */
#include "rt/study/fit/constants.h"
#include "rt/study/fit/observations.h"
#include "rt/study/fit/unidentifiable.h"
#include "tests/oracle/points.h"
#include "tests/unit/unit.h"

#include <math.h>

static c205_model *model;

static void assert_near(double value, double expected)
{
    if (!(fabs(value - expected) < 1e-6))
        fail_msg("%.9g is not %.9g", value, expected);
}

static const struct speedup_view view = { .distance = SPEEDUP_DISTANCE,
                                          .angle = SPEEDUP_ANGLE };

static struct run_options small(void)
{
    struct run_options how = { .folder = "rt/study/fit/programs",
                               .view = view,
                               .model = model };
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        how.width[mode] = 32;
        how.height[mode] = 20;
    }
    return how;
}

/* Writes a file of that text, which the caller removes. */
static const char *file_of(const char *text)
{
    static const char path[] = "test_fit.csv";
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
    return path;
}

/* ---- Fewer rays --------------------------------------------------------- */

static double clocks_of_rows(const struct fit_run *run)
{
    bool chosen[MAX_RUN_REGIONS];
    double clocks[MAX_RUN_REGIONS], sum = 0;
    c205_error error = { "" };
    assert_true(run_select(run, "", chosen, &error));
    REQUIRE(run_time(run, model, NULL, 0, RUN_FINE, clocks, &error));
    for (size_t i = 0; i < run->region_count; i++)
        if (chosen[i])
            sum += clocks[i];
    return sum;
}

/* The scaled scalar clocks of 640 rays are within 1 percent of those of 25,000 rays.
 * The same frame of rt205 speedup has the same clocks. */
TEST(fewer_rays)
{
    for (size_t i = 0; i < speedup_subject_count; i++) {
        const struct speedup_subject *subject = &speedup_subjects[i];
        struct trace_options options = { .mode = TRACE_SCALAR,
                                         .width = 200,
                                         .height = 125,
                                         .queue = TRACE_QUEUE,
                                         .model = model };
        struct run_options how = small();
        struct speedup_measure all;
        c205_error error = { "" };
        char program[64];
        if (subject->paper.speedup == 0)
            continue;
        snprintf(program, sizeof program, "%s scalar", subject->name);
        struct fit_run *run = run_new(program, &how, &error);
        REQUIRE(run && speedup_measure(subject, &view, &options, &all, &error));
        assert_int_equal(run->rays, 640);
        double scaled = clocks_of_rows(run) * 25000 / 640;
        if (fabs(scaled / (double)all.total - 1) > .01)
            fail_msg("%s: %g clocks, scaled %g", program, (double)all.total, scaled);
        run_free(run);
    }
}

/* ---- Observations ------------------------------------------------------- */

#define HEAD "name,program,machine,value,unit,uncertainty,shared,source,use\n"

/* Returns the prediction for the only observation of a file. */
static double predicted(const char *row)
{
    SCOPED_VALUE(observations) all = { 0 };
    struct run_options how = small();
    struct diagnostics found = { 0 };
    c205_error error = { "" };
    char text[512];
    double(*clocks)[MAX_RUN_REGIONS], value;
    snprintf(text, sizeof text, HEAD "# a remark\n\n%s\n", row);
    if (!observations_read(&all, file_of(text), &how, &found))
        fail_msg("%s", found.items[0].message);
    assert_int_equal(all.count, 1);
    clocks = calloc(all.timing_count, sizeof *clocks);
    assert_non_null(clocks);
    for (size_t i = 0; i < all.timing_count; i++)
        assert_true(run_time(all.timings[i].run, all.timings[i].model, NULL, 0,
                             RUN_FINE, clocks[i], &error));
    value = observation_predict(&all, &all.items[0], clocks);
    free(clocks);
    remove("test_fit.csv");
    return value;
}

/* A single addition takes 51 + n / 2 clocks of 20 ns on two pipes. */
TEST(units)
{
    assert_near(predicted("a,vector_add.s:add LENGTH=0,"
                          "cyber205-2pipe,1,ns/TIMES,1,,s,fit"),
                1020);
    assert_near(predicted("a,vector_add.s:add LENGTH=0,"
                          "cyber205-2pipe,1,clk,1,,s,compare"),
                5100);
    assert_near(predicted("a,vector_add.s:add LENGTH=0,eta10g,1 to 2,clk,,,s,range"),
                5100);
    assert_near(predicted("a,vector_add.s:add LENGTH=0,eta10g,1,ns/TIMES,1,,s,fit"),
                357);
    assert_near(predicted("a,vector_add.s:add LENGTH=100,"
                          "cyber205-2pipe,1,Mflop/s,1,,\"a, b\",fit"),
                100 / (101 * .02));
    assert_near(predicted("a,vector_add.s:add LENGTH=100,"
                          "cyber205-2pipe/cyber205-1pipe,1,ratio,1,,s,fit"),
                101 / 151.);
    assert_near(predicted("a,vector_add.s:add/add LENGTH=3,"
                          "cyber205-2pipe,1,ratio,1,,s,fit"),
                1);
    assert_near(predicted("a,vector_add.s:add LENGTH=3,cyber205-2pipe,1,%,1,,s,fit"),
                100);
}

/* Compares the only report, as file:line:column: message. */
static void check_found(struct diagnostics *found, const char *message)
{
    char text[200];
    assert_int_equal(found->count, 1);
    snprintf(text, sizeof text, "%s:%zu:%zu: %s", found->items[0].file,
             found->items[0].line, found->items[0].column, found->items[0].message);
    assert_string_equal(text, message);
    diagnostics_free(found);
}

static void assert_refused(const char *text, const char *message)
{
    SCOPED_VALUE(observations) all = { 0 };
    struct run_options how = small();
    struct diagnostics found = { 0 };
    assert_false(observations_read(&all, file_of(text), &how, &found));
    check_found(&found, message);
    remove("test_fit.csv");
}

TEST(refused)
{
    assert_refused("", "test_fit.csv:0:0: the file has no table");
    assert_refused("a,b,c,d,e,f,g,h,i\n", "test_fit.csv:1:1: expected another column");
    assert_refused(HEAD "a,b\n", "test_fit.csv:2:1: fields are missing");
    assert_refused(HEAD "a,b,c,d,e,f,g,h,i,j\n", "test_fit.csv:2:19: too many fields");
    assert_refused(HEAD "a,b,c,d,e,f,g,h,i\n",
                   "test_fit.csv:2:17: expected fit, compare or range");
    assert_refused(HEAD "a,b,c,d,e,f,g,h,fit\n",
                   "test_fit.csv:2:7: expected a positive number");
    assert_refused(HEAD "a,b,c,1 to,e,f,,g,range\n",
                   "test_fit.csv:2:7: expected a positive number, or LEAST to MAX");
    assert_refused(HEAD "a,b,c,2 to 1,e,f,,g,range\n",
                   "test_fit.csv:2:7: expected a positive number, or LEAST to MAX");
    assert_refused(HEAD "a,vector_add.s,cyber205-2pipe,1,s/100000,1,,s,fit\n",
                   "test_fit.csv:2:33: vector_add.s has no rays");
    assert_refused(HEAD "a,vector_add.s:sub,cyber205-2pipe,1,ratio,1,,s,fit\n",
                   "test_fit.csv:2:3: unknown region 'sub'");
    assert_refused(HEAD "a,vector_add.s,cyber205-9pipe,1,ratio,1,,s,fit\n",
                   "test_fit.csv:2:3: unknown machine model 'cyber205-9pipe'");
    assert_refused(HEAD "a,vector_add.s,cyber205-2pipe,1,miles,1,,s,fit\n",
                   "test_fit.csv:2:33: unknown unit 'miles'");
    assert_refused(HEAD "a,vector_add.s X,cyber205-2pipe,1,%,1,,s,fit\n",
                   "test_fit.csv:2:3: 'X' does not define a constant");
    assert_refused(HEAD "a,stride.s,cyber205-2pipe,1,Mflop/s,1,,s,fit\n",
                   "test_fit.csv:2:29: the program does not define FLOPS");
}

/* ---- Photons ------------------------------------------------------------ */

/* Returns the count of random numbers that the photons of photons.s draw, computed with
 * doubles and the logarithm of the host. */
static double photon_draws(void)
{
    double draws = 0;
    for (uint64_t photon = 1; photon <= 4000; photon++) {
        uint64_t position = 1025 * photon;
        double x = 0, mu = 1, u[3];
        do {
            for (uint64_t i = 0; i < 3; i++)
                u[i] = (double)stream_mixed(stream_state_at(position + i + 1))
                       * 0x1p-47;
            x -= mu * log(u[0]);
            mu = 2 * u[2] - 1;
            position += 3;
            draws += x < 0 || x >= 3 ? 1 : u[1] >= .9 ? 2 : 3;
        } while (x >= 0 && x < 3 && u[1] < .9);
    }
    return draws;
}

static double region_clocks(const struct fit_run *run, const char *region,
                            const c205_setting *setting)
{
    bool chosen[MAX_RUN_REGIONS];
    double clocks[MAX_RUN_REGIONS];
    c205_error error = { "" };
    assert_true(run_select(run, region, chosen, &error));
    REQUIRE(run_time(run, model, setting, 1, RUN_FINE, clocks, &error));
    for (size_t i = 0; i < run->region_count; i++)
        if (chosen[i])
            return clocks[i];
    return 0;
}

/* Returns the increase of a form's clocks if SWAP takes one clock more. */
static double slower_swaps(const struct fit_run *run, const char *form)
{
    static const c205_setting swaps[] = { { "latency.swap", 15 },
                                          { "latency.swap", 16 } };
    return region_clocks(run, form, &swaps[1]) - region_clocks(run, form, &swaps[0]);
}

static struct fit_run *photons(const char *program)
{
    struct run_options how = small();
    c205_error error = { "" };
    struct fit_run *run = run_new(program, &how, &error);
    REQUIRE(run);
    return run;
}

/* With its own random function, the scalar form swaps registers twice for each number;
 * no other code swaps. Rounding and the short logarithm change the path of hardly any
 * photon. */
TEST(photons)
{
    struct fit_run *run = photons("photons.s OWN_RANF=1");
    double calls = slower_swaps(run, "scalar") / 2;
    if (fabs(calls / photon_draws() - 1) > .001)
        fail_msg("%g calls for %g numbers", calls, photon_draws());
    assert_near(slower_swaps(run, "in_registers"), 0);
    assert_near(slower_swaps(run, "vector"), 0);
    run_free(run);
    run = photons("photons.s");
    assert_near(slower_swaps(run, "scalar"), 0);
    run_free(run);
}

/* ---- Groups and ranges -------------------------------------------------- */

static void assert_group(const char *name, const char *group)
{
    const struct observation item = { .name = name };
    assert_int_equal(observation_group(&item), strlen(group));
    assert_memory_equal(name, group, strlen(group));
}

TEST(groups)
{
    assert_group("sphere scalar", "sphere");
    assert_group("start-up", "start-up");
    assert_group("photons, in registers", "photons");
    assert_group("720 to 6600, sphere", "720 to 6600");
    assert_true(
        observation_same_group(&(const struct observation){ .name = "sphere scalar" },
                               &(const struct observation){ .name = "sphere 720" }));
    assert_false(
        observation_same_group(&(const struct observation){ .name = "sphere scalar" },
                               &(const struct observation){
                                   .name = "spheres, scalar" }));
}

TEST(ranges)
{
    SCOPED_VALUE(observations) all = { 0 };
    struct run_options how = small();
    struct diagnostics found = { 0 };
    assert_true(
        observations_read(&all,
                          file_of(HEAD
                                  "a,vector_add.s,cyber205-2pipe,1.5 to 3,clk,,,s,"
                                  "range\n"
                                  "b,vector_add.s,cyber205-2pipe,4,clk,,,s,range\n"
                                  "c,vector_add.s,cyber205-2pipe,5,clk,.3,.4,s,fit\n"),
                          &how, &found));
    for (size_t i = 0; i < all.count; i++) {
        static const double expected[][2] = { { 1.5, 3 }, { 4, 4 }, { 5, 5 } };
        assert_near(all.items[i].least, expected[i][0]);
        assert_near(all.items[i].most, expected[i][1]);
        assert_int_equal(all.items[i].use, i < 2 ? OBSERVATION_RANGE : OBSERVATION_FIT);
    }
    assert_near(all.items[2].uncertainty, .3);
    assert_near(all.items[2].shared, .4);
    assert_near(observation_uncertainty(&all.items[2]), .5);
    remove("test_fit.csv");
}

/* ---- Free constants ----------------------------------------------------- */

TEST(constants)
{
    static struct constants constants;
    c205_setting settings[MAX_SETTINGS];
    double places[MAX_FREE] = { .5 };
    struct diagnostics found = { 0 };
    const struct free_constant *first = &constants.items[0];
    c205_error error;
    SCOPED(c205_model) *like = c205_model_find("eta10g", &error);
    assert_non_null(like);
    if (!constants_read(&constants,
                        file_of("name,machine,constants,source,least,most,why\n"
                                "a,cyber205,latency.load swap.word,R,5,40,?\n"
                                "b,cyber720,time.add,S,5,40,?\n"),
                        &found))
        fail_msg("%s", found.items[0].message);
    assert_int_equal(constants.count, 2);
    assert_true(constant_is_of(first, model));
    assert_false(constant_is_of(&constants.items[1], model));
    assert_true(constant_is_of(first, like));
    assert_false(constant_is_of(&constants.items[1], like));
    assert_string_equal(c205_model_name(constants_prior(&constants, "cyber720")),
                        "cyber720-prior");
    assert_null(constants_prior(&constants, "eta10g"));
    assert_near(constant_value(first, .5), 15 * 1.2);
    assert_near(constant_place(first, 15 * 1.2), .5);
    assert_int_equal(constants_settings(&constants, places, model, settings), 2);
    assert_string_equal(settings[1].name, "swap.word");
    assert_near(settings[1].value, 1.2);
    constants_free(&constants);
    remove("test_fit.csv");
}

static bool is_among(const struct unidentifiable_list *unidentifiable, const char *name,
                     const char **moved_by)
{
    for (size_t i = 0; i < unidentifiable->count; i++)
        if (strcmp(unidentifiable->items[i].constant->name, name) == 0) {
            assert_string_equal(unidentifiable->items[i].machine, "cyber205");
            *moved_by = unidentifiable->items[i].moved_by
                            ? unidentifiable->items[i].moved_by->name
                            : "";
            return true;
        }
    return false;
}

/* A fit to additions alone; a gather is only compared. */
TEST(unidentifiable)
{
    static struct constants constants;
    static struct unidentifiable_list unidentifiable;
    static const struct fit_change none;
    SCOPED_VALUE(observations) all = { 0 };
    struct run_options how = small();
    struct diagnostics found = { 0 };
    struct fit fit = { .observations = &all, .constants = &constants };
    c205_error error = { "" };
    const char *moved_by;
    assert_true(
        observations_read(&all,
                          file_of(HEAD "a,vector_add.s:add LENGTH=100,cyber205-2pipe,1,"
                                       "clk,1,,s,fit\n"
                                       "b,stride.s:gather,cyber205-2pipe,1,clk,1,,s,"
                                       "compare\n"),
                          &how, &found));
    assert_true(
        constants_read(&constants,
                       file_of("name,machine,constants,source,least,most,why\n"
                               "start-ups,cyber205,startup.vadd startup.vdivide,"
                               "R,5,90,?\n"),
                       &found));
    assert_true(unidentifiable_find(&fit, &none, &unidentifiable, &error));
    assert_false(is_among(&unidentifiable, "startup.vadd", &moved_by));
    assert_false(is_among(&unidentifiable, "stream.vadd", &moved_by));
    assert_false(is_among(&unidentifiable, "machine.pipes", &moved_by));
    assert_false(is_among(&unidentifiable, "clock.period", &moved_by));
    assert_true(is_among(&unidentifiable, "startup.vdivide", &moved_by));
    assert_string_equal(moved_by, "start-ups");
    assert_true(is_among(&unidentifiable, "stream.vgather", &moved_by));
    assert_string_equal(moved_by, "");
    assert_true(is_among(&unidentifiable, "latency.store", &moved_by));
    constants_free(&constants);
    remove("test_fit.csv");
}

FIXTURE(find_model)
{
    c205_error error;
    model = c205_model_find("cyber205-2pipe", &error);
    return !model;
}

FIXTURE(free_model)
{
    c205_model_free(model);
    return 0;
}

GROUP(find_model, free_model);
