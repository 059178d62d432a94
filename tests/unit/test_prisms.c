/* Prisms: both forms of the tracer agree with each other and the plain tracer,
 * for paths of any loops, alone and in solids, and meet them where geometry
 * says.
 *
 *     test_prisms [SCENES [SEED]]
 */
#define MIDDLING_FRAMES
#include "tests/unit/random_solids.h"

#include "rt/shapes/shape_words.h"
#include "tests/oracle/plain_shapes.h"

static size_t scene_count = 4; /* of each sort */

/* ---- Paths --------------------------------------------------------------- */

/* A loop round a point, its corners at rising angles: it does not cross
 * itself. */
static size_t add_loop(char *text, size_t size, double x, double z,
                       double reach)
{
    size_t corners = 3 + below(8);

    for (size_t i = 0; i <= corners; i++) {
        static double first[2];
        double angle = 2 * acos(-1) * ((double)i + between(-.3, .3))
                       / (double)corners;
        double radius = reach * between(.3, 1);
        double point[2] = { x + radius * cos(angle),
                            z + radius * sin(angle) };

        if (i == 0)
            memcpy(first, point, sizeof first);
        if (i == corners)
            memcpy(point, first, sizeof first);
        add_text(text, size, ", <%.6f, %.6f>", point[0], point[1]);
    }
    return corners + 1;
}

/* Corners anywhere. */
static size_t add_tangle(char *text, size_t size)
{
    size_t corners = 3 + below(9);

    for (size_t i = 0; i < corners; i++)
        add_text(text, size, ", <%.6f, %.6f>", between(-1, 1),
                 between(-1, 1));
    return corners;
}

/* As many teeth as no three segments of a ray would do for. */
static size_t add_comb(char *text, size_t size)
{
    size_t teeth = 2 + below(10);
    double step = 2. / (double)teeth, depth = between(-.4, .6);

    add_text(text, size, ", <-1, -.7>");
    for (size_t i = 0; i < teeth; i++) {
        double x = -1 + step * (double)i;

        add_text(text, size,
                 ", <%.6f, .7>, <%.6f, .7>, <%.6f, %.6f>, <%.6f, %.6f>", x,
                 x + .5 * step, x + .6 * step, -depth, x + step, -depth);
    }
    add_text(text, size, ", <1, -.7>");
    return 4 * teeth + 2;
}

static void add_any_prism(char *text, size_t size, bool tangles)
{
    char path[4000] = "";
    size_t count = 0, sort = below(3 + tangles);

    if (sort == 3)
        count = add_tangle(path, sizeof path);
    else if (sort == 2)
        count = add_comb(path, sizeof path);
    else
        for (size_t loops = 1 + below(3); loops > 0; loops--)
            count += add_loop(path, sizeof path, between(-.4, .4),
                              between(-.4, .4), between(.3, 1));
    add_text(text, size, "prism { %s%.4f, %.4f, %zu%s %s ",
             below(2) ? "linear_sweep " : "", between(-.8, -.1),
             between(.1, .8), count, path, below(4) ? "" : "open");
}

static void add_tangled_prism(char *text, size_t size)
{
    add_any_prism(text, size, true);
    add_turn(text, size, 1.6);
}

TEST(random_scenes)
{
    check_random_scenes(add_tangled_prism, scene_count);
}

/* ---- Solids -------------------------------------------------------------- */

static void add_plain_prism(char *text, size_t size)
{
    add_any_prism(text, size, false);
}

TEST(solids)
{
    for (size_t i = 0; i < 2 * scene_count; i++) {
        solids.clear = i % 2;
        check_solids_with(add_plain_prism);
    }
}

/* ---- What geometry says -------------------------------------------------- */

#define SQUARE "4, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>"
#define HOLED \
    "10, <-2, -2>, <2, -2>, <2, 2>, <-2, 2>, <-2, -2>," \
    " <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>"

TEST(middle)
{
    check_middle(AHEAD "prism { -1, 1, " SQUARE " }", 1, 4);
    check_middle(AHEAD "prism { 1, -1, " SQUARE " }", 1, 4);
    check_middle(AHEAD "prism { 1, 2, " SQUARE " }", 0, 0);
    check_middle(AHEAD "prism { -1, 1, " SQUARE " translate -5*z }", 1, 1);
    check_middle(AHEAD "prism { -1, 1, " HOLED " translate -5*z }", 1, 1);
    check_middle(AHEAD "prism { -1, 1, " HOLED " open scale <1, 1, 2> }", 1,
                 1);
    check_middle(AHEAD "prism { -1, 1, 3, <-1, -2>, <1, -2>, <0, 4> }", 1, 3);
    /* along its axis */
    check_middle(AHEAD "prism { -3, 1, " SQUARE " rotate 90*x }", 1, 2);
    check_middle(AHEAD "prism { -3, 1, " SQUARE " open rotate 90*x }", 0, 0);
    check_middle(AHEAD "prism { -3, 1, " HOLED " rotate 90*x }", 0, 0);
    check_middle(AHEAD "prism { -3, 1, " HOLED
                       " rotate 90*x translate 1.5*y }",
                 1, 2);
    /* in solids */
    check_middle(AHEAD "intersection { prism { -3, 1, " SQUARE
                       " rotate 90*x } plane { -z, 1 } }",
                 2, 4);
    check_middle(AHEAD "difference { sphere { 0, 3 } prism { -4, 4, " SQUARE
                       " rotate 90*x } }",
                 0, 0);
    check_middle(AHEAD "difference { prism { -1, 1, " HOLED
                       " } plane { z, 0 } }",
                 1, 6);
}

/* ---- How many segments a ray has ----------------------------------------- */

static size_t segments_of(const char *path)
{
    char text[2000];
    struct shape_words words;
    struct scene *scene;

    snprintf(text, sizeof text, "prism { 0, 1, %s }", path);
    scene = read_text(text);
    shape_words(scene->primitives, &words);
    assert_int_equal(shape_table_count(scene->primitives, NULL) % 8, 0);
    scene_free(scene);
    return words.segments;
}

TEST(segments)
{
    char circle[2000] = "48";

    assert_int_equal(segments_of("3, <0, 0>, <1, 0>, <0, 1>"), 1);
    assert_int_equal(segments_of(SQUARE), 1);
    assert_int_equal(segments_of(HOLED), 2);
    /* a dent, a Z, a staircase */
    assert_int_equal(segments_of("4, <0, 0>, <2, 1>, <0, 2>, <1, 1>"), 2);
    assert_int_equal(segments_of("6, <0, 0>, <2, 0>, <1, 2>, <2, 2>, <2, 3>,"
                                 " <0, 3>"),
                     2);
    assert_int_equal(segments_of("8, <0, 0>, <1, 0>, <1, 1>, <2, 1>, <2, 2>,"
                                 " <3, 2>, <3, 3>, <0, 3>"),
                     3);
    for (int i = 0; i < 48; i++)
        add_text(circle, sizeof circle, ", <%.9f, %.9f>",
                 cos(i * acos(-1) / 24), sin(i * acos(-1) / 24));
    assert_int_equal(segments_of(circle), 1);
}

/* ---- Normals ------------------------------------------------------------- */

/* The normal of each edge leads from inside to outside. */
static void check_normals(const struct primitive *prism)
{
    size_t count = shape_table_count(prism, NULL);
    double *table = shape_table(prism, NULL, count);

    assert_non_null(table);
    for (double *row = table; row < table + count; row += 8) {
        double outside[3], inside[3];

        if (row[2] == 1)
            continue;
        for (int k = 0; k < 2; k++) {
            double middle = row[k] + row[3 + k] * row[5] / 2;

            outside[2 * k] = middle + 1e-7 * row[6 + k];
            inside[2 * k] = middle - 1e-7 * row[6 + k];
        }
        outside[1] = inside[1] = 0;
        assert_true(plain_encloses(prism, inside));
        assert_false(plain_encloses(prism, outside));
    }
    free(table);
}

TEST(normals)
{
    char text[8000];

    for (int try = 0; try < 300; try++) {
        struct scene *scene;

        strcpy(text, "");
        add_any_prism(text, sizeof text, try % 2);
        add_text(text, sizeof text, "}");
        scene = read_text(text);
        check_normals(scene->primitives);
        scene_free(scene);
    }
}

ARGUMENTS(argc, argv)
{
    if (argc > 1)
        scene_count = strtoul(argv[1], NULL, 10);
    if (argc > 2)
        traced.random ^= strtoull(argv[2], NULL, 10) << 13;
}

GROUP(set_up_frames, tear_down_model);
