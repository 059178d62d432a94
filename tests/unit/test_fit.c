/* test_fit.c - the observations, free constants and runs of the fit are compared with
 * values computed by hand and with runs of more rays. A wrong unit, a region that is
 * not counted or a report at another place fails here. */
#include "rt/study/fit/constants.h"
#include "rt/study/fit/observations.h"
#include "rt/study/fit/unidentifiable.h"
#include "tests/oracle/points.h"
#include "tests/unit/prior_model.h"

#include <math.h>

static void assert_near(double value, double expected, const char *what)
{
    FAIL_IF(!(fabs(value - expected) < 1e-6), "%s: %.9g is not %.9g", what, value,
            expected);
}

static const struct speedup_view view = { .distance = SPEEDUP_DISTANCE,
                                          .angle = SPEEDUP_ANGLE };

static struct run_options small(void)
{
    struct run_options how = { .folder = "rt/study/fit/programs",
                               .view = view,
                               .model = fitted_model };
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        how.width[mode] = 32;
        how.height[mode] = 20;
    }
    return how;
}

/* Writes a file with this text, which the caller removes. */
static const char *file_of(const char *text)
{
    static const char path[] = "test_fit.csv";
    FILE *file = NON_NULL(fopen(path, "w"));
    fputs(text, file);
    fclose(file);
    return path;
}

static struct fit_run *new_run(const char *program)
{
    struct run_options how = small();
    return NON_NULL(run_new(program, &how, &failure));
}

/* Reads observations from a text. The heading of their table precedes the text. */
#define HEAD "name,program,machine,value,unit,uncertainty,shared,source,use\n"

static void read_observations(struct observations *all, const char *rows)
{
    struct run_options how = small();
    SCOPED_VALUE(diagnostics) found = { 0 };
    FAIL_IF(!observations_read(all, file_of(formatted(HEAD "%s", rows)), &how, &found),
            "%s", found.items[0].message);
    remove("test_fit.csv");
}

static void read_constants(struct constants *constants, const char *rows)
{
    SCOPED_VALUE(diagnostics) found = { 0 };
    const char *text = formatted("name,machine,constants,source,least,most,why\n%s",
                                 rows);
    FAIL_IF(!constants_read(constants, file_of(text), &found), "%s",
            found.items[0].message);
    remove("test_fit.csv");
}

/* ---- Fewer rays --------------------------------------------------------- */

/* Returns the clocks of a region, or of all regions. */
static double clocks_of(const struct fit_run *run, const char *region,
                        const c205_setting *setting)
{
    bool chosen[MAX_RUN_REGIONS];
    double clocks[MAX_RUN_REGIONS], sum = 0;
    assert_true(run_select(run, region, chosen, &failure));
    REQUIRE(run_time(run, fitted_model, setting, setting != NULL, RUN_FINE, clocks,
                     &failure));
    for (size_t i = 0; i < run->region_count; i++)
        if (chosen[i])
            sum += clocks[i];
    return sum;
}

/* The scaled scalar clocks of 640 rays are within 1 percent of the clocks of 25,000
 * rays. The same frame of rt205 speedup has the same clocks. */
TEST(fewer_rays)
{
    for (size_t i = 0; i < speedup_subject_count; i++) {
        const struct speedup_subject *subject = &speedup_subjects[i];
        struct trace_options options = { .mode = TRACE_SCALAR,
                                         .width = 200,
                                         .height = 125,
                                         .queue = TRACE_QUEUE,
                                         .model = fitted_model };
        struct speedup_measure all;
        if (subject->paper.speedup == 0)
            continue;
        const char *program = formatted("%s scalar", subject->name);
        struct fit_run *run = new_run(program);
        REQUIRE(speedup_measure(subject, &view, &options, &all, &failure));
        assert_int_equal(run->rays, 640);
        double scaled = clocks_of(run, "", NULL) * 25000 / 640;
        FAIL_IF(fabs(scaled / (double)all.total - 1) > .01, "%s: %g clocks, scaled %g",
                program, (double)all.total, scaled);
        run_free(run);
    }
}

/* ---- Observations ------------------------------------------------------- */

/* A single addition takes 51 + n / 2 clocks of 20 ns on two pipes. */
TEST(units)
{
    static const struct {
        const char *row;
        double expected;
    } rows[] = {
        { "add LENGTH=0,cyber205-2pipe,1,ns/TIMES,1,,s,fit", 1020 },
        { "add LENGTH=0,cyber205-2pipe,1,clk,1,,s,compare", 5100 },
        { "add LENGTH=0,eta10g,1 to 2,clk,,,s,range", 5100 },
        { "add LENGTH=0,eta10g,1,ns/TIMES,1,,s,fit", 357 },
        { "add LENGTH=100,cyber205-2pipe,1,Mflop/s,1,,\"a, b\",fit",
          100 / (101 * .02) },
        { "add LENGTH=100,cyber205-2pipe/cyber205-1pipe,1,ratio,1,,s,fit", 101 / 151. },
        { "add/add LENGTH=3,cyber205-2pipe,1,ratio,1,,s,fit", 1 },
        { "add LENGTH=3,cyber205-2pipe,1,%,1,,s,fit", 100 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(observations) all = { 0 };
        const char *text = formatted("# a remark\n\na,vector_add.s:%s\n", rows[i].row);
        read_observations(&all, text);
        assert_int_equal(all.count, 1);
        FREED double(*clocks)[MAX_RUN_REGIONS] = calloc(all.timing_count,
                                                        sizeof *clocks);
        assert_non_null(clocks);
        for (size_t k = 0; k < all.timing_count; k++)
            assert_true(run_time(all.timings[k].run, all.timings[k].model, NULL, 0,
                                 RUN_FINE, clocks[k], &failure));
        assert_near(observation_predict(&all, &all.items[0], clocks), rows[i].expected,
                    rows[i].row);
    }
}

/* Compares the only report, in the form line:column: message. */
TEST(refused)
{
    static const char *const rows[][2] = {
        { "", "0:0: the file has no table" },
        { "a,b,c,d,e,f,g,h,i\n", "1:1: expected the column 'name'" },
        { HEAD "a,b\n", "2:1: this row has fewer fields than the heading" },
        { HEAD "a,b,c,d,e,f,g,h,i,j\n",
          "2:19: this row has more fields than the heading" },
        { HEAD "a,b,c,d,e,f,g,h,i\n", "2:17: expected fit, compare or range" },
        { HEAD "a,b,c,d,e,f,g,h,fit\n", "2:7: expected a positive number" },
        { HEAD "a,b,c,1 to,e,f,,g,range\n",
          "2:7: expected a positive number, or MIN to MAX" },
        { HEAD "a,b,c,2 to 1,e,f,,g,range\n",
          "2:7: expected a positive number, or MIN to MAX" },
        { HEAD "a,vector_add.s,cyber205-2pipe,1,s/100000,1,,s,fit\n",
          "2:33: vector_add.s has no rays" },
        { HEAD "a,vector_add.s:sub,cyber205-2pipe,1,ratio,1,,s,fit\n",
          "2:3: unknown region 'sub'" },
        { HEAD "a,vector_add.s,cyber205-9pipe,1,ratio,1,,s,fit\n",
          "2:3: unknown machine model 'cyber205-9pipe'" },
        { HEAD "a,vector_add.s,cyber205-2pipe,1,miles,1,,s,fit\n",
          "2:33: unknown unit 'miles'" },
        { HEAD "a,vector_add.s X,cyber205-2pipe,1,%,1,,s,fit\n",
          "2:3: 'X' does not define a constant" },
        { HEAD "a,stride.s,cyber205-2pipe,1,Mflop/s,1,,s,fit\n",
          "2:29: the program does not define FLOPS" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED_VALUE(observations) all = { 0 };
        SCOPED_VALUE(diagnostics) found = { 0 };
        struct run_options how = small();
        assert_false(observations_read(&all, file_of(rows[i][0]), &how, &found));
        assert_int_equal(found.count, 1);
        assert_string_equal(found.items[0].file, "test_fit.csv");
        const char *text = formatted("%zu:%zu: %s", found.items[0].line,
                                     found.items[0].column, found.items[0].message);
        assert_string_equal(text, rows[i][1]);
        remove("test_fit.csv");
    }
}

/* ---- Photons ------------------------------------------------------------ */

/* Returns the number of random numbers that the photons of photons.s use. It is
 * computed with doubles and the logarithm of the host. */
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

/* Returns the increase of a form's clocks if a SWAP takes one clock more. */
static double slower_swaps(const struct fit_run *run, const char *form)
{
    static const c205_setting swaps[] = { { "latency.swap", 15 },
                                          { "latency.swap", 16 } };
    return clocks_of(run, form, &swaps[1]) - clocks_of(run, form, &swaps[0]);
}

/* The scalar form swaps registers twice for each number from its own random function.
 * No other code swaps registers. Rounding and the short logarithm change the paths of
 * very few photons. */
TEST(photons)
{
    struct fit_run *run = new_run("photons.s OWN_RANF=1");
    double calls = slower_swaps(run, "scalar") / 2;
    FAIL_IF(fabs(calls / photon_draws() - 1) > .001, "%g calls for %g numbers", calls,
            photon_draws());
    assert_near(slower_swaps(run, "in_registers"), 0, "in_registers");
    assert_near(slower_swaps(run, "vector"), 0, "vector");
    run_free(run);
    run = new_run("photons.s");
    assert_near(slower_swaps(run, "scalar"), 0, "scalar");
    run_free(run);
}

/* ---- Groups and ranges -------------------------------------------------- */

TEST(groups)
{
    static const char *const rows[][2] = {
        { "sphere scalar", "sphere" },
        { "start-up", "start-up" },
        { "photons, in registers", "photons" },
        { "720 to 6600, sphere", "720 to 6600" },
        { "sphere 720", "sphere" },
        { "spheres, scalar", "spheres" },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        const struct observation item = { .name = rows[i][0] };
        const struct observation sphere = { .name = rows[0][0] };
        assert_int_equal(observation_group(&item), strlen(rows[i][1]));
        assert_memory_equal(item.name, rows[i][1], strlen(rows[i][1]));
        assert_int_equal(observation_same_group(&sphere, &item),
                         strcmp(rows[i][1], "sphere") == 0);
    }
}

TEST(ranges)
{
    static const double expected[][2] = { { 1.5, 3 }, { 4, 4 }, { 5, 5 } };
    SCOPED_VALUE(observations) all = { 0 };
    read_observations(&all, "a,vector_add.s,cyber205-2pipe,1.5 to 3,clk,,,s,range\n"
                            "b,vector_add.s,cyber205-2pipe,4,clk,,,s,range\n"
                            "c,vector_add.s,cyber205-2pipe,5,clk,.3,.4,s,fit\n");
    assert_int_equal(all.count, 3);
    for (size_t i = 0; i < all.count; i++) {
        assert_near(all.items[i].least, expected[i][0], "least");
        assert_near(all.items[i].most, expected[i][1], "most");
        assert_int_equal(all.items[i].use, i < 2 ? OBSERVATION_RANGE : OBSERVATION_FIT);
    }
    assert_near(all.items[2].uncertainty, .3, "uncertainty");
    assert_near(all.items[2].shared, .4, "shared");
    assert_near(observation_uncertainty(&all.items[2]), .5, "sum");
}

/* ---- Free constants ----------------------------------------------------- */

TEST(constants)
{
    static struct constants constants;
    c205_setting settings[MAX_SETTINGS];
    double places[MAX_FREE] = { .5 };
    const struct free_constant *first = &constants.items[0];
    SCOPED(c205_model) *like = NON_NULL(c205_model_find("eta10g", &failure));
    read_constants(&constants, "a,cyber205,latency.load swap.word,R,5,40,?\n"
                               "b,cyber720,time.add,S,5,40,?\n");
    assert_int_equal(constants.count, 2);
    assert_true(constant_is_of(first, fitted_model));
    assert_false(constant_is_of(&constants.items[1], fitted_model));
    assert_true(constant_is_of(first, like));
    assert_false(constant_is_of(&constants.items[1], like));
    assert_string_equal(c205_model_name(constants_prior(&constants, "cyber720")),
                        "cyber720-prior");
    assert_null(constants_prior(&constants, "eta10g"));
    assert_near(constant_value(first, .5), 15 * 1.2, "value");
    assert_near(constant_place(first, 15 * 1.2), .5, "place");
    assert_int_equal(constants_settings(&constants, places, fitted_model, settings), 2);
    assert_string_equal(settings[1].name, "swap.word");
    assert_near(settings[1].value, 1.2, "swap.word");
    constants_free(&constants);
}

/* Returns the free constant with which a constant changes. Returns "" if there is none,
 * and NULL if the constant is not in the list. */
static const char *moved_by(const struct unidentifiable_list *list, const char *name)
{
    for (size_t i = 0; i < list->count; i++)
        if (strcmp(list->items[i].constant->name, name) == 0) {
            assert_string_equal(list->items[i].machine, "cyber205");
            return list->items[i].moved_by ? list->items[i].moved_by->name : "";
        }
    return NULL;
}

/* A fit to additions alone; a gather is only compared. */
TEST(unidentifiable)
{
    static const char *const rows[][2] = {
        { "startup.vadd", NULL },
        { "stream.vadd", NULL },
        { "machine.pipes", NULL },
        { "clock.period", NULL },
        { "startup.vdivide", "start-ups" },
        { "stream.vgather", "" },
        { "latency.store", "" },
    };
    static struct constants constants;
    static struct unidentifiable_list unidentifiable;
    static const struct fit_change none;
    SCOPED_VALUE(observations) all = { 0 };
    struct fit fit = { .observations = &all, .constants = &constants };
    read_observations(&all,
                      "a,vector_add.s:add LENGTH=100,cyber205-2pipe,1,clk,1,,s,fit\n"
                      "b,stride.s:gather,cyber205-2pipe,1,clk,1,,s,compare\n");
    read_constants(&constants,
                   "start-ups,cyber205,startup.vadd startup.vdivide,R,5,90,?\n");
    assert_true(unidentifiable_find(&fit, &none, &unidentifiable, &failure));
    for (size_t i = 0; i < COUNT(rows); i++) {
        const char *found = moved_by(&unidentifiable, rows[i][0]);
        FAIL_IF(!found != !rows[i][1] || (found && strcmp(found, rows[i][1]) != 0),
                "%s is moved by %s", rows[i][0], found ? found : "the fit");
    }
    constants_free(&constants);
}

GROUP(set_up_fitted, tear_down_fitted);
