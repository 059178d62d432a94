/* test_sample_points.c - the machine's random stream and lattice are compared with
 * their definitions, in both forms and in pieces, and estimates from them with
 * integrals. A wrong word, or points that are not uniform, fail here.
 *
 *     test_sample_points [TRIES [SEED]]
 */
#include <math.h>

#include "tests/oracle/points.h"
#include "tests/unit/draw.h"
#include "tests/unit/unit.h"

enum { MAX_POINTS = 65535, MAX_WORDS = MAX_POINTS * LATTICE_COORDINATES };

static size_t tries = 40;
static c205_word words[POINT_FORMS][MAX_WORDS];

/* Returns a random integer. Its number of bits is uniform, and at least 1. */
static uint64_t some_integer(unsigned bits)
{
    return xorshift(&random_state) >> count_between(64 - bits, 63);
}

static size_t some_length(void)
{
    return (size_t)(1 + some_integer(16) % MAX_POINTS);
}

static void make(const struct point_kind *kind, const struct point_choice *choice,
                 c205_word *into)
{
    SCOPED(point_maker) *maker = point_maker_new(kind, &failure);
    REQUIRE(maker && point_maker_run(maker, choice, into, &failure));
}

/* ---- Comparison with the definition ------------------------------------- */

/* Positions are compared with a generator that is stepped one by one. */
TEST(positions)
{
    uint64_t x = 1;
    for (uint64_t p = 0; p < 10000; p++) {
        assert_int_equal(stream_state_at(p), x);
        x = (x * UINT64_C(44485709377909)) % (UINT64_C(1) << 47);
    }
    assert_int_equal(stream_state_at(UINT64_C(1) << 45), 1);
    assert_int_not_equal(stream_state_at(UINT64_C(1) << 44), 1);
}

static int by_size(const void *a, const void *b)
{
    uint64_t first = *(const uint64_t *)a, second = *(const uint64_t *)b;
    return (first > second) - (first < second);
}

/* The two closest of consecutive seeds are far apart in the stream. */
TEST(seeds)
{
    enum { SEEDS = 100000 };
    static const uint64_t period = UINT64_C(1) << 45;
    static uint64_t begin[SEEDS + 1];
    uint64_t first = some_integer(40);
    for (size_t i = 0; i < SEEDS; i++)
        begin[i] = stream_position(first + i, 0, 0) % period;
    qsort(begin, SEEDS, sizeof *begin, by_size);
    begin[SEEDS] = begin[0] + period;
    for (size_t i = 0; i < SEEDS; i++)
        assert_true((double)(begin[i + 1] - begin[i]) > (double)period / 2.7 / SEEDS);
}

static struct point_kind some_kind(bool lattice)

{
    return (struct point_kind){
        .lattice = lattice,
        .queue = some_length(),
        .points = some_length(),
        .coordinates = lattice ? count_between(1, LATTICE_COORDINATES) : STREAM_DRAWS,
    };
}

static struct point_choice some_choice(bool lattice, size_t points)
{
    uint64_t m = count_between(0, 20);
    if (!lattice)
        return (struct point_choice){ .seed = some_integer(45),
                                      .first = some_integer(43) };
    return (struct point_choice){ .seed = some_integer(45),
                                  .first = some_integer(30) % (1048577 - points),
                                  .m = m,
                                  .shift = some_integer(20) };
}

static uint64_t defined(const struct point_kind *kind,
                        const struct point_choice *choice, size_t i, unsigned j)
{
    return kind->lattice ? lattice_word((unsigned)choice->m, choice->seed,
                                        choice->shift, choice->first + i, j)
                         : stream_word(choice->seed, choice->first + i, j);
}

static void compare_words(const struct point_kind *kind,
                          const struct point_choice *choice)
{
    const c205_word *made = words[kind->form];
    for (unsigned j = 0; j < kind->coordinates; j++)
        for (size_t i = 0; i < kind->points; i++) {
            c205_word word = made[j * kind->points + i];
            FAIL_IF(word != defined(kind, choice, i, j),
                    "form %d, queue %zu, seed %llu, m %d, shift %llu: "
                    "coordinate %u of point %llu + %zu is %llX",
                    kind->form, kind->queue, (unsigned long long)choice->seed,
                    (int)choice->m, (unsigned long long)choice->shift, j,
                    (unsigned long long)choice->first, i, (unsigned long long)word);
        }
}

static void compare_forms(bool lattice)
{
    for (size_t i = 0; i < tries; i++) {
        struct point_kind kind = some_kind(lattice);
        struct point_choice choice = some_choice(lattice, kind.points);
        for (int form = 0; form < POINT_FORMS; form++) {
            kind.form = (enum point_form)form;
            make(&kind, &choice, words[form]);
            compare_words(&kind, &choice);
        }
    }
}

TEST_CALL(stream_words, compare_forms(false))
TEST_CALL(lattice_words, compare_forms(true))

/* Numbers are exactly t 2^-47, normalised, and neither 0 nor 1. */
static void compare_numbers(bool lattice)
{
    for (size_t i = 0; i < tries / 4; i++) {
        struct point_kind kind = some_kind(lattice);
        struct point_choice choice = some_choice(lattice, kind.points);
        size_t count = kind.points * kind.coordinates;
        kind.numbers = true;
        for (int form = 0; form < POINT_FORMS; form++) {
            kind.form = (enum point_form)form;
            make(&kind, &choice, words[form]);
        }
        assert_memory_equal(words[POINTS_SCALAR], words[POINTS_VECTOR],
                            count * sizeof **words);
        for (size_t k = 0; k < count; k++) {
            double number = c205_to_double(words[POINTS_VECTOR][k]);
            uint64_t word = defined(&kind, &choice, k % kind.points,
                                    (unsigned)(k / kind.points));
            assert_true(number == (double)word * 0x1p-47);
            assert_true(number > 0 && number < 1);
            assert_int_equal(words[POINTS_VECTOR][k], c205_from_double(number));
        }
    }
}

TEST_CALL(stream_numbers, compare_numbers(false))
TEST_CALL(lattice_numbers, compare_numbers(true))

/* ---- Cuts ---------------------------------------------------------------- */

/* Points in two calls, with other queue lengths, must equal the points in one call. */
static void compare_cut(bool lattice)
{
    struct point_kind kind = some_kind(lattice);
    size_t points, pieces[2];
    const c205_word *whole = words[POINTS_SCALAR];
    c205_word *piece = words[POINTS_VECTOR];
    kind.form = POINTS_VECTOR;
    kind.points = points = count_between(2, 5000);
    struct point_choice choice = some_choice(lattice, points);
    make(&kind, &choice, words[POINTS_SCALAR]);
    pieces[0] = count_between(1, points - 1);
    pieces[1] = points - pieces[0];
    for (size_t k = 0, begin = 0; k < 2; begin += pieces[k++]) {
        kind.points = pieces[k];
        kind.queue = count_between(1, points);
        make(&kind, &choice, piece);
        for (size_t j = 0; j < kind.coordinates; j++)
            assert_memory_equal(piece + j * pieces[k], whole + j * points + begin,
                                pieces[k] * sizeof *piece);
        choice.first += pieces[k];
    }
}

TEST(cuts)
{
    for (size_t i = 0; i < tries; i++)
        compare_cut(i % 2);
}

/* ---- Integration ---------------------------------------------------------- */

/* In each coordinate, each of N cells contains exactly one of N points. */
TEST(cells)
{
    enum { LOG = 12, CELLS = 1 << LOG };
    static const struct point_kind kind = { .form = POINTS_VECTOR,
                                            .lattice = true,
                                            .queue = CELLS,
                                            .points = CELLS,
                                            .coordinates = LATTICE_COORDINATES };
    struct point_choice choice = { .seed = 7, .m = LOG };
    make(&kind, &choice, words[0]);
    for (size_t j = 0; j < LATTICE_COORDINATES; j++) {
        static bool met[CELLS];
        memset(met, 0, sizeof met);
        for (size_t i = 0; i < CELLS; i++) {
            c205_word word = words[0][j * CELLS + i];
            assert_true(word % 2 == 1);
            assert_false(met[word >> (47 - LOG)]);
            met[word >> (47 - LOG)] = true;
        }
    }
}

enum { M = 10, N = 1 << M, SHIFTS = 16, DIMENSIONS = 4 };

/* Returns the product of 1 + (u_j - 1/2) over the first coordinates, as the mean over
 * all points. Its integral is 1. The function is smooth and not periodic. */
static double mean_of_function(const c205_word *point)
{
    double sum = 0;
    for (size_t i = 0; i < N; i++) {
        double product = 1;
        for (size_t j = 0; j < DIMENSIONS; j++)
            product *= .5 + c205_to_double(point[j * N + i]);
        sum += product;
    }
    return sum / N;
}

struct estimate {
    double mean, error; /* error: the standard error of the mean */
};

/* Estimates the mean from SHIFTS independent sets of points. */
static struct estimate estimate(struct point_maker *maker, bool lattice, uint64_t seed)
{
    double value[SHIFTS], sum = 0, squares = 0;
    for (uint64_t k = 0; k < SHIFTS; k++) {
        struct point_choice choice = {
            .seed = seed, .first = lattice ? 0 : k * N, .m = M, .shift = k
        };
        REQUIRE(point_maker_run(maker, &choice, words[0], &failure));
        value[k] = mean_of_function(words[0]);
        sum += value[k];
    }
    for (size_t k = 0; k < SHIFTS; k++)
        squares += pow(value[k] - sum / SHIFTS, 2);
    return (struct estimate){ sum / SHIFTS, sqrt(squares / (SHIFTS - 1) / SHIFTS) };
}

/* Properties over many seeds: the root mean square error, the fraction of Student's 95
 * % intervals that contain the exact value, and the mean error in standard errors. */
struct quality {
    double error, covered, bias;
};

static struct quality try_seeds(bool lattice, size_t seeds)
{
    static const double student = 2.1314; /* 97.5 % quantile for 15 degrees of
                                           * freedom */
    const struct point_kind kind = { .form = POINTS_VECTOR,
                                     .lattice = lattice,
                                     .numbers = true,
                                     .queue = N,
                                     .points = N,
                                     .coordinates = STREAM_DRAWS };
    double squares = 0, sum = 0, covered = 0;
    SCOPED(point_maker) *maker = NON_NULL(point_maker_new(&kind, &failure));
    for (size_t seed = 0; seed < seeds; seed++) {
        struct estimate found = estimate(maker, lattice, seed);
        double off = found.mean - 1;
        sum += off;
        squares += off * off;
        covered += fabs(off) <= student * found.error;
    }
    return (struct quality){ sqrt(squares / (double)seeds), covered / (double)seeds,
                             sum / sqrt(squares) };
}

static void print_quality(const char *points, struct quality quality)
{
    print_message("%-7s  %.6f  %9.1f  %5.2f\n", points, quality.error,
                  100 * quality.covered, quality.bias);
}

TEST(quality)
{
    enum { SEEDS = 400 };
    struct quality lattice = try_seeds(true, SEEDS);
    struct quality random = try_seeds(false, SEEDS);
    double spread = sqrt(.95 * .05 / SEEDS);
    print_message("points   error     covered %%  bias\n");
    print_quality("lattice", lattice);
    print_quality("random", random);
    assert_true(lattice.error < random.error / 5);
    assert_true(fabs(lattice.covered - .95) < 3 * spread);
    assert_true(fabs(random.covered - .95) < 3 * spread);
    assert_true(fabs(lattice.bias) < 3 && fabs(random.bias) < 3);
}

COUNT_AND_SEED(tries, random_state);
