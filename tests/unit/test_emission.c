/* test_emission.c - points on surfaces, normals, weights and directions that the
 * machine computes are compared with the surface, its area and the cosine law, over
 * random shapes that emit. A point off the surface, a normal that points inside or a
 * biased distribution fails here.
 *
 *     test_emission [TRIES [SEED]]
 */
#include "base/accounts.h"
#include "rt/heat/alias.h"
#include "rt/heat/emission.h"
#include "rt/shapes/shape.h"
#include "tests/oracle/plain_area.h"
#include "tests/oracle/points.h"
#include "tests/unit/draw.h"
#include "tests/unit/emitting_shapes.h"
#include "tests/unit/plain_surface.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

static size_t tries = 4; /* number of tries for each kind */

/* ---- Emission ------------------------------------------------------------- */

/* A point: its words, as the machine writes them to its planes, and their values. */
struct emitted_point {
    c205_word words[EMITTED_PLANES];
    double place[3], face[3], weight, ray[3];
};

static void run(const struct emission *emission, size_t count,
                const struct emission_choice *choice, struct emitted_point *points,
                struct accounts *accounts)
{
    static c205_word planes[EMITTED_PLANES * MAX_EMISSION];
    REQUIRE(emission_run(emission, choice, planes, accounts, &failure));
    for (size_t i = 0; i < count; i++) {
        struct emitted_point *point = &points[i];
        for (size_t k = 0; k < EMITTED_PLANES; k++)
            point->words[k] = planes[k * count + i];
        for (size_t k = 0; k < 3; k++) {
            point->place[k] = c205_to_double(point->words[EMITTED_POINT + k]);
            point->face[k] = c205_to_double(point->words[EMITTED_FACE + k]);
            point->ray[k] = c205_to_double(point->words[EMITTED_RAY + k]);
        }
        point->weight = c205_to_double(point->words[EMITTED_WEIGHT]);
    }
}

static void emit(const struct primitive *primitive, struct emission_options options,
                 struct emission_choice choice, struct emitted_point *points)
{
    options.model = prior_model;
    SCOPED(emission) *emission = NON_NULL(emission_new(primitive, &options, &failure));
    run(emission, options.points, &choice, points, NULL);
}

enum { POINTS = 4000 };
static struct emitted_point emitted[2][MAX_EMISSION];

static struct emission_choice some_choice(void)
{
    return (struct emission_choice){ .seed = count_between(0, 1000000),
                                     .first = count_between(0, 1000000),
                                     .m = 20,
                                     .shift = count_between(0, 1000) };
}

/* Calls a check for `times` random shapes of each kind. */
static void each_shape(size_t times, void (*check)(const struct primitive *primitive))
{
    for (size_t i = 0; i < times * EMITTING_KINDS; i++) {
        struct primitive primitive = draw_emitting(emitting_kinds[i % EMITTING_KINDS],
                                                   &random_state);
        check(&primitive);
    }
}

/* ---- On the surface ------------------------------------------------------- */

/* Returns true if a vertical ray from above hits the surface at the point. The crossing
 * is computed in the shape's own space. Near an edge another one may be first. */
static bool meets(const struct primitive *primitive, const double place[3],
                  const double face[3])
{
    struct crossing found[MAX_CROSSINGS];
    struct ray ray;
    copy(ray.direction, face);
    scale_by(ray.direction, -1);
    add_scaled(ray.origin, place, 1e-3, face);
    transform_point(&primitive->to_local, ray.origin);
    transform_direction(&primitive->to_local, ray.direction);
    size_t count = plain_crossings(primitive, &ray, found);
    for (size_t i = 0; i < count; i++) {
        double normal[3];
        if (fabs(found[i].distance - 1e-3) > 1e-8)
            continue;
        copy(normal, found[i].normal);
        transform_normal(&primitive->to_local, normal);
        normalise(normal);
        if (fabs(fabs(dot(normal, face)) - 1) < 1e-9)
            return true;
    }
    return false;
}

static bool encloses(const struct primitive *primitive, const double place[3],
                     double above, const double face[3])
{
    double point[3];
    add_scaled(point, place, above, face);
    transform_point(&primitive->to_local, point);
    return plain_encloses(primitive, point);
}

/* Fails unless each point is on the surface, with the outside above it. A thousandth of
 * the points may fail, because near an edge another surface may be within 1e-7. */
static void check_surface(const struct primitive *primitive)
{
    struct emission_options options = { TRACE_VECTOR, 500, POINTS, count_between(0, 1),
                                        NULL };
    bool sided = !shape_is_surface(primitive);
    size_t astray = 0;
    emit(primitive, options, some_choice(), emitted[0]);
    for (size_t i = 0; i < POINTS; i++) {
        const double *place = emitted[0][i].place, *face = emitted[0][i].face;
        const double *ray = emitted[0][i].ray;
        assert_near(dot(face, face), 1, 1e-12);
        assert_near(dot(ray, ray), 1, 1e-12);
        assert_true(dot(face, ray) > 0);
        astray += !meets(primitive, place, face)
                  || (sided
                      && (encloses(primitive, place, 1e-7, face)
                          || !encloses(primitive, place, -1e-7, face)));
    }
    assert_in_range(astray, 0, POINTS / 1000);
}

TEST_CALL(surfaces, each_shape(tries, check_surface))

/* ---- Means ---------------------------------------------------------------- */

struct mean {
    double count, sum, squares;
};

static void add_to(struct mean *mean, double value)
{
    mean->count++;
    mean->sum += value;
    mean->squares += value * value;
}

/* Fails unless the mean is within `sigmas` standard errors and `more`. */
static void assert_mean(const struct mean *mean, double expected, double sigmas,
                        double more)
{
    double found = mean->sum / mean->count;
    double variance = mean->squares / mean->count - found * found;
    assert_near(found, expected, sigmas * sqrt(fmax(variance, 0) / mean->count) + more);
}

/* The mean weight must be the area of the shape, and the weighted mean of the points
 * its centroid. */
static void check_area(const struct primitive *primitive)
{
    struct emission_options options = { TRACE_VECTOR, 2000, 5 * POINTS, false, NULL };
    struct plain_area expected = plain_area(primitive);
    struct mean area = { 0 }, moments[3] = { { 0 } };
    double slack = 1e-5 * expected.area;
    emit(primitive, options, some_choice(), emitted[0]);
    for (size_t i = 0; i < options.points; i++) {
        const struct emitted_point *point = &emitted[0][i];
        add_to(&area, point->weight);
        for (int k = 0; k < 3; k++)
            add_to(&moments[k], point->weight * (point->place[k] - expected.middle[k]));
    }
    assert_mean(&area, expected.area, 4.5, slack);
    for (int k = 0; k < 3; k++)
        assert_mean(&moments[k], 0, 4.5, slack);
}

TEST_CALL(areas, each_shape(tries, check_area))

/* The areas of massprops.csv. If all parts of a surface are equivalent, each weight is
 * the area. The weights of a torus differ. */
TEST(exact_areas)
{
    static const double areas[] = { 12.5663706143592, 7.85398163397448, 7 };
    struct emission_options options = { TRACE_VECTOR, 100, 100, false, NULL };
    struct emission_options lattice = { TRACE_VECTOR, 2000, 16384, true, NULL };
    struct mean area = { 0 };
    SCOPED(scene) *scene = read_scene(
        "sphere { <.3,-.2,.5>, 1 } cylinder { 0, 2*y, .5 }"
        "box { <-1,-.5,-.25>, <1,.5,.25> rotate 30*z } torus { 1, .25 }");
    for (size_t k = 0; k < COUNT(areas); k++) {
        emit(&scene->primitives[k], options, some_choice(), emitted[0]);
        for (size_t i = 0; i < 100; i++)
            assert_near(emitted[0][i].weight, areas[k], 1e-11 * areas[k]);
    }
    emit(&scene->primitives[3], lattice, (struct emission_choice){ .seed = 1, .m = 14 },
         emitted[0]);
    for (size_t i = 0; i < lattice.points; i++)
        add_to(&area, emitted[0][i].weight);
    assert_near(area.sum / area.count, 9.86960440108936, 1e-9);
}

/* ---- The circle, and the cosine law ---------------------------------------- */

/* Points and directions of a sphere are compared with long double formulas. */
TEST(accuracy)
{
    SCOPED(scene) *scene = read_scene("sphere { 0, 1 }");
    struct emission_options options = { TRACE_VECTOR, 2000, 20000, false, NULL };
    struct emission_choice choice = some_choice();
    static const long double turn = 6.283185307179586476925286766559L;
    double most = 0;
    emit(scene->primitives, options, choice, emitted[0]);
    for (size_t i = 0; i < options.points; i++) {
        long double u = stream_word(choice.seed, choice.first + i, 0) * 0x1p-47L;
        long double t = stream_word(choice.seed, choice.first + i, 1) * 0x1p-47L;
        long double r = 2 * sqrtl(u * (1 - u));
        long double exact[] = { r * cosl(turn * t), 1 - 2 * u, r * sinl(turn * t) };
        for (int k = 0; k < 3; k++)
            most = fmax(most, (double)fabsl(emitted[0][i].place[k] - exact[k]));
    }
    print_message("points of the unit circle: off by %.1e at most\n", most);
    assert_true(most < 3e-13);
}

/* D . n must be sqrt (1 - u), where u is the third number, as the cosine law requires.
 * The mean of D is 2/3 n, and the mean of D D^T is (1 + n n^T) / 4. */
static void check_cosine_law(const struct primitive *primitive)
{
    struct emission_options options = { TRACE_VECTOR, 2000, 5 * POINTS, false, NULL };
    struct emission_choice choice = some_choice();
    struct mean first[3] = { { 0 } }, second[3][3] = { { { 0 } } };
    emit(primitive, options, choice, emitted[0]);
    for (size_t i = 0; i < options.points; i++) {
        const double *face = emitted[0][i].face, *ray = emitted[0][i].ray;
        double u = (double)stream_word(choice.seed, choice.first + i, 2) * 0x1p-47;
        assert_near(dot(face, ray), sqrt(1 - u), 1e-12);
        for (int j = 0; j < 3; j++) {
            add_to(&first[j], ray[j] - face[j] * 2 / 3);
            for (int k = 0; k <= j; k++)
                add_to(&second[j][k],
                       ray[j] * ray[k] - ((j == k) + face[j] * face[k]) / 4);
        }
    }
    for (int j = 0; j < 3; j++) {
        assert_mean(&first[j], 0, 4.5, 0);
        for (int k = 0; k <= j; k++)
            assert_mean(&second[j][k], 0, 4.5, 0);
    }
}

TEST_CALL(cosine_law, each_shape(tries, check_cosine_law))

/* ---- Both forms ------------------------------------------------------------ */

/* Compares the scalar form with the vector form in two calls and other queues. */
static void compare_forms(const struct primitive *primitive)
{
    size_t count = count_between(2, 3000), cut = count_between(1, count - 1);
    struct emission_options options = { TRACE_SCALAR, 0, count, count_between(0, 1),
                                        NULL };
    struct emission_choice choice = some_choice();
    choice.first %= 1048576 - count;
    emit(primitive, options, choice, emitted[0]);
    options.mode = TRACE_VECTOR;
    options.points = cut;
    options.queue = count_between(1, 3000);
    emit(primitive, options, choice, emitted[1]);
    options.points = count - cut;
    options.queue = count_between(1, 3000);
    choice.first += cut;
    emit(primitive, options, choice, emitted[1] + cut);
    assert_memory_equal(emitted[0], emitted[1], count * sizeof **emitted);
}

TEST_CALL(forms, each_shape(2 * tries, compare_forms))

/* ---- Factors --------------------------------------------------------------- */

/* Compares the fraction of rays from the plane y = 0 that cross the plane y = height in
 * a disc with this radius or, if the radius is 0, in the unit square. */
static void check_share(const struct primitive *primitive, double height, double radius,
                        double expected)
{
    struct emission_options options = { TRACE_VECTOR, 2000, 60000, false, NULL };
    size_t through = 0;
    emit(primitive, options, some_choice(), emitted[0]);
    for (size_t i = 0; i < options.points; i++) {
        const struct emitted_point *point = &emitted[0][i];
        double place[3];
        add_scaled(place, point->place, (height - point->place[1]) / point->ray[1],
                   point->ray);
        through += radius > 0
                       ? place[0] * place[0] + place[2] * place[2] <= radius * radius
                       : place[0] >= 0 && place[0] <= 1 && place[2] >= 0
                             && place[2] <= 1;
    }
    assert_near((double)through / 60000, expected,
                4 * sqrt(expected * (1 - expected) / 60000));
}

/* The factors must equal those of viewfactors.csv. */
TEST(factors)
{
    SCOPED(scene) *scene = read_scene(
        "mesh { triangle { 0, z, x + z } triangle { 0, x + z, x } } disc { 0, y, 1 }");
    check_share(&scene->primitives[0], 1, 0, 0.1998248956984);
    check_share(&scene->primitives[1], .9, .6, 0.1809950221376);
    check_share(&scene->primitives[1], 1, 1, 0.3819660112501);
}

/* ---- Errors ----------------------------------------------------------------- */

static void assert_no_emission(const struct primitive *primitive,
                               struct emission_options options, const char *message)
{
    c205_error error = { "" };
    options.model = prior_model;
    assert_null(emission_new(primitive, &options, &error));
    FAIL_IF(!strstr(error.message, message), "\"%s\" does not say \"%s\"",
            error.message, message);
}

TEST(refused)
{
    struct primitive primitive = { .kind = PRIMITIVE_TORUS,
                                   .line = 7,
                                   .shape.torus = { 1, 2 } };
    struct emission_options options = { TRACE_VECTOR, 10, 10, false, NULL };
    bool emits[PRIMITIVE_KINDS] = { false };
    move_shape(&primitive, &placement_none);
    assert_no_emission(&primitive, options,
                       "the torus of line 7: a torus that intersects itself");
    primitive.kind = PRIMITIVE_PLANE;
    assert_no_emission(&primitive, options, "the plane of line 7: a plane is infinite");
    for (size_t i = 0; i < EMITTING_KINDS; i++)
        emits[emitting_kinds[i]] = true;
    for (int kind = 0; kind < PRIMITIVE_KINDS; kind++)
        if (!emits[kind] && kind != PRIMITIVE_PLANE) {
            primitive.kind = (enum primitive_kind)kind;
            assert_no_emission(&primitive, options,
                               "only lines can sample its surface");
        }
}

TEST(options)
{
    static const struct {
        struct emission_options options;
        const char *message;
    } rows[] = {
        { { TRACE_KERNELS, 10, 10, false, NULL }, "scalar or vector" },
        { { TRACE_SCALAR, 0, 0, false, NULL }, "0 points" },
        { { TRACE_SCALAR, 0, 65536, false, NULL }, "65536 points" },
        { { TRACE_VECTOR, 0, 10, false, NULL }, "a queue of 0 points" },
    };
    struct primitive primitive = draw_emitting(PRIMITIVE_SPHERE, &random_state);
    for (size_t i = 0; i < COUNT(rows); i++)
        assert_no_emission(&primitive, rows[i].options, rows[i].message);
}

/* ---- The table -------------------------------------------------------------- */

TEST(alias)
{
    for (size_t i = 0; i < 100 * tries; i++) {
        size_t count = count_between(1, 50);
        enum { MAX = 50 };
        double weights[MAX], share[MAX], found[MAX] = { 0 }, sum = 0;
        size_t alias[MAX];
        for (size_t k = 0; k < count; k++)
            sum += weights[k] = count_between(0, 4) == 0
                                    ? 0
                                    : number_between(&random_state, 0, 1);
        weights[count_between(0, count - 1)] += 1;
        sum += 1;
        assert_true(alias_build(weights, count, share, alias));
        for (size_t k = 0; k < count; k++) {
            assert_true(share[k] >= 0 && share[k] <= 1 && alias[k] < count);
            found[k] += share[k];
            found[alias[k]] += 1 - share[k];
        }
        for (size_t k = 0; k < count; k++)
            assert_near(found[k] / (double)count, weights[k] / sum, 1e-13);
    }
}

/* ---- Clocks of a point ------------------------------------------------------ */

static double clocks_a_point(const struct accounts *accounts, const char *region)
{
    c205_account account = region ? *accounts_find(accounts, region)
                                  : accounts_together(accounts);
    uint64_t waits = account.clocks[C205_TRANSLATION_MISS]
                     + account.clocks[C205_PAGE_FAULT];
    return (double)(accounts_clocks(&account) - waits) / MAX_EMISSION;
}

/* Prints the clocks of a run of maximum length, without the clocks of page faults. */
static double print_clocks(const struct primitive *primitive, enum trace_mode mode,
                           size_t queue, c205_model *model)
{
    struct emission_options options = { mode, queue, MAX_EMISSION, false, model };
    SCOPED_VALUE(accounts) accounts = { .model = model };
    SCOPED(emission) *emission = NON_NULL(emission_new(primitive, &options, &failure));
    run(emission, MAX_EMISSION, &(struct emission_choice){ .seed = 1 }, emitted[0],
        &accounts);
    double all = clocks_a_point(&accounts, NULL);
    print_message("%-13s  %-6s  %5zu  %5.1f  %5.1f  %9.1f  %5.1f\n",
                  primitive_kind_name(primitive->kind), trace_mode_name(mode),
                  mode == TRACE_SCALAR ? 1 : queue, clocks_a_point(&accounts, "emit"),
                  clocks_a_point(&accounts, "carry"),
                  clocks_a_point(&accounts, "direction"), all);
    return all;
}

TEST(clocks)
{
    static const enum primitive_kind kinds[] = { PRIMITIVE_SPHERE, PRIMITIVE_CYLINDER,
                                                 PRIMITIVE_BOX, PRIMITIVE_TORUS,
                                                 PRIMITIVE_STEINER_PATCH };
    SCOPED(c205_model) *model = c205_model_find("cyber205-2pipe", &failure);
    print_message("surface        form    queue   emit  carry  direction    all\n");
    for (size_t i = 0; i < COUNT(kinds); i++) {
        struct primitive primitive = draw_emitting(kinds[i], &random_state);
        double scalar = print_clocks(&primitive, TRACE_SCALAR, 0, model);
        assert_true(4 * print_clocks(&primitive, TRACE_VECTOR, 2000, model) < scalar);
        print_clocks(&primitive, TRACE_VECTOR, MAX_EMISSION, model);
    }
}

COUNT_AND_SEED(tries, random_state);
