/* test_shape_factors.c - visible areas of solids and shape factors between surfaces,
 * estimated with rays that the machine emits, are compared with closed forms. A biased
 * ray, a repeat that is cut in the wrong place or a row that does not close fails here.
 *
 *     test_shape_factors [SEED]
 */
#include "rt/heat/factors.h"
#include "rt/heat/packet.h"

#include "tests/random.h"
#include "tests/unit/heat_steps.h"
#include "tests/unit/prior_model.h"
#include "tests/unit/scene_reading.h"

static uint64_t seed = 1;

static const struct sampling_options usual = {
    .mode = TRACE_VECTOR, .queue = 2000, .points = 1024, .repeats = 16, .lattice = true
};

static struct factors *begin(const struct scene *scene, struct sampling_options options)
{
    options.seed = seed;
    options.model = prior_model;
    return NON_NULL(factors_new(scene, &options, &failure));
}

static struct factor_row find(const struct factors *factors, size_t primitive)
{
    struct factor_row row;
    uint64_t sum = 0;
    REQUIRE(factors_find(factors, &primitive, 1, &row, &failure));
    for (size_t j = 0; j < row.receivers; j++)
        sum += row.count[j];
    assert_int_equal(sum, row.sent); /* closure */
    return row;
}

/* ---- Areas ------------------------------------------------------------------ */

/* Solids with their areas in massprops.csv. */
static const struct {
    const char *solid;
    double area;
} solids[] = {
    { "difference { box { <-1,-.5,-.25>, <1,.5,.25> }"
      " cylinder { <.4,0,-1>, <.4,0,1>, .3 } }",
      7.37699111843078 },
    { "intersection { cylinder { -2*x, 2*x, 1 } cylinder { -2*y, 2*y, 1 }"
      " cylinder { -2*z, 2*z, 1 } }",
      14.0588745030457 },
    { "merge { sphere { -.5*x, 1 } sphere { .5*x, 1 } }", 18.8495559215388 },
    { "difference { sphere { 0, 1 } cylinder { -2*y, 2*y, .6 } }", 16.0849543863797 },
    { "difference { box { -.5, .5 } box { <-1,-1/6,-1/6>, <1,1/6,1/6> }"
      " box { <-1/6,-1,-1/6>, <1/6,1,1/6> } box { <-1/6,-1/6,-1>, <1/6,1/6,1> } }",
      8 },
    { "torus { 1, .25 rotate 30*x }", 9.86960440108936 },
    /* These shapes cannot emit, so they use lines. */
    { "prism { -1, 1, 4, <-1,-1>, <1,-1>, <1,1>, <-1,1> scale <1,2,.5> }", 28 },
    { "intersection { sphere { 0, 1 } plane { x, .5 } }", 11.7809724509617 },
    { "lathe { 4, <.5,-1>, <1,0>, <.5,1>, <.5,-1> }", 16.8204074037407 },
    { "intersection { quadric { <1,1,0>, 0, 0, -1 } box { -1, 1 } }",
      18.8495559215388 },
};

TEST(areas)
{
    for (size_t k = 0; k < COUNT(solids); k++) {
        SCOPED(scene) *scene = read_scene(solids[k].solid);
        SCOPED(factors) *factors = begin(scene, usual);
        struct estimate sum = { 0, 0 };
        for (size_t i = 0; i < scene->primitive_count; i++) {
            SCOPED_VALUE(factor_row) row = find(factors, i);
            assert_true(row.sent <= row.tried);
            sum.value += row.area.value;
            sum.error = hypot(sum.error, row.area.error);
        }
        assert_estimate(solids[k].solid, sum, solids[k].area);
    }
}

/* A body of triangles radiates outwards, whatever the order of the corners is. */
TEST(meshes)
{
    static const char corners[][20] = { "<1, 1, 1>", "<1, -1, -1>", "<-1, 1, -1>",
                                        "<-1, -1, 1>" };
    struct sampling_options few = usual;
    few.points = 64;
    for (unsigned turned = 0; turned < 16; turned++) {
        char text[600] = "mesh {";
        for (size_t i = 0; i < 4; i++) {
            size_t turn = turned >> i & 1;
            snprintf(text + strlen(text), sizeof text - strlen(text),
                     " triangle { %s, %s, %s }", corners[(i + 1) % 4],
                     corners[(i + 2 + turn) % 4], corners[(i + 3 - turn) % 4]);
        }
        strcat(text, " inside_vector <.2, .9, .1> }");
        SCOPED(scene) *scene = read_scene(text);
        SCOPED(factors) *factors = begin(scene, few);
        SCOPED_VALUE(factor_row) row = find(factors, 0);
        assert_estimate(text, row.area, 8 * sqrt(3));
        assert_int_equal(row.sent, row.tried);
        assert_int_equal(row.count[1], row.sent); /* the body does not see itself */
    }
}

/* ---- Bodies that overlap and touch --------------------------------------------- */

enum { SIDE = 4, BOXES = 5, CROWDS = 6 };

struct grid_box {
    int low[3], high[3];
};

static size_t first_with(const struct grid_box *boxes, const int cell[3])
{
    for (size_t i = 0; i < BOXES; i++) {
        bool inside = true;
        for (int k = 0; k < 3; k++)
            inside = inside && boxes[i].low[k] <= cell[k] && cell[k] < boxes[i].high[k];
        if (inside)
            return i;
    }
    return BOXES;
}

static char *draw_crowd(struct grid_box *boxes, uint64_t *random)
{
    size_t length;
    char *text;
    FILE *file = open_memstream(&text, &length);
    for (size_t i = 0; i < BOXES; i++) {
        for (int k = 0; k < 3; k++) {
            int a = (int)xorshift_between(random, 0, SIDE - 1);
            int b = (int)xorshift_between(random, 0, SIDE - 1);
            boxes[i].low[k] = a < b ? a : b;
            boxes[i].high[k] = (a < b ? b : a) + 1;
        }
        fprintf(file, "box { <%d, %d, %d>, <%d, %d, %d> }\n", boxes[i].low[0],
                boxes[i].low[1], boxes[i].low[2], boxes[i].high[0], boxes[i].high[1],
                boxes[i].high[2]);
    }
    fclose(file);
    return text;
}

TEST(crowds)
{
    uint64_t random = RANDOM_SEED + 23;
    struct sampling_options options = usual;
    options.points = 512;
    for (int crowd = 0; crowd < CROWDS; crowd++) {
        struct grid_box boxes[BOXES];
        double faces[BOXES] = { 0 };
        FREED char *text = draw_crowd(boxes, &random);
        SCOPED(scene) *scene = read_scene(text);
        SCOPED(factors) *factors = begin(scene, options);
        /* Counts the exposed faces of cells, each in the first box that contains it. */
        for (int k = 0; k < SIDE * SIDE * SIDE; k++)
            for (int face = 0; face < 6; face++) {
                const int cell[3] = { k % SIDE, k / SIDE % SIDE, k / SIDE / SIDE };
                int next[3] = { cell[0], cell[1], cell[2] };
                size_t owner = first_with(boxes, cell);
                next[face / 2] += face % 2 ? 1 : -1;
                if (owner < BOXES && first_with(boxes, next) == BOXES)
                    faces[owner]++;
            }
        for (size_t i = 0; i < BOXES; i++) {
            SCOPED_VALUE(factor_row) row = find(factors, i);
            FAIL_IF(fabs(row.area.value - faces[i]) > 8 * row.area.error + 1e-9,
                    "%sbox %zu shows %g +- %g, not %g", text, i + 1, row.area.value,
                    row.area.error, faces[i]);
        }
    }
}

/* ---- Factors ------------------------------------------------------------------ */

/* Factors of viewfactors.csv, with the indices of emitter and receiver in the scene.
 * The index after the last primitive is the environment. */
struct known_factor {
    size_t from, to;
    double factor;
};

/* Squares and discs that see each other, a finned tube's bay, a ball in a shell. */
static const struct {
    const char *text;
    struct known_factor known[6]; /* ends with factor 0 from 0 to 0 */
} known_factors[] = {
    { "mesh { triangle { 0, z, x + z } triangle { 0, x + z, x } }"
      "mesh { triangle { y, x + y + z, y + z } triangle { y, x + y, x + y + z } }",
      { { 0, 1, 0.1998248956984 }, { 1, 0, 0.1998248956984 } } },
    { "mesh { triangle { 0, z, x + z } triangle { 0, x + z, x } }"
      "mesh { triangle { 0, x, x + y } triangle { 0, x + y, y } }",
      { { 0, 1, 0.2000437760754 } } },
    { "disc { 0, y, 1 } disc { .9*y, -y, .6 }", { { 0, 1, 0.1809950221376 } } },
    { "cylinder { 0, .7*y, 1 open } disc { 0, y, 1.8, 1 } disc { .7*y, -y, 1.8, 1 }",
      { { 0, 3, 0.4188671252009 },
        { 0, 1, 0.2905664373995 },
        { 1, 3, 0.3732069283742 },
        { 1, 0, 0.1816040233747 },
        { 1, 2, 0.4451890482511 },
        { 1, 1, 0 } } },
    { "difference { sphere { 0, 3 } sphere { 0, 2 } } sphere { 0, 1 }",
      { { 2, 1, 1 }, { 1, 2, .25 }, { 1, 1, .75 }, { 0, 3, 1 } } },
};

TEST(known_factors)
{
    for (size_t i = 0; i < COUNT(known_factors); i++) {
        const struct known_factor *known = known_factors[i].known;
        SCOPED(scene) *scene = read_scene(known_factors[i].text);
        SCOPED(factors) *factors = begin(scene, usual);
        for (size_t k = 0; k < 6 && (known[k].from || known[k].to); k++) {
            SCOPED_VALUE(factor_row) row = find(factors, known[k].from);
            assert_estimate(known_factors[i].text, row.factor[known[k].to],
                            known[k].factor);
        }
    }
}

/* ---- Bias ------------------------------------------------------------------------ */

enum { SEEDS = 64 };

/* The mean over many seeds is the factor, within its standard error. */
TEST(bias)
{
    SCOPED(scene) *scene = read_scene("disc { 0, y, 1 } disc { .9*y, -y, .6 }");
    struct sampling_options options = usual;
    options.points = 64;
    options.repeats = 2;
    options.model = prior_model;
    for (int lattice = 0; lattice < 2; lattice++) {
        double sum = 0, squares = 0;
        options.lattice = lattice;
        for (options.seed = 1; options.seed <= SEEDS; options.seed++) {
            c205_error error_text = { "" };
            SCOPED(factors) *factors = factors_new(scene, &options, &error_text);
            SCOPED_VALUE(factor_row) row = find(factors, 0);
            sum += row.factor[1].value;
            squares += row.factor[1].value * row.factor[1].value;
        }
        double mean = sum / SEEDS;
        double deviation = sqrt((squares / SEEDS - mean * mean) / (SEEDS - 1));
        FAIL_IF(!(fabs(mean - 0.1809950221376) <= 4 * deviation),
                "the mean of %d seeds is %.7g +- %.2g", SEEDS, mean, deviation);
    }
}

/* ---- Both forms ---------------------------------------------------------------- */

/* Compares the forms and queues for the second primitive. It is a solid that can emit,
 * or a solid that needs lines. */
TEST(forms)
{
    static const char *const texts[] = {
        "difference { box { -1, 1 } cylinder { -2*y, 2*y, .6 } torus { 1, .3 } }"
        "sphere { 0, .4 scale <1, 2, 1> }",
        "intersection { plane { x, .5 }"
        " lathe { 4, <.5,-1>, <1,0>, <.5,1>, <.5,-1> } } sphere { 2*x, .4 }",
    };
    static const size_t queues[] = { 1, 77, 300, 300, 65535 };
    struct sampling_options options = usual;
    options.points = 300;
    options.repeats = 2;
    for (size_t k = 0; k < 2 * COUNT(texts); k++) {
        SCOPED(scene) *scene = read_scene(texts[k / 2]);
        options.mode = TRACE_SCALAR;
        options.lattice = k % 2;
        SCOPED(factors) *factors = begin(scene, options);
        SCOPED_VALUE(factor_row) scalar = find(factors, 1);
        for (size_t i = 0; i < COUNT(queues); i++) {
            struct sampling_options vector = options;
            vector.mode = i == 1 || i == 2 ? TRACE_KERNELS : TRACE_VECTOR;
            vector.queue = queues[i];
            vector.jobs = 2 * i;
            SCOPED(factors) *other = begin(scene, vector);
            SCOPED_VALUE(factor_row) row = find(other, 1);
            assert_true(are_steps(row.clocks, &row.accounts));
            assert_int_equal(row.sent, scalar.sent);
            assert_memory_equal(row.count, scalar.count,
                                row.receivers * sizeof *row.count);
            assert_memory_equal(row.factor, scalar.factor,
                                row.receivers * sizeof *row.factor);
            assert_memory_equal(&row.area, &scalar.area, sizeof row.area);
        }
    }
}

/* ---- Errors ---------------------------------------------------------------------- */

/* A repeat exceeds a vector's length. Its rays do not depend on the division. */
TEST(pieces)
{
    SCOPED(scene) *scene = read_scene("sphere { 0, 1 } box { 1.5, 3 }");
    FREED_BY(packet_programs_end)
    struct packet_programs programs = { .scene = scene, .options = usual };
    const struct emission_options half = { .mode = usual.mode,
                                           .queue = usual.queue,
                                           .points = 32768,
                                           .lattice = usual.lattice,
                                           .model = prior_model };
    uint64_t counts[3] = { 0, 0, 0 };
    programs.options.points = 65536;
    programs.options.repeats = 2;
    programs.options.seed = seed;
    programs.options.model = prior_model;
    SCOPED(factors) *factors = begin(scene, programs.options);
    SCOPED_VALUE(factor_row) row = find(factors, 1);
    assert_true(packet_programs_begin(&programs, &failure));
    struct heat_source *source = NON_NULL(source_new(scene, 1, &half, &failure));
    for (size_t i = 0; i < 4; i++) { /* the halves of two repeats */
        struct packet_choice choice = { 1, i / 2, i % 2 * half.points };
        SCOPED_VALUE(packet) packet;
        assert_true(packet_begin(&packet, &programs));
        assert_true(packet_run(&programs, source, &choice, &packet, &failure));
        assert_int_equal(packet_receivers(&programs), COUNT(counts));
        for (size_t j = 0; j < COUNT(counts); j++)
            counts[j] += (uint64_t)c205_to_integer(packet.counts[j]);
    }
    source_free(source);
    assert_int_equal(row.tried, 2 * 65536);
    assert_int_equal(row.receivers, 3);
    assert_memory_equal(row.count, counts, sizeof counts);
    assert_estimate("six faces", row.area, 6 * 1.5 * 1.5);
}

TEST(refused)
{
    struct sampling_options options = usual;
    SCOPED(scene) *scene = read_scene("plane { y, 0 } sphere { 0, 1 }");
    SCOPED(factors) *factors = begin(scene, usual);
    struct factor_row row;
    assert_false(factors_find(factors, &(size_t){ 0 }, 1, &row, &failure));
    assert_non_null(strstr(failure.message, "a plane is infinite"));
    options.repeats = 1;
    options.model = prior_model;
    assert_null(factors_new(scene, &options, &failure));
    assert_non_null(strstr(failure.message, "at least 2 repeats"));
    options.repeats = 2;
    options.points = MAX_FACTORS_POINTS + 1;
    assert_null(factors_new(scene, &options, &failure));
    assert_non_null(strstr(failure.message, "1048576"));
}

ARGUMENTS(argc, argv)
{
    seed = argument(argc, argv, 1, seed);
}
