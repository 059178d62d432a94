/* test_thermal.c - surfaces by primitive, part and material, and their heat exchange,
 * are compared with closed forms. A surface of the wrong group, a factor of another
 * surface or a wrong value that is accepted fails here. */
#include "rt/heat/heat_source.h"
#include "rt/heat/thermal.h"
#include "tests/unit/heat_study.h"

#define SIGMA 5.670374419e-8

/* A ball in a shell, which has two surfaces. */
static const char ball[] =
    "#declare Copper = texture { pigment { rgb 1 } }\n"
    "#declare Ball = sphere { 0, 1 texture { Copper } }\n"
    "#declare Shell = difference { sphere { 0, 2.5 } sphere { 0, 2 } }\n"
    "#declare Ball_Temperature = 500;\n#declare Copper_Emissivity = .8;\n"
    "object { Ball } object { Shell }\n";

static struct study begin(const char *text, enum surfaces_by by)
{
    struct study study = study_of(text, by);
    FREED const char **refusals = NON_NULL(source_refusals(study.scene));
    study_find(&study, refusals, TRACE_VECTOR, 1024);
    return study;
}

/* Reads texts NAME=VALUE, separated by blanks. The scene's values come last. */
static void give(const struct study *study, const struct value_kind *kind,
                 const char *texts, struct named_values *given)
{
    char copy[200];
    named_begin(given, kind);
    snprintf(copy, sizeof copy, "%s", texts);
    for (char *text = strtok(copy, " "); text; text = strtok(NULL, " "))
        REQUIRE(named_add(given, text, &failure));
    assert_true(named_add_scene(given, study->scene, &failure));
}

static bool exchange(const struct study *study, const char *temperatures,
                     const char *emissivities, struct thermal *thermal,
                     c205_error *error)
{
    struct named_values temperature, emissivity;
    give(study, &temperature_kind, temperatures, &temperature);
    give(study, &emissivity_kind, emissivities, &emissivity);
    bool good = thermal_find(&study->surfaces, &study->parts, &emissivity, &temperature,
                             TRACE_VECTOR, prior_model, thermal, error);
    named_free(&temperature);
    named_free(&emissivity);
    return good;
}

/* ---- Surfaces ----------------------------------------------------------------- */

static void assert_estimate(struct estimate found, double expected)
{
    FAIL_IF(!(fabs(found.value - expected) <= 5 * found.error + 1e-9),
            "%.9g +- %.2g is not %.9g", found.value, found.error, expected);
}

TEST(parts)
{
    double pi = acos(-1);
    SCOPED_VALUE(study) study = begin(ball, BY_PART);
    const struct surface *shell = &study.surfaces.list[1];
    assert_int_equal(study.surfaces.count, 2);
    assert_string_equal(study.surfaces.list[0].name, "Ball");
    assert_string_equal(shell->name, "Shell");
    assert_estimate(shell->area, 4 * pi * (4 + 6.25));
    assert_int_equal(shell->tried, 2 * 16 * 1024);
    /* A quarter of the rays from the inside of the shell reaches the ball. */
    assert_estimate(shell->factor[0], .25 * 4 / 10.25);
    assert_estimate(shell->factor[1], .75 * 4 / 10.25);
    assert_estimate(shell->factor[2], 6.25 / 10.25);
    assert_int_equal(shell->count[0] + shell->count[1] + shell->count[2], shell->sent);
    assert_true(fabs(surfaces_reciprocity(&study.surfaces, 0, 1)) < 5);
    assert_true(isnan(surfaces_reciprocity(&study.surfaces, 1, 1)));
    assert_true(isnan(surfaces_reciprocity(&study.surfaces, 1, 2)));
}

TEST(groups)
{
    SCOPED_VALUE(study) study = begin(ball, BY_MATERIAL);
    assert_int_equal(study.surfaces.count, 2);
    assert_string_equal(study.surfaces.list[0].name, "Copper");
    assert_string_equal(study.surfaces.list[1].name, "none");
    SCOPED_VALUE(study) apart = begin(ball, BY_PRIMITIVE);
    assert_int_equal(apart.surfaces.count, 3);
    assert_string_equal(apart.surfaces.list[2].name, "3");
}

/* ---- Flows -------------------------------------------------------------------- */

/* exchange.csv contains the flow to a shell with 300 K and the emissivity .5. */
TEST(flows)
{
    double pi = acos(-1), fourth = 3e2 * 3e2 * 3e2 * 3e2;
    SCOPED_VALUE(study) study = begin(ball, BY_PRIMITIVE);
    SCOPED_VALUE(thermal) thermal;
    assert_true(exchange(&study, "Shell=300", "Shell=.5", &thermal, &failure));
    assert_int_equal(thermal.count, 3);
    const double *flow = thermal.exchange.flow;
    double from_outside = .5 * SIGMA * fourth * 4 * pi * 6.25;
    assert_close(flow[0], 25842.18560027, .01 * 25842.18560027);
    assert_close(flow[2], -25842.18560027, .01 * 25842.18560027);
    assert_close(flow[1], from_outside, .01 * from_outside);
}

/* Lines count each flow once for both surfaces, so the flows sum to 0. */
TEST(lines)
{
    struct sampling_options options = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 2000,
                                               .lines_log = 10, .repeats = 16,
                                               .lattice = true, .seed = 1);
    double pi = acos(-1);
    SCOPED_VALUE(study) study = { .scene = read_scene(ball) };
    struct sampling_options by_part = options;
    SCOPED_VALUE(global_lines) found;
    SCOPED_VALUE(thermal) thermal;
    assert_true(named_parts_find(study.scene, &study.parts));
    assert_true(surfaces_find(study.scene, &study.parts, BY_PART, &study.surfaces));
    by_part.surface_of = study.surfaces.surface_of;
    by_part.surfaces = study.surfaces.count;
    assert_true(global_lines_find(study.scene, &by_part, &found, &failure));
    surfaces_take_lines(&study.surfaces, &found);
    assert_estimate(study.surfaces.list[1].area, 4 * pi * (4 + 6.25));
    assert_estimate(study.surfaces.list[1].factor[0], .25 * 4 / 10.25);
    assert_true(surfaces_reciprocity(&study.surfaces, 0, 1) == 0);
    assert_true(exchange(&study, "Shell=300", "Shell=.5", &thermal, &failure));
    assert_true(fabs(thermal.exchange.sum) < 1e-9 * fabs(thermal.exchange.flow[0]));
    study.rows = calloc(study.scene->primitive_count, sizeof *study.rows);
}

/* All heat that the ball emits leaves an adiabatic shell. */
TEST(adiabatic)
{
    double pi = acos(-1), fourth = 5e2 * 5e2 * 5e2 * 5e2;
    SCOPED_VALUE(study) study = begin(ball, BY_PART);
    SCOPED_VALUE(thermal) thermal;
    assert_true(exchange(&study, "Shell=adiabatic environment=300", "Ball=1", &thermal,
                         &failure));
    assert_close(thermal.outside, 300, 0);
    assert_true(isnan(thermal.temperature[1]));
    assert_true(fabs(thermal.exchange.flow[1]) < 1e-6);
    assert_true(thermal.exchange.flow[0] > 0);
    assert_true(thermal.exchange.flow[0] < SIGMA * fourth * 4 * pi);
}

/* ---- Errors --------------------------------------------------------------------- */

static const char tins[] = "#declare Tin = texture { pigment { rgb 1 } }\n"
                           "#declare A = sphere { 0, 1 texture { Tin } }\n"
                           "#declare B = sphere { 3*x, 1 texture { Tin } }\n"
                           "object { A } object { B }\n";

static const struct {
    const char *scene;
    enum surfaces_by by;
    const char *temperatures, *emissivities, *message;
} refused[] = {
    { ball, BY_PART, "", "",
      "no temperature is set for: Shell; use --temperature NAME=KELVINS, or "
      "default=300" },
    { "plane { y, 0 } sphere { 2*y, 1 }", BY_PRIMITIVE, "default=300", "",
      "surface 1, the plane of line 1, receives radiation but emits none" },
    { tins, BY_MATERIAL, "A=300 B=400", "",
      "surface Tin has parts with different temperatures or emissivities, A and B" },
    { tins, BY_MATERIAL, "default=300", "A=.5", "A and B" },
};

TEST(refused)
{
    for (size_t i = 0; i < COUNT(refused); i++) {
        SCOPED_VALUE(study) study = begin(refused[i].scene, refused[i].by);
        struct thermal thermal;
        c205_error error = { "" };
        assert_false(exchange(&study, refused[i].temperatures, refused[i].emissivities,
                              &thermal, &error));
        FAIL_IF(!strstr(error.message, refused[i].message), "%s: %s",
                refused[i].message, error.message);
    }
}

TEST(wrong_values)
{
    static const char *const wrong[] = { "a=-1", "a=nan", "a=x", "=3", "a" };
    struct named_values given;
    c205_error error;
    named_begin(&given, &temperature_kind);
    for (size_t i = 0; i < COUNT(wrong); i++)
        assert_false(named_add(&given, wrong[i], &error));
    assert_true(named_add(&given, "a=adiabatic", &error));
    named_free(&given);
    named_begin(&given, &emissivity_kind);
    assert_false(named_add(&given, "a=1.5", &error));
    assert_string_equal(error.message, "expected NAME=VALUE with an emissivity that "
                                       "is between 0 and 1, found 'a=1.5'");
    assert_false(named_add(&given, "a=adiabatic", &error));
    named_free(&given);
}
