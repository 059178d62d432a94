/* test_exchange.c - radiative exchange of grey surfaces is compared with known cases
 * and with elimination in long doubles, over random enclosures, in both forms. A wrong
 * coefficient of the equations or a different rounding in one form fails here. */
#include "rt/heat/exchange.h"
#include "tests/random.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

#define SIGMA 5.670374419e-8
enum { MAX = 70 };

/* Surfaces and the factors between them. */
struct enclosure {
    size_t count;
    double area[MAX], emissivity[MAX], temperature[MAX];
    double factors[MAX * (MAX + 1)], outside;
};

static struct exchange_given given_of(const struct enclosure *enclosure,
                                      enum trace_mode mode)
{
    return (struct exchange_given)ON_PRIOR(.mode = mode, .count = enclosure->count,
                                           .area = enclosure->area,
                                           .emissivity = enclosure->emissivity,
                                           .temperature = enclosure->temperature,
                                           .factors = enclosure->factors,
                                           .outside = enclosure->outside);
}

/* Solves the equations in both forms. The radiosities must be equal bit for bit. */
static void solve(const struct enclosure *enclosure, struct exchange *vector)
{
    struct exchange_given given = given_of(enclosure, TRACE_VECTOR);
    SCOPED_VALUE(exchange) scalar;
    size_t size = enclosure->count * sizeof(double);
    REQUIRE(exchange_find(&given, vector, &failure));
    given.mode = TRACE_SCALAR;
    assert_true(exchange_find(&given, &scalar, &failure));
    assert_memory_equal(vector->radiosity, scalar.radiosity, size);
    assert_memory_equal(vector->irradiation, scalar.irradiation, size);
    assert_memory_equal(vector->flow, scalar.flow, size);
    assert_memory_equal(&vector->outside, &scalar.outside, sizeof(double));
    assert_memory_equal(&vector->sum, &scalar.sum, sizeof(double));
}

/* ---- Known cases: exchange.csv ---------------------------------------------- */

TEST(spheres)
{
    double pi = acos(-1), flow = 25842.18560027;
    const struct enclosure spheres = {
        .count = 2,
        .area = { 4 * pi, 16 * pi },
        .emissivity = { .8, .5 },
        .temperature = { 500, 300 },
        .factors = { 0, 1, 0, .25, .75, 0 },
    };
    SCOPED_VALUE(exchange) exchange;
    solve(&spheres, &exchange);
    assert_close(exchange.flow[0], flow, 1e-9 * flow);
    assert_close(exchange.flow[1], -flow, 1e-9 * flow);
    assert_close(exchange.sum, 0, 1e-9 * flow);
}

TEST(cube)
{
    double beside = 0.2000437760754, opposite = 1 - 4 * beside;
    static const double flows[] = { 36940.48878972, -9963.172602644, -6744.32904677,
                                    -6744.32904677, -6744.32904677,  -6744.32904677 };
    struct enclosure cube = { .count = 6 };
    SCOPED_VALUE(exchange) exchange;
    for (size_t i = 0; i < 6; i++) {
        cube.area[i] = 1;
        cube.emissivity[i] = i == 0 ? .9 : i == 1 ? .5 : .3;
        cube.temperature[i] = i == 0 ? 1000 : i == 1 ? 500 : 300;
        for (size_t j = 0; j < 6; j++)
            cube.factors[7 * i + j] = i == j ? 0 : i / 2 == j / 2 ? opposite : beside;
    }
    solve(&cube, &exchange);
    for (size_t i = 0; i < 6; i++)
        assert_close(exchange.flow[i], flows[i], 1e-9 * 36940);
    assert_close(exchange.sum, 0, 1e-9 * 36940);
}

/* The surfaces are the tube and two fins, compared by emission through the opening. */
TEST(finned_bay)
{
    static const double emissivities[] = { .5, 1 };
    static const double expected[] = { 0.647282105266, 0.8961829422213 };
    double pi = acos(-1), r1 = 1, r2 = 1.8, length = .7;
    double tube = 2 * pi * r1 * length;
    double fin = pi * (r2 * r2 - r1 * r1), open = 2 * pi * r2 * length;
    double to_fin = 0.2905664373995, fin_open = 0.3732069283742;
    double back = to_fin * tube / fin;
    for (size_t k = 0; k < COUNT(expected); k++) {
        struct enclosure bay = { .count = 3 };
        SCOPED_VALUE(exchange) exchange;
        for (size_t i = 0; i < 3; i++) {
            bay.area[i] = i ? fin : tube;
            bay.emissivity[i] = emissivities[k];
            bay.temperature[i] = 400;
        }
        bay.factors[1] = bay.factors[2] = to_fin;
        bay.factors[3] = 1 - 2 * to_fin;
        for (size_t i = 1; i < 3; i++) {
            bay.factors[4 * i] = back;
            bay.factors[4 * i + 3 - i] = 1 - back - fin_open;
            bay.factors[4 * i + 3] = fin_open;
        }
        solve(&bay, &exchange);
        assert_close(-exchange.outside / (open * SIGMA * 2.56e10), expected[k], 1e-9);
    }
}

/* ---- Random cases -------------------------------------------------------------- */

/* Makes symmetric random exchange areas. The area of a surface is the sum of its row,
 * so that its factors sum to 1. */
static void draw(struct enclosure *enclosure, uint64_t *random)
{
    size_t n = enclosure->count = (size_t)xorshift_between(random, 1, MAX);
    double shared[MAX][MAX + 1];
    enclosure->outside = xorshift_real(random, 0, 500);
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j <= i; j++)
            shared[i][j] = shared[j][i] = xorshift(random) % 3
                                              ? xorshift_real(random, 0, 1)
                                              : 0;
        shared[i][n] = xorshift_real(random, .01, 1);
    }
    for (size_t i = 0; i < n; i++) {
        enclosure->area[i] = 0;
        for (size_t j = 0; j <= n; j++)
            enclosure->area[i] += shared[i][j];
        for (size_t j = 0; j <= n; j++)
            enclosure->factors[i * (n + 1) + j] = shared[i][j] / enclosure->area[i];
        enclosure->emissivity[i] = xorshift_between(random, 0, 4)
                                       ? xorshift_real(random, 0, 1)
                                       : (double)xorshift_between(random, 0, 1);
        enclosure->temperature[i] = xorshift_real(random, 0, 2000);
    }
}

/* Computes radiosities by elimination with pivoting. */
static void eliminate(const struct enclosure *enclosure, long double radiosity[MAX])
{
    static long double rows[MAX][MAX + 1];
    size_t n = enclosure->count;
    for (size_t i = 0; i < n; i++) {
        const double *factors = enclosure->factors + i * (n + 1);
        long double e = enclosure->emissivity[i];
        long double t = enclosure->temperature[i], o = enclosure->outside;
        for (size_t j = 0; j < n; j++)
            rows[i][j] = (i == j) - (1 - e) * factors[j];
        rows[i][n] = e * SIGMA * t * t * t * t
                     + (1 - e) * factors[n] * SIGMA * o * o * o * o;
    }
    for (size_t k = 0; k < n; k++) {
        size_t best = k;
        for (size_t i = k; i < n; i++)
            if (fabsl(rows[i][k]) > fabsl(rows[best][k]))
                best = i;
        for (size_t j = 0; j <= n; j++) {
            long double other = rows[k][j];
            rows[k][j] = rows[best][j];
            rows[best][j] = other;
        }
        for (size_t i = 0; i < n; i++) {
            long double times = rows[i][k] / rows[k][k];
            for (size_t j = k; i != k && j <= n; j++)
                rows[i][j] -= times * rows[k][j];
        }
    }
    for (size_t i = 0; i < n; i++)
        radiosity[i] = rows[i][n] / rows[i][i];
}

TEST(enclosures)
{
    uint64_t random = RANDOM_SEED + 17;
    double scale = SIGMA * 1.6e13;
    for (int turn = 0; turn < 40; turn++) {
        struct enclosure enclosure;
        draw(&enclosure, &random);
        size_t n = enclosure.count;
        long double radiosity[MAX], o = enclosure.outside, all = 0;
        long double outside = SIGMA * o * o * o * o, out = 0;
        SCOPED_VALUE(exchange) exchange;
        eliminate(&enclosure, radiosity);
        solve(&enclosure, &exchange);
        for (size_t i = 0; i < n; i++) {
            const double *factors = enclosure.factors + i * (n + 1);
            double area = enclosure.area[i];
            long double meets = factors[n] * outside;
            for (size_t j = 0; j < n; j++)
                meets += factors[j] * radiosity[j];
            out += area * factors[n] * (outside - radiosity[i]);
            all += area;
            assert_close(exchange.radiosity[i], (double)radiosity[i], 1e-9 * scale);
            assert_close(exchange.irradiation[i], (double)meets, 1e-9 * scale);
            assert_close(exchange.flow[i], (double)(area * (radiosity[i] - meets)),
                         1e-9 * scale * area);
            if (enclosure.emissivity[i] == 0)
                assert_close(exchange.flow[i], 0, 1e-9 * scale * area);
        }
        assert_close(exchange.outside, (double)out, 1e-9 * scale * (double)all);
        assert_close(exchange.sum, 0, 1e-12 * scale * (double)all);
    }
}

/* ---- Errors ------------------------------------------------------------------- */

static void refuses(const struct enclosure *enclosure, const char *message)
{
    static const char *const names[] = { "1", "2" };
    struct exchange exchange;
    c205_error error = { "" };
    for (int mode = 0; mode < TRACE_FORMS; mode++) {
        struct exchange_given given = given_of(enclosure, (enum trace_mode)mode);
        given.names = names;
        assert_false(exchange_find(&given, &exchange, &error));
        FAIL_IF(!strstr(error.message, message), "%s: %s", message, error.message);
    }
}

TEST(refused)
{
    const struct enclosure pair = { .count = 2,
                                    .area = { 1, 1 },
                                    .emissivity = { .5, .5 },
                                    .temperature = { 300, 400 },
                                    .factors = { 0, 1, 0, 1, 0, 0 } };
    struct enclosure other = pair;
    other.emissivity[0] = other.emissivity[1] = 0;
    refuses(&other, "the exchange has no solution: surface 2 belongs to a group of "
                    "adiabatic surfaces");
    other = pair;
    other.emissivity[1] = 1.25;
    refuses(&other, "the emissivity 1.25 of surface 2 must be between 0 and 1");
    other.emissivity[1] = NAN;
    refuses(&other, "of surface 2 must be between 0 and 1");
    other = pair;
    other.temperature[0] = NAN;
    refuses(&other, "surface 1 has no temperature");
    other = pair;
    other.area[1] = 0;
    refuses(&other, "surface 2 has no area");
    other = pair;
    other.outside = -1;
    refuses(&other, "the environment has no temperature");
    other.count = 0;
    refuses(&other, "0 surfaces: the number must be between 1 and 4096");
}
