/* test_cylinder_hits.c - the rays that hit cylinders. Random rays and cylinders in both
 * forms are compared with plain C, and a scene is compared with all first hits of the
 * same rays. A hit that one form misses, or a part that is accepted although it is not
 * a solid cylinder, fails here. */
#include "rt/heat/hits.h"
#include "rt/layout/single_run.h"
#include "rt/trace/form.h"
#include "tests/oracle/plain_shapes.h"
#include "tests/random.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

enum { WORDS = 8, MAX_RAYS = 700, MAX_CYLINDERS = 9 };

static uint64_t chance = RANDOM_SEED + 41;

/* ---- Rays and random cylinders ------------------------------------------------ */

struct bundle {
    size_t rays, cylinders;
    double origin[MAX_RAYS][3], direction[MAX_RAYS][3];
    double words[MAX_CYLINDERS][WORDS];
};

static void draw_unit(double v[3])
{
    double length = 0;
    while (length < .1 || length > 1) {
        length = 0;
        for (int i = 0; i < 3; i++) {
            v[i] = xorshift_real(&chance, -1, 1);
            length += v[i] * v[i];
        }
    }
    for (int i = 0; i < 3; i++)
        v[i] /= sqrt(length);
}

static void draw(struct bundle *bundle)
{
    bundle->rays = (size_t)xorshift_between(&chance, 1, MAX_RAYS);
    bundle->cylinders = (size_t)xorshift_between(&chance, 1, MAX_CYLINDERS);
    for (size_t i = 0; i < bundle->rays; i++) {
        for (int k = 0; k < 3; k++)
            bundle->origin[i][k] = xorshift_real(&chance, -3, 3);
        draw_unit(bundle->direction[i]);
    }
    for (size_t i = 0; i < bundle->cylinders; i++) {
        double *words = bundle->words[i];
        double radius = xorshift_real(&chance, .05, .6);
        for (int k = 0; k < 3; k++)
            words[k] = xorshift_real(&chance, -2, 2);
        draw_unit(words + 3);
        words[6] = xorshift(&chance) % 2 ? xorshift_real(&chance, .02, .2)
                                         : xorshift_real(&chance, .2, 3);
        words[7] = radius * radius;
    }
}

/* Intersects the side, and the slab between the discs. Returns 1 for a hit, 0 for a
 * miss, and -1 if rounding decides. */
static int strikes(const double o[3], const double d[3], const double words[WORDS])
{
    const double *axis = words + 3;
    double w[3];
    for (int i = 0; i < 3; i++)
        w[i] = o[i] - words[i];
    double a = dot(d, axis);
    double b = dot(w, axis);
    double across = 1 - a * a;
    double middle = -(dot(w, d) - a * b) / across;
    double half = middle * middle - (dot(w, w) - b * b - words[7]) / across;
    if (fabs(half) < 1e-8)
        return -1;
    if (half < 0)
        return 0;
    half = sqrt(half);
    double low = -b / a;
    double high = (words[6] - b) / a;
    double from = fmax(fmax(middle - half, fmin(low, high)), 0);
    double to = fmin(middle + half, fmax(low, high));
    if (fabs(to - from) < 1e-8)
        return -1;
    return from < to;
}

static void run(const struct bundle *bundle, enum trace_mode mode, size_t queue,
                c205_word *reported)
{
    const struct asm_define defines[] = { { "QUEUE", (int64_t)queue }, { NULL, 0 } };
    static c205_word planes[6 * MAX_RAYS], words[WORDS * MAX_CYLINDERS];
    size_t n = bundle->rays;
    struct single_run run;
    SCOPED(object) *program = NON_NULL(
        form_assemble_beside("heat/hits", mode, defines, &failure));
    uint64_t clocks = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < 3; k++) {
            planes[k * n + i] = c205_from_double(bundle->origin[i][k]);
            planes[(3 + k) * n + i] = c205_from_double(bundle->direction[i][k]);
        }
    put_numbers(words, bundle->words[0], WORDS * bundle->cylinders);
    single_run_begin(&run, program, prior_model, &failure);
    single_run_word(&run, "hits_rays", n);
    uint64_t at = single_run_room(&run, "hits_from", planes, 6 * n);
    layout_word(&run.layout, "hits_towards", at + UINT64_C(192) * n);
    single_run_word(&run, "hits_cylinders", bundle->cylinders);
    single_run_room(&run, "hits_list", words, WORDS * bundle->cylinders);
    uint64_t made = single_run_room(&run, "hits_results", NULL, n);
    REQUIRE(single_run_end(&run, made, reported, n, &clocks));
}

TEST(rays)
{
    static const size_t queues[] = { 1, 63, 64, 65, 300, 65535 };
    static struct bundle bundle;
    static c205_word scalar[MAX_RAYS], vector[MAX_RAYS];
    for (int i = 0; i < 60; i++) {
        draw(&bundle);
        run(&bundle, TRACE_SCALAR, 1, scalar);
        for (size_t ray = 0; ray < bundle.rays; ray++) {
            int expected = 0;
            for (size_t k = 0; k < bundle.cylinders && expected != 1; k++) {
                int one = strikes(bundle.origin[ray], bundle.direction[ray],
                                  bundle.words[k]);
                expected = one == 0 ? expected : one;
            }
            FAIL_IF(expected >= 0 && c205_to_integer(scalar[ray]) != expected,
                    "ray %zu of %zu, %zu cylinders: told %d, not %d", ray, bundle.rays,
                    bundle.cylinders, (int)c205_to_integer(scalar[ray]), expected);
        }
        run(&bundle, TRACE_VECTOR, queues[(size_t)i % COUNT(queues)], vector);
        assert_memory_equal(scalar, vector, bundle.rays * sizeof *scalar);
    }
}

/* ---- A scene --------------------------------------------------------------------- */

static const char tubes[] =
    "#declare Burner = disc { 0, y, 2 } object { Burner }\n"
    "#declare Tube = union { cylinder { -2*x, 2*x, .2 }"
    " cylinder { -.02*x, .02*x, .5 } }\n"
    "object { Tube translate y } object { Tube scale .5 rotate 30*y"
    " translate <0, .5, 1> }\n";

static void find(const struct scene *scene, const char *from, enum trace_mode mode,
                 size_t queue, struct hits *hits)
{
    struct hits_options options = ON_PRIOR(.mode = mode, .queue = queue, .points = 256,
                                           .repeats = 4, .lattice = true, .seed = 3,
                                           .from = from);
    SCOPED_VALUE(named_parts) parts;
    assert_true(named_parts_find(scene, &parts));
    REQUIRE(hits_find(scene, &parts, &options, hits, &failure));
}

/* The number of hits must equal the number of first crossings of the same rays. */
TEST(scene)
{
    SCOPED(scene) *scene = read_scene(tubes);
    struct sampling_options options = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 100,
                                               .points = 256, .repeats = 4,
                                               .lattice = true, .seed = 3);
    SCOPED(factors) *factors = NON_NULL(factors_new(scene, &options, &failure));
    SCOPED_VALUE(factor_row) row;
    SCOPED_VALUE(hits) vector;
    SCOPED_VALUE(hits) scalar;
    assert_true(factors_find(factors, &(size_t){ 0 }, 1, &row, &failure));
    find(scene, "Burner", TRACE_VECTOR, 77, &vector);
    find(scene, "Burner", TRACE_SCALAR, 0, &scalar);
    assert_int_equal(vector.cylinders, 4);
    assert_int_equal(vector.rays, row.sent);
    assert_int_equal(vector.struck, row.sent - row.count[row.receivers - 1]);
    assert_close(vector.factor.value, 1 - row.factor[row.receivers - 1].value, 1e-12);
    assert_int_equal(vector.struck, scalar.struck);
    assert_memory_equal(&vector.factor, &scalar.factor, sizeof vector.factor);
    assert_true(scalar.accounts.clocks > vector.accounts.clocks);
}

static void refuses(const char *text, const char *from, const char *message)
{
    struct hits_options options = ON_PRIOR(.mode = TRACE_VECTOR, .queue = 77,
                                           .points = 10, .repeats = 2, .from = from);
    SCOPED(scene) *scene = read_scene(text);
    SCOPED_VALUE(named_parts) parts;
    struct hits hits;
    c205_error error = { "" };
    assert_true(named_parts_find(scene, &parts));
    assert_false(hits_find(scene, &parts, &options, &hits, &error));
    FAIL_IF(!strstr(error.message, message), "%s: %s", message, error.message);
}

TEST(refused)
{
    refuses(tubes, "Burners", "unknown part or material 'Burners'");
    refuses("#declare A = sphere { 0, 1 } object { A } sphere { 3*x, 1 }", "A",
            "the sphere of line 1 is not a separate solid cylinder");
    refuses("#declare A = sphere { 0, 1 } object { A }"
            " cylinder { 3*x, 4*x, 1 scale <1, 2, 1> }",
            "A", "not a separate solid cylinder");
    refuses("#declare A = sphere { 0, 1 } object { A }", "A",
            "the scene has no cylinder to test");
    refuses("#declare A = plane { y, 0 } object { A } cylinder { 3*x, 4*x, 1 }", "A",
            "a plane is infinite");
}
