/* test_heat_programs.c - the programs that select points, sum the flow to receivers and
 * count gaps are compared with plain loops over random lists, and both forms bit for
 * bit. A lane that is lost at the end of a queue fails here. */
#include "rt/layout/single_run.h"
#include "rt/trace/form.h"
#include "tests/random.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

static uint64_t random_state = RANDOM_SEED + 31;

static size_t below(size_t most)
{
    return (size_t)xorshift_between(&random_state, 0, (int64_t)most - 1);
}

/* Returns a random length near the ends of queues, words and pairs. */
static size_t some_length(size_t most)
{
    static const size_t ends[] = { 1, 2, 3, 63, 64, 65, 4095, 4096, 4097 };
    size_t length = below(3) ? 1 + below(100) : ends[below(COUNT(ends))];
    return length < most ? length : most;
}

static struct object *assemble(const char *name, enum trace_mode mode)
{
    return NON_NULL(form_assemble_beside(name, mode, NULL, &failure));
}

static void begin(struct single_run *run, const struct object *program)
{
    static c205_error error;
    single_run_begin(run, program, prior_model, &error);
}

static void end(struct single_run *run, uint64_t from, c205_word *words, size_t count)
{
    uint64_t clocks = 0;
    FAIL_IF(!single_run_end(run, from, words, count, &clocks), "%s",
            run->error->message);
    assert_true(clocks > 0);
}

/* ---- Flow to receivers ---------------------------------------------------- */

enum { MAX_RAYS = 65535, MAX_RECEIVERS = 300 };

TEST(received)
{
    static c205_word weights[MAX_RAYS], list[MAX_RAYS];
    static c205_word words[2][2 * MAX_RECEIVERS + 1];
    SCOPED(object) *scalar = assemble("heat/received", TRACE_SCALAR);
    SCOPED(object) *vector = assemble("heat/received", TRACE_VECTOR);
    const struct object *const forms[] = { scalar, vector };
    for (int i = 0; i < 60; i++) {
        size_t rays = some_length(MAX_RAYS);
        size_t receivers = some_length(MAX_RECEIVERS);
        for (size_t k = 0; k < rays; k++) {
            weights[k] = c205_from_double(xorshift_real(&random_state, .1, 7));
            list[k] = c205_from_integer(
                (int64_t)below(below(2) ? receivers : 1 + receivers / 9));
        }
        for (int form = 0; form < 2; form++) {
            struct single_run run;
            begin(&run, forms[form]);
            single_run_word(&run, "received_rays", rays);
            single_run_word(&run, "received_receivers", receivers);
            single_run_room(&run, "received_weights", weights, rays);
            single_run_room(&run, "received_list", list, rays);
            uint64_t sums = single_run_room(&run, "received_sums", NULL,
                                            2 * receivers + 1);
            layout_word(&run.layout, "received_counts", sums + 64 * (receivers + 1));
            single_run_room(&run, "received_buffer", NULL, rays);
            single_run_room(&run, "received_places", NULL, receivers);
            end(&run, sums, words[form], 2 * receivers + 1);
        }
        double all = 0;
        for (size_t r = 0; r < receivers; r++) {
            double sum = 0, found = c205_to_double(words[0][r]);
            int64_t count = 0;
            for (size_t k = 0; k < rays; k++)
                if (c205_to_integer(list[k]) == (int64_t)r) {
                    sum += c205_to_double(weights[k]);
                    count++;
                }
            assert_int_equal(c205_to_integer(words[0][receivers + 1 + r]), count);
            FAIL_IF(!(fabs(found - sum) <= 1e-12 * sum),
                    "receiver %zu gets %.15g, not %.15g", r, found, sum);
            all += sum;
        }
        assert_close(c205_to_double(words[0][receivers]), all, 1e-12 * all);
        assert_memory_equal(words[0], words[1], (2 * receivers + 1) * sizeof **words);
    }
}

/* ---- Points that stay ------------------------------------------------------- */

enum { PLANES = 3, LIST_PLANES = 4, OWN = 5, MAX_POINTS = 5000, MAX_LIST = 10000 };

struct staying {
    size_t points, crossings;
    c205_word planes[PLANES * MAX_POINTS], list[LIST_PLANES * MAX_LIST];
};

/* Returns true if crossing i is near the point. Sets the primitive and the direction of
 * the crossing. */
static bool is_near(const struct staying *given, size_t i, size_t point,
                    int64_t *primitive, int64_t *sense)
{
    const c205_word *word = given->list + i;
    size_t n = given->crossings;
    *primitive = c205_to_integer(word[n]);
    *sense = c205_to_integer(word[3 * n]);
    return fabs(c205_to_double(word[0])) < 1e-7
           && c205_to_integer(word[2 * n]) == (int64_t)point;
}

/* Returns true if a point stays. The direction of the last crossing of its own
 * primitive must be above 0, and that of no earlier primitive may be. */
static bool stays(const struct staying *given, size_t point)
{
    int64_t own = 0, primitive, sense;
    for (size_t i = 0; i < given->crossings; i++)
        if (is_near(given, i, point, &primitive, &sense) && primitive == OWN)
            own = sense;
    for (size_t i = 0; i < given->crossings; i++)
        if (is_near(given, i, point, &primitive, &sense) && primitive < OWN
            && sense == own)
            return false;
    return own > 0;
}

TEST(staying)
{
    static struct staying given;
    static c205_word made[PLANES * MAX_POINTS + 1];
    SCOPED(object) *scalar = assemble("heat/faces", TRACE_SCALAR);
    SCOPED(object) *vector = assemble("heat/faces", TRACE_VECTOR);
    const struct object *const forms[] = { scalar, vector };
    for (int i = 0; i < 60; i++) {
        given.points = some_length(MAX_POINTS);
        given.crossings = below(5) == 0   ? 0
                          : below(4) == 0 ? 4097 + below(5000)
                                          : some_length(5000);
        for (size_t k = 0; k < PLANES * given.points; k++)
            given.planes[k] = xorshift(&random_state);
        /* The crossings are near the origin or far from it. They belong to the point's
         * primitive or to another one. */
        static const double distances[] = { 0, 9e-8, -9e-8, 1.1e-7, -1.1e-7, 2 };
        c205_word *list = given.list;
        size_t n = given.crossings;
        for (size_t k = 0; k < n; k++) {
            list[k] = c205_from_double(distances[below(6)]);
            list[n + k] = c205_from_integer((int64_t)(below(2) ? OWN : below(2 * OWN)));
            list[2 * n + k] = c205_from_integer((int64_t)below(given.points));
            list[3 * n + k] = c205_from_integer((int64_t)(1 + below(3)));
        }
        for (int form = 0; form < 2; form++) {
            size_t words = PLANES * given.points;
            struct single_run run;
            begin(&run, forms[form]);
            single_run_word(&run, "faces_points", given.points);
            single_run_word(&run, "faces_planes", PLANES);
            single_run_room(&run, "faces_from", given.planes, words);
            uint64_t from = single_run_room(&run, "faces_results", NULL, words + 1);
            single_run_word(&run, "faces_crossings", given.crossings);
            single_run_room(&run, "faces_list", given.list,
                            LIST_PLANES * given.crossings);
            single_run_word(&run, "faces_primitive", OWN);
            single_run_room(&run, "faces_kept", NULL, given.points);
            end(&run, from, made, words + 1);
            size_t kept = 0;
            for (size_t point = 0; point < given.points; point++) {
                if (!stays(&given, point))
                    continue;
                for (size_t plane = 0; plane < PLANES; plane++)
                    assert_true(made[plane * given.points + kept]
                                == given.planes[plane * given.points + point]);
                kept++;
            }
            assert_int_equal(c205_to_integer(made[PLANES * given.points]), kept);
        }
    }
}

/* ---- Gaps ------------------------------------------------------------------ */

enum { MAX_GAPS = 65534, MAX_SURFACES = 40 };

/* The ends of gaps are random. Their planes are the distances, which are multiples of
 * the least gap, the surfaces, and the numbers of solids that contain them. */
TEST(gaps)
{
    static c205_word planes[3 * (MAX_GAPS + 1)];
    c205_word counts[MAX_SURFACES * MAX_SURFACES];
    SCOPED(object) *scalar = assemble("heat/gaps", TRACE_SCALAR);
    SCOPED(object) *vector = assemble("heat/gaps", TRACE_VECTOR);
    const struct object *const forms[] = { scalar, vector };
    for (int i = 0; i < 60; i++) {
        size_t gaps = i ? some_length(MAX_GAPS) : MAX_GAPS;
        size_t n = 1 + below(MAX_SURFACES), cells = n * n, ends = gaps + 1;
        for (size_t k = 0; k < ends; k++) {
            planes[k] = c205_from_double((double)below(5) / 4 - .5);
            planes[ends + k] = c205_from_integer((int64_t)below(n));
            planes[2 * ends + k] = c205_from_integer(below(2) ? 0
                                                              : (int64_t)below(4) - 1);
        }
        for (size_t form = 0; form < 2; form++) {
            struct single_run run;
            begin(&run, forms[form]);
            single_run_word(&run, "gaps_count", gaps);
            single_run_word(&run, "gaps_surfaces", n);
            single_run_room(&run, "gaps_ends", planes, 3 * (gaps + 1));
            uint64_t address = single_run_room(&run, "gaps_counts", NULL, cells);
            single_run_room(&run, "gaps_buffer", NULL, 3 * gaps);
            single_run_number(&run, "gaps_least", 0, .25);
            end(&run, address, counts, cells);
            int64_t left[MAX_SURFACES * MAX_SURFACES];
            for (size_t cell = 0; cell < cells; cell++)
                left[cell] = c205_to_integer(counts[cell]);
            for (size_t k = 0; k < gaps; k++) {
                const c205_word *end = planes + k;
                double length = fabs(c205_to_double(end[1]) - c205_to_double(end[0]));
                size_t from = (size_t)c205_to_integer(end[ends]);
                size_t to = (size_t)c205_to_integer(end[ends + 1]);
                if (length >= .25 && c205_to_integer(end[2 * ends]) == 0)
                    left[from * n + to]--;
            }
            for (size_t cell = 0; cell < cells; cell++)
                assert_int_equal(left[cell], 0);
        }
    }
}
