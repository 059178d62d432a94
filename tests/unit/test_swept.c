/* test_swept.c - prisms, prisms of quadratic splines and lathes, which sweep a path.
 * Both forms of the tracer are compared with each other and with the plain tracer, on
 * random paths, alone and in solids. The tables of the kernels are compared with the
 * plain shapes. A wrong row of a table, a normal that points inside, or too few
 * segments for the crossings of a ray fail here.
 *
 *     test_swept [SCENES [SEED]]
 */
#define MIDDLING_FRAMES
#include "tests/unit/swept_shapes.h"

#include "rt/shapes/shape_words.h"
#include "tests/oracle/plain_shapes.h"

static size_t scene_count = 10; /* number of scenes of each kind; make check uses a
                                 * third */

/* ---- Normals ------------------------------------------------------------- */

/* The normal of each edge points from inside to outside. */
static void check_prism(const struct primitive *prism, bool tangled UNUSED)
{
    size_t count = shape_table_count(prism, NULL);
    FREED double *table = NON_NULL(shape_table(prism, NULL, count));
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
}

/* A row of a quadratic prism's table. */
struct parabola {
    double corner[2], begins, bend[2], lead[2], foot[2], bow[2], way[2], share[2];
    double outward;
};

/* Computes a point at w from the words of the crossings, and its normal from the words
 * of normals, which depend on the point. */
static void check_point(const struct primitive *prism, const struct parabola *row,
                        double w, bool tangled)
{
    double point[2], normal[2], share = 0, outside[3] = { 0 };
    double inside[3] = { 0 };
    for (int k = 0; k < 2; k++) {
        point[k] = row[-1].corner[k] + (row->bend[k] * w + 2 * row->lead[k]) * w;
        share += row->share[k] * (point[k] - row->foot[k]);
    }
    assert_true(share > -1e-6 && share < 1 + 1e-6);
    for (int k = 0; k < 2; k++)
        assert_true(
            fabs(row->foot[k] + (row->bow[k] * share + row->way[k]) * share - point[k])
            < 1e-6);
    normal[0] = (2 * row->bow[1] * share + row->way[1]) * row->outward;
    normal[1] = -(2 * row->bow[0] * share + row->way[0]) * row->outward;
    double length = hypot(normal[0], normal[1]);
    for (int k = 0; k < 2; k++) {
        outside[2 * k] = point[k] + 1e-6 * normal[k] / length;
        inside[2 * k] = point[k] - 1e-6 * normal[k] / length;
    }
    if (tangled || length < 1e-3)
        return;
    assert_true(plain_encloses(prism, inside));
    assert_false(plain_encloses(prism, outside));
}

static void check_quadratic_prism(const struct primitive *prism, bool tangled)
{
    size_t count = shape_table_count(prism, NULL);
    FREED double *table = NON_NULL(shape_table(prism, NULL, count));
    const struct parabola *rows = (const struct parabola *)table;
    for (size_t i = 0; i < count / 16; i++)
        if (rows[i].begins == 0)
            for (double w = .1; w < 1; w += .2)
                check_point(prism, &rows[i], w, tangled);
}

enum { HEIGHT_WORD = 1, BEGINS_WORD = 2, RADIUS_WORD = 10 };

static bool is_closed(const struct primitive *lathe)
{
    const struct outline *path = &lathe->shape.lathe.path;
    const double *first = path->points[0];
    const double *last = path->points[path->count - 1];
    return (first[0] == 0 && last[0] == 0)
           || (first[0] == last[0] && first[1] == last[1]);
}

/* Normals of segments point outside. In an open lathe both sides may be outside. */
static void check_lathe(const struct primitive *lathe, bool tangled UNUSED)
{
    size_t count = shape_table_count(lathe, NULL);
    FREED double *table = NON_NULL(shape_table(lathe, NULL, count));
    struct shape_words words;
    shape_words(lathe, &words);
    for (double *row = table; row < table + 16 * (size_t)words.words[3]; row += 16) {
        double outside[3] = { 0 }, inside[3] = { 0 };
        if (row[BEGINS_WORD] == 1)
            continue;
        for (int k = 0; k < 2; k++) {
            double corner = k ? words.words[0] + row[HEIGHT_WORD] : row[RADIUS_WORD];
            double middle = corner + row[11 + k] * row[13] / 2;
            outside[k] = middle + 1e-7 * row[14 + k];
            inside[k] = middle - 1e-7 * row[14 + k];
        }
        if (inside[0] < 1e-6)
            continue;
        assert_true(plain_encloses(lathe, inside) || !is_closed(lathe));
        assert_false(plain_encloses(lathe, outside));
    }
}

/* ---- The shapes ---------------------------------------------------------- */

struct swept {
    const char *begin;
    size_t row_words; /* number of words in a row of the table */
    void (*add)(char *text, size_t size, bool tangles);
    double larger;
    double reach; /* distance of the origins of rays */
    /* Checks the rows of the table. */
    void (*check)(const struct primitive *shape, bool tangled);
};

static const struct swept
    prism = { "prism { 0, 1, ", 8, add_prism, 1.6, .5, check_prism },
    quadratic = { "prism { quadratic_spline 0, 1, ",
                  16,
                  add_quadratic_prism,
                  1.6,
                  .5,
                  check_quadratic_prism },
    lathe = { "lathe { ", 16, add_lathe, 1.4, 1, check_lathe };

static const struct swept *const all[] = { &prism, &quadratic, &lathe };
static const struct swept *swept; /* the current shape */

static void add_tangled(char *text, size_t size)
{
    swept->add(text, size, true);
    add_turn(text, size, swept->larger);
}

static void add_plain(char *text, size_t size)
{
    swept->add(text, size, false);
}

static void check_scenes(const struct swept *shape)
{
    swept = shape;
    check_random_scenes(add_tangled, scene_count);
    for (size_t i = 0; i < 2 * scene_count; i++) {
        /* In some scenes the plain tracer's colours through transparent quadratic
         * prisms differ, by at most .007. The reason is unknown. */
        solids.clear = i % 2 && shape != &quadratic;
        check_solids_with(add_plain);
    }
    solids.clear = false;
}

TEST_CALL(prisms, check_scenes(&prism))
TEST_CALL(quadratic_prisms, check_scenes(&quadratic))
TEST_CALL(lathes, check_scenes(&lathe))

/* ---- Segments of a ray --------------------------------------------------- */

static size_t segments_of(const struct swept *shape, const char *path)
{
    struct shape_words words;
    SCOPED(scene) *scene = read_text(formatted("%s%s }", shape->begin, path));
    shape_words(scene->primitives, &words);
    assert_int_equal(shape_table_count(scene->primitives, NULL) % shape->row_words, 0);
    return words.segments;
}

#define SQUARE "4, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>"
#define HOLED \
    "10, <-2, -2>, <2, -2>, <2, 2>, <-2, 2>, <-2, -2>," \
    " <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>"
#define ROUNDED "6, <-1, 1>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>"
#define DRUM "4, <0, -1>, <1, -1>, <1, 1>, <0, 1>"
#define RING "5, <1, -1>, <2, -1>, <2, 1>, <1, 1>, <1, -1>"
#define CONE "3, <0, 1>, <1, 0>, <0, -1>"

TEST(segments)
{
    const struct {
        const struct swept *shape;
        const char *path;
        size_t segments;
    } rows[] = {
        { &prism, "3, <0, 0>, <1, 0>, <0, 1>", 1 },
        { &prism, SQUARE, 1 },
        { &prism, HOLED, 2 },
        /* Paths with a dent, of a Z, and of a staircase. */
        { &prism, "4, <0, 0>, <2, 1>, <0, 2>, <1, 1>", 2 },
        { &prism, "6, <0, 0>, <2, 0>, <1, 2>, <2, 2>, <2, 3>, <0, 3>", 2 },
        { &prism, "8, <0, 0>, <1, 0>, <1, 1>, <2, 1>, <2, 2>, <3, 2>, <3, 3>, <0, 3>",
          3 },
        { &quadratic, ROUNDED, 1 },
        { &quadratic,
          "12, <-2, 2>, <-2, -2>, <2, -2>, <2, 2>, <-2, 2>, <-2, -2>,"
          " <-1, 1>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>",
          2 },
        /* A path with a dent. */
        { &quadratic, "6, <1, .3>, <0, -1>, <3, 0>, <0, 1>, <1.5, 0>, <0, -1>", 2 },
        { &lathe, DRUM, 1 },
        { &lathe, CONE, 1 },
        { &lathe, RING, 2 },
        { &lathe, "4, <0, 1>, <1, 1>, <1, -1>, <0, -1>", 1 },
        /* A path with two bulges, and with a neck of two segments. */
        { &lathe, "5, <0, 0>, <1, 1>, <.5, 2>, <1, 3>, <0, 4>", 2 },
    };
    char circle[2000] = "48", ball[2000] = "25";
    for (size_t i = 0; i < COUNT(rows); i++)
        assert_int_equal(segments_of(rows[i].shape, rows[i].path), rows[i].segments);
    for (int i = 0; i < 48; i++)
        add_text(circle, sizeof circle, ", <%.9f, %.9f>", cos(i * acos(-1) / 24),
                 sin(i * acos(-1) / 24));
    assert_int_equal(segments_of(&prism, circle), 1);
    for (int i = 0; i <= 24; i++)
        add_text(ball, sizeof ball, ", <%.9f, %.9f>", sin(i * acos(-1) / 24),
                 -cos(i * acos(-1) / 24));
    assert_int_equal(segments_of(&lathe, ball), 1);
}

/* A line does not have more crossings than there is room for. */
static void check_crossings(const struct primitive *shape, double reach)
{
    struct shape_words words;
    shape_words(shape, &words);
    for (int try = 0; try < 100; try++) {
        struct crossing crossings[MAX_CROSSINGS];
        struct ray ray;
        for (int k = 0; k < 3; k++) {
            ray.origin[k] = between(-reach, reach);
            ray.direction[k] = between(-1, 1);
        }
        assert_true(plain_crossings(shape, &ray, crossings) <= 2 * words.segments);
    }
}

static void check_paths(const struct swept *shape)
{
    for (int try = 0; try < 600; try++) {
        char text[8000] = "";
        shape->add(text, sizeof text, try % 2);
        add_text(text, sizeof text, "}");
        SCOPED(scene) *scene = read_text(text);
        check_crossings(scene->primitives, shape->reach);
        shape->check(scene->primitives, true);
    }
}

TEST(paths)
{
    for (size_t i = 0; i < COUNT(all); i++)
        check_paths(all[i]);
}

/* In paths that do not intersect themselves, normals point from inside to outside. The
 * last path intersects itself, because its straight edges extend beyond their ends. */
TEST(known_normals)
{
    static const char *const paths[] = {
        ROUNDED,
        "12, <.2, -1>, <.2, .2>, <1, -.2>, <1, .2>, <.2, 1>, <-.2, 1>,"
        " <-1, .2>, <-1, -.2>, <-.2, .2>, <-.2, -1>, <.2, -1>, <.2, .2>",
        "11, <0, -2>, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>,"
        " <0, -1>, <-.5, -.5>, <.5, -.5>, <0, .5>, <-.5, -.5>",
        "7, <-3, 0>, <0, 0>, <1, 0>, <1.2, 0>, <.6, .9>, <.6, .9>, <0, 0>",
    };
    size_t count = COUNT(paths);
    for (size_t i = 0; i < count; i++) {
        const char *text = formatted("prism { quadratic_spline -1, 1, %s }", paths[i]);
        SCOPED(scene) *scene = read_text(text);
        check_quadratic_prism(scene->primitives, i + 1 == count);
    }
}

/* Rays along a cone's side and a tube's axis, and in rings. All forms agree. */
TEST(along)
{
    static const char *const lathes[] = {
        "lathe { 2, <0, 0>, <1, 1> rotate 45*x }",
        "lathe { 3, <0, 0>, <1, 1>, <0, 2> rotate 45*x }",
        "lathe { 3, <0, 1>, <1, 0>, <0, -1> rotate 45*x translate y }",
        "lathe { " CONE " matrix <1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0> }",
        "lathe { " RING " translate y }",
        "lathe { " RING " rotate 90*x translate y }",
        "lathe { " DRUM " rotate 90*x translate y }",
        "lathe { 4, <0, 0>, <1, 1e-9>, <1, 1>, <0, 1 + 1e-9> translate -y }",
    };
    for (size_t i = 0; i < COUNT(lathes); i++) {
        char text[1000];
        snprintf(text, sizeof text, STRAIGHT "%s", lathes[i]);
        free(same_frame(text));
        snprintf(text, sizeof text, STRAIGHT "difference { box { -2, 2 } %s }",
                 lathes[i]);
        free(same_frame(text));
    }
}

COUNT_AND_SEED(scene_count, traced.random);
