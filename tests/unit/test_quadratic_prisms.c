/* Prisms of quadratic splines: both forms of the tracer agree with each other and
 * the plain tracer, for paths of any loops, alone and in solids, and meet them
 * where geometry says.
 *
 *     test_quadratic_prisms [SCENES [SEED]]
 */
#define MIDDLING_FRAMES
#include "tests/unit/random_solids.h"

#include "rt/shapes/shape_words.h"
#include "tests/oracle/plain_shapes.h"

static size_t scene_count = 4; /* of each sort */

/* ---- Paths --------------------------------------------------------------- */

enum { CORNERS_MOST = 9 };

/* The last corner once more before the first, as a smooth loop has it. */
static size_t add_corners(char *text, size_t size,
                          double corners[CORNERS_MOST][2], size_t count)
{
    add_text(text, size, ", <%.6f, %.6f>", corners[count - 1][0],
             corners[count - 1][1]);
    for (size_t i = 0; i <= count; i++)
        add_text(text, size, ", <%.6f, %.6f>", corners[i % count][0],
                 corners[i % count][1]);
    return count + 2;
}

/* Round a point; now and then the last corner stands twice, or one on the way
 * from it to the first. */
static size_t add_loop(char *text, size_t size, double x, double z,
                       double reach)
{
    double corners[CORNERS_MOST][2];
    size_t count = 3 + below(5);

    for (size_t i = 0; i < count; i++) {
        double angle = 2 * acos(-1) * ((double)i + between(-.3, .3))
                       / (double)count;
        double radius = reach * between(.4, 1);

        corners[i][0] = x + radius * cos(angle);
        corners[i][1] = z + radius * sin(angle);
    }
    if (below(4) == 0) {
        memcpy(corners[count], corners[count - 1], sizeof *corners);
        count++;
    }
    if (below(4) == 0) {
        for (int k = 0; k < 2; k++)
            corners[count][k] = .3 * corners[count - 1][k]
                                + .7 * corners[0][k];
        count++;
    }
    return add_corners(text, size, corners, count);
}

/* Corners anywhere. */
static size_t add_tangle(char *text, size_t size)
{
    double corners[CORNERS_MOST][2];
    size_t count = 3 + below(CORNERS_MOST - 2);

    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 2; k++)
            corners[i][k] = between(-1, 1);
    return add_corners(text, size, corners, count);
}

static void add_any_prism(char *text, size_t size, bool tangles)
{
    char path[4000] = "";
    size_t count = 0;

    if (tangles && below(4) == 0)
        for (size_t loops = 1 + below(2); loops > 0; loops--)
            count += add_tangle(path, sizeof path);
    else
        for (size_t loops = 1 + below(3); loops > 0; loops--)
            count += add_loop(path, sizeof path, between(-.4, .4),
                              between(-.4, .4), between(.3, 1));
    add_text(text, size, "prism { quadratic_spline %s%.4f, %.4f, %zu%s %s ",
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
        check_solids_with(add_plain_prism);
    }
}

/* ---- What geometry says -------------------------------------------------- */

/* Of four corners: from <-1, -1> to <1, -1> the points are
 * <w^2 + w - 1, w^2 - w - 1>. */
#define SQUARE "6, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>"
#define PRISM "prism { quadratic_spline "

TEST(middle)
{
    double w = (1 + sqrt(.6)) / 2; /* w^2 - w = -.1 */

    check_middle(AHEAD PRISM "-1, 1, " SQUARE " }", 1, 6 - sqrt(5));
    check_middle(AHEAD PRISM "1, -1, " SQUARE " open }", 1, 6 - sqrt(5));
    check_middle(AHEAD PRISM "-1, 1, " SQUARE " translate -5*z }", 1,
                 sqrt(5) - 1);
    check_middle(AHEAD PRISM "1, 2, " SQUARE " }", 0, 0);
    /* along its axis */
    check_middle(AHEAD PRISM "-3, 1, " SQUARE " rotate 90*x }", 1, 2);
    check_middle(AHEAD PRISM "-3, 1, " SQUARE " open rotate 90*x }", 0, 0);
    check_middle(AHEAD PRISM "-3, 1, " SQUARE
                             " rotate 90*x translate 1.1*y }",
                 1, 2);
    /* through a corner */
    check_middle(AHEAD PRISM "-1, 1, " SQUARE " translate x }", 1, 4);
    /* in solids */
    check_middle(AHEAD "intersection { " PRISM "-1, 1, " SQUARE
                       " } plane { -z, 1.1 } }",
                 2, 3.9);
    check_middle(AHEAD "difference { " PRISM "-1, 1, " SQUARE
                       " } sphere { -z, .5 } }",
                 2, 4.5);
    /* twice through one edge */
    check_middle(AHEAD PRISM "-1, 1, " SQUARE " translate 1.1*x }", 1,
                 6 - w - w * w);
    check_middle(AHEAD "intersection { " PRISM "-1, 1, " SQUARE
                       " translate 1.1*x } plane { -z, 0 } }",
                 2, 5);
}

/* ---- How many segments a ray has ----------------------------------------- */

static size_t segments_of(const char *path)
{
    char text[2000];
    struct shape_words words;
    struct scene *scene;

    snprintf(text, sizeof text, PRISM "0, 1, %s }", path);
    scene = read_text(text);
    shape_words(scene->primitives, &words);
    assert_int_equal(shape_table_count(scene->primitives, NULL) % 16, 0);
    scene_free(scene);
    return words.segments;
}

TEST(segments)
{
    assert_int_equal(segments_of(SQUARE), 1);
    assert_int_equal(segments_of("12, <-2, 2>, <-2, -2>, <2, -2>, <2, 2>,"
                                 " <-2, 2>, <-2, -2>, <-1, 1>, <-1, -1>,"
                                 " <1, -1>, <1, 1>, <-1, 1>, <-1, -1>"),
                     2);
    /* a dent */
    assert_int_equal(segments_of("6, <1, .3>, <0, -1>, <3, 0>, <0, 1>,"
                                 " <1.5, 0>, <0, -1>"),
                     2);
}

static void check_crossings(const struct primitive *prism)
{
    struct shape_words words;

    shape_words(prism, &words);
    for (int try = 0; try < 60; try++) {
        struct crossing crossings[MOST_CROSSINGS];
        struct ray ray;

        for (int k = 0; k < 3; k++) {
            ray.origin[k] = between(-.5, .5);
            ray.direction[k] = between(-1, 1);
        }
        assert_true(plain_crossings(prism, &ray, crossings)
                    <= 2 * words.segments);
    }
}

/* ---- The table ----------------------------------------------------------- */

enum {
    BEGINS = 2,
    BEND = 3,
    LEAD = 5,
    FOOT = 7,
    BOW = 9,
    WAY = 11,
    SHARE = 13,
    OUTWARD = 15
};

/* At w, by the numbers of the crossings; the normal by those of normals, which
 * find it by the point. */
static void check_point(const struct primitive *prism, const double *corner,
                        const double *row, double w, bool tangled)
{
    double point[2], normal[2], share = 0, outside[3] = { 0 };
    double inside[3] = { 0 }, length;

    for (int k = 0; k < 2; k++) {
        point[k] = corner[k] + (row[BEND + k] * w + 2 * row[LEAD + k]) * w;
        share += row[SHARE + k] * (point[k] - row[FOOT + k]);
    }
    assert_true(share > -1e-6 && share < 1 + 1e-6);
    for (int k = 0; k < 2; k++)
        assert_true(fabs(row[FOOT + k]
                         + (row[BOW + k] * share + row[WAY + k]) * share
                         - point[k])
                    < 1e-6);
    normal[0] = (2 * row[BOW + 1] * share + row[WAY + 1]) * row[OUTWARD];
    normal[1] = -(2 * row[BOW] * share + row[WAY]) * row[OUTWARD];
    length = hypot(normal[0], normal[1]);
    for (int k = 0; k < 2; k++) {
        outside[2 * k] = point[k] + 1e-6 * normal[k] / length;
        inside[2 * k] = point[k] - 1e-6 * normal[k] / length;
    }
    if (tangled || length < 1e-3)
        return;
    assert_true(plain_encloses(prism, inside));
    assert_false(plain_encloses(prism, outside));
}

static void check_table(const struct primitive *prism, bool tangled)
{
    size_t count = shape_table_count(prism, NULL);
    double *table = shape_table(prism, NULL, count);

    assert_non_null(table);
    for (double *row = table; row < table + count; row += 16)
        if (row[BEGINS] == 0)
            for (double w = .1; w < 1; w += .2)
                check_point(prism, row - 16, row, w, tangled);
    free(table);
}

TEST(paths)
{
    char text[8000];

    for (int try = 0; try < 300; try++) {
        struct scene *scene;

        strcpy(text, "");
        add_any_prism(text, sizeof text, true);
        add_text(text, sizeof text, "}");
        scene = read_text(text);
        check_crossings(scene->primitives);
        check_table(scene->primitives, true);
        scene_free(scene);
    }
}

/* The normals of what does not cross itself lead from inside to outside; at the
 * end, what does: straight edges that go on beyond their ends. */
TEST(normals)
{
    static const char *const paths[] = {
        SQUARE,
        "12, <.2, -1>, <.2, .2>, <1, -.2>, <1, .2>, <.2, 1>, <-.2, 1>,"
        " <-1, .2>, <-1, -.2>, <-.2, .2>, <-.2, -1>, <.2, -1>, <.2, .2>",
        "11, <0, -2>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>,"
        " <0, -1>, <-.5, -.5>, <.5, -.5>, <0, .5>, <-.5, -.5>",
        "7, <-3, 0>, <0, 0>, <1, 0>, <1.2, 0>, <.6, .9>, <.6, .9>, <0, 0>",
    };
    size_t count = sizeof paths / sizeof *paths;

    for (size_t i = 0; i < count; i++) {
        char text[1000];
        struct scene *scene;

        snprintf(text, sizeof text, PRISM "-1, 1, %s }", paths[i]);
        scene = read_text(text);
        check_table(scene->primitives, i + 1 == count);
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
