/* test_global_lines.c - areas and factors from lines through a whole scene are compared
 * with closed forms, with identities that hold exactly, and between both forms bit for
 * bit. A crossing that is counted twice, or for another pair of surfaces, fails here.
 *
 *     test_global_lines [SEED]
 */
#include "rt/heat/global_lines.h"

#include "tests/random.h"
#include "tests/unit/heat_steps.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

static uint64_t seed = 1;

static const struct sampling_options usual = {
    .mode = TRACE_VECTOR, .queue = 2000, .lines_log = 10, .repeats = 16, .lattice = true
};

static struct global_lines find(const char *text, struct sampling_options options)
{
    SCOPED(scene) *scene = read_scene(text);
    struct global_lines found;
    options.seed = seed;
    options.model = prior_model;
    FAIL_IF(!global_lines_find(scene, &options, &found, &failure), "%s: %s", text,
            failure.message);
    return found;
}

static void assert_exact(const struct global_lines *found)
{
    for (size_t i = 0; i <= found->surfaces; i++) {
        double sum = 0;
        for (size_t j = 0; j <= found->surfaces; j++) {
            assert_int_equal(global_lines_count(found, i, j),
                             global_lines_count(found, j, i));
            sum += global_lines_factor(found, i, j).value;
        }
        assert_true(fabs(sum - 1) < 1e-12);
    }
}

/* ---- Closed forms ------------------------------------------------------------ */

/* A ball in a shell sees only the shell. The factor from the shell to the ball is the
 * ratio of their areas. Each disc has two sides, so the factor is half of the known
 * factor between facing sides. */
TEST(shell_and_discs)
{
    SCOPED_VALUE(global_lines) found =
        find("sphere { 0, .5 } difference { sphere { 0, 1.1 } sphere { 0, 1 } }",
             usual);
    assert_exact(&found);
    assert_estimate("ball", global_lines_area(&found, 0), acos(-1));
    assert_estimate("shell", global_lines_area(&found, 2), 4 * acos(-1));
    assert_estimate("ball to shell", global_lines_factor(&found, 0, 2), 1);
    assert_estimate("shell to ball", global_lines_factor(&found, 2, 0), .25);
    assert_estimate("shell to shell", global_lines_factor(&found, 2, 2), .75);
    assert_estimate("outside", global_lines_factor(&found, 1, 3), 1);
    SCOPED_VALUE(global_lines) discs = find("disc { 0, z, 1 } disc { z, z, 1 }", usual);
    assert_exact(&discs);
    assert_estimate("disc", global_lines_area(&discs, 0), 2 * acos(-1));
    assert_estimate("discs", global_lines_factor(&discs, 0, 1), (3 - sqrt(5)) / 4);
    assert_estimate("none", global_lines_factor(&discs, 0, 0), 0);
}

/* Surfaces that intersect have the areas of massprops.csv. */
TEST(areas)
{
    static const struct {
        const char *solid;
        double area;
    } solids[] = {
        { "difference { box { <-1,-.5,-.25>, <1,.5,.25> }"
          " cylinder { <.4,0,-1>, <.4,0,1>, .3 } }",
          7.37699111843078 },
        { "merge { sphere { -.5*x, 1 } sphere { .5*x, 1 } }", 18.8495559215388 },
        { "torus { 1, .25 rotate 30*x }", 9.86960440108936 },
        { "box { 0, 1 } box { x, <2,1,1> }", 10 }, /* touching faces */
    };
    for (size_t s = 0; s < COUNT(solids); s++) {
        SCOPED_VALUE(global_lines) found = find(solids[s].solid, usual);
        struct estimate sum = { 0, 0 };
        assert_exact(&found);
        for (size_t i = 0; i < found.surfaces; i++) {
            struct estimate area = global_lines_area(&found, i);
            sum.value += area.value;
            sum.error += area.error;
        }
        assert_estimate(solids[s].solid, sum, solids[s].area);
    }
}

/* ---- All forms, any queue and jobs ------------------------------------------- */

TEST(forms)
{
    static const char text[] =
        "sphere { 0, .5 } blob { threshold .5 sphere { 2*x, 1, 1 } }"
        " cylinder { -2*x, -2*x + y, .5 open }"
        " difference { box { <-4,-2,1>, <4,-1,2> } sphere { -1.5*z, 3 } }";
    struct sampling_options options = usual;
    options.repeats = 2;
    options.lines_log = 8;
    SCOPED_VALUE(global_lines) one = find(text, options);
    assert_exact(&one);
    assert_true(are_steps(one.clocks, &one.accounts));
    for (int i = 0; i < 4; i++) {
        size_t width = one.surfaces + 1;
        options.mode = i == 0 ? TRACE_SCALAR : i == 3 ? TRACE_KERNELS : TRACE_VECTOR;
        options.queue = i == 1 ? 37 : 2000;
        options.jobs = i == 2 ? 2 : 1;
        SCOPED_VALUE(global_lines) other = find(text, options);
        assert_memory_equal(one.ends, other.ends, 2 * width * width * sizeof *one.ends);
    }
}

/* ---- Errors -------------------------------------------------------------------- */

static void assert_fails(const char *text, struct sampling_options options,
                         const char *message)
{
    SCOPED(scene) *scene = read_scene(text);
    struct global_lines found;
    c205_error error = { "" };
    options.model = prior_model;
    assert_false(global_lines_find(scene, &options, &found, &error));
    REQUIRE_OF(strstr(error.message, message), error);
}

TEST(refusals)
{
    struct sampling_options once = usual, many = usual;
    once.repeats = 1;
    many.lines_log = 21;
    assert_fails("camera { location -5*z }", usual, "no surfaces");
    assert_fails("sphere { 0, 1 } plane { y, -2 }", usual, "has unknown bounds");
    assert_fails("sphere { 0, 1 }", once, "at least 2 repeats");
    assert_fails("sphere { 0, 1 }", many, "at most 2^20");
}

ARGUMENTS(argc, argv)
{
    seed = argument(argc, argv, 1, seed);
}
