/* Lathes: both forms of the tracer agree with each other and the plain tracer,
 * for paths of any sort, alone and in solids, and meet them where geometry says.
 *
 *     test_lathes [SCENES [SEED]]
 */
#define MIDDLING_FRAMES
#include "tests/unit/random_solids.h"

#include "rt/shapes/shape_words.h"
#include "tests/oracle/plain_shapes.h"

static size_t scene_count = 4; /* of each sort */

/* ---- Paths --------------------------------------------------------------- */

/* Upwards, level and upright now and then; from the axis to the axis, or open at
 * an end or at both. */
static size_t add_profile(char *text, size_t size)
{
    size_t corners = 2 + below(9), count = corners;
    double height = -1, radius = between(.1, 1);
    bool level = below(3) > 0;

    if (level) {
        add_text(text, size, ", <0, %.4f>", height);
        count++;
    }
    for (size_t i = 0; i < corners; i++) {
        add_text(text, size, ", <%.4f, %.4f>", radius, height);
        level = !level && below(4) == 0;
        height += level ? 0 : between(.05, 2. / (double)corners);
        radius = level || below(4) ? between(.05, 1) : radius;
    }
    if (below(3)) {
        add_text(text, size, ", <0, %.4f>", height - between(0, .3));
        count++;
    }
    return count;
}

/* A loop, which may come to the axis and may be closed. */
static size_t add_loop(char *text, size_t size)
{
    size_t corners = 3 + below(6);
    double first[2] = { 0, 0 };
    bool closed = below(4) > 0;

    for (size_t i = 0; i < corners; i++) {
        double turn = 2 * acos(-1) * ((double)i + between(-.3, .3))
                      / (double)corners;
        double reach = between(.2, .5);
        double point[2] = { fmax(0, .45 + reach * cos(turn)),
                            1.6 * reach * sin(turn) };

        if (i == 0)
            memcpy(first, point, sizeof first);
        add_text(text, size, ", <%.6f, %.6f>", point[0], point[1]);
    }
    if (closed)
        add_text(text, size, ", <%.6f, %.6f>", first[0], first[1]);
    return corners + closed;
}

/* Corners anywhere. */
static size_t add_tangle(char *text, size_t size)
{
    size_t corners = 2 + below(9);

    for (size_t i = 0; i < corners; i++)
        add_text(text, size, ", <%.6f, %.6f>", between(0, 1), between(-1, 1));
    return corners;
}

static void add_any_lathe(char *text, size_t size, bool tangles)
{
    char path[2000] = "";
    size_t sort = below(3 + tangles);
    size_t count = sort == 3   ? add_tangle(path, sizeof path)
                   : sort == 2 ? add_loop(path, sizeof path)
                               : add_profile(path, sizeof path);

    add_text(text, size, "lathe { %s%zu%s ", below(2) ? "linear_spline " : "",
             count, path);
}

static void add_tangled_lathe(char *text, size_t size)
{
    add_any_lathe(text, size, true);
    add_turn(text, size, 1.4);
}

TEST(random_scenes)
{
    check_random_scenes(add_tangled_lathe, scene_count);
}

/* ---- Solids -------------------------------------------------------------- */

static void add_plain_lathe(char *text, size_t size)
{
    add_any_lathe(text, size, false);
}

TEST(solids)
{
    for (size_t i = 0; i < 2 * scene_count; i++) {
        solids.clear = i % 2;
        check_solids_with(add_plain_lathe);
    }
}

/* ---- What geometry says -------------------------------------------------- */

#define TUBE "2, <1, -1>, <1, 1>"
#define DRUM "4, <0, -1>, <1, -1>, <1, 1>, <0, 1>"
#define RING "5, <1, -1>, <2, -1>, <2, 1>, <1, 1>, <1, -1>"
#define CONE "3, <0, 1>, <1, 0>, <0, -1>"

TEST(middle)
{
    check_middle(AHEAD "lathe { " TUBE " }", 1, 4);
    check_middle(AHEAD "lathe { linear_spline " DRUM " }", 1, 4);
    check_middle(AHEAD "lathe { " DRUM " translate -5*z }", 1, 1);
    check_middle(AHEAD "lathe { " RING " translate -5*z }", 1, 1);
    check_middle(AHEAD "lathe { " DRUM " translate 2*y }", 0, 0);
    check_middle(AHEAD "lathe { 2, <2, -1>, <1, 1> translate 1e-9*y }", 1,
                 3.5);
    /* level, through a corner; along the axis; beside it */
    check_middle(AHEAD "lathe { " CONE " }", 1, 4);
    check_middle(AHEAD "lathe { " CONE " rotate 90*x }", 1, 4);
    check_middle(AHEAD "lathe { " DRUM " rotate 90*x }", 1, 4);
    check_middle(AHEAD "lathe { " TUBE " rotate 90*x }", 0, 0);
    check_middle(AHEAD "lathe { " RING " rotate 90*x }", 0, 0);
    check_middle(AHEAD "lathe { " RING " rotate 90*x translate 1.5*y }", 1,
                 4);
    check_middle(AHEAD "lathe { " CONE " rotate 90*x translate .5*y }", 1,
                 4.5);
    /* level, in a ring; where a point is the lowest of all */
    check_middle(AHEAD "lathe { " DRUM " translate y }", 1, 4);
    check_middle(AHEAD "lathe { " DRUM " translate -y }", 0, 0);
    check_middle(AHEAD "lathe { 3, <1, 1>, <2, 0>, <1.5, 2> }", 1, 3);
    /* from within, of what is no tube */
    check_middle(AHEAD "lathe { 2, <3, -1>, <3, 1> translate -5*z }", 1, 3);
}

TEST(middle_of_solids)
{
    check_middle(AHEAD "intersection { lathe { " DRUM " } plane { -z, 0 } }",
                 2, 5);
    /* a tube has no inside, but is seen in that of others */
    check_middle(AHEAD "intersection { lathe { " TUBE " } plane { -z, .5 } }",
                 1, 6);
    check_middle(AHEAD "lathe { " TUBE " clipped_by { plane { -z, .5 } } }",
                 1, 6);
    check_middle(AHEAD "lathe { 3, <1, 0>, <.5, 0>, <.5, 1> rotate 90*x"
                       " translate .75*y clipped_by { box { -2, 2 } } }",
                 1, 5);
    check_middle(AHEAD "intersection { lathe { 3, <0, -1>, <1, -1>, <1, 1> }"
                       " plane { -z, .5 } }",
                 2, 4.5);
    check_middle(AHEAD "difference { sphere { 0, 3 } lathe { " DRUM
                       " scale 4 } }",
                 0, 0);
    check_middle(AHEAD "difference { lathe { " RING " } plane { z, 0 } }", 1,
                 6);
    /* through corners, and level where one point is lowest */
    check_middle(AHEAD "intersection { lathe { " CONE " } plane { -z, .5 } }",
                 2, 4.5);
    check_middle(AHEAD "intersection { lathe { 4, <1, 1>, <2, 0>, <1.5, 2>,"
                       " <1, 1> } plane { -z, .5 } }",
                 0, 0);
    check_middle(AHEAD "difference { box { -2, 2 } lathe { " CONE
                       " rotate 45*x translate -2*z } }",
                 2, 3 + sqrt(.5));
}

/* Rays in the side of a cone, along the axis of a tube, in rings: whatever they
 * meet, all forms agree. */
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

    for (size_t i = 0; i < sizeof lathes / sizeof *lathes; i++) {
        char text[1000];

        snprintf(text, sizeof text, STRAIGHT "%s", lathes[i]);
        free(same_frame(text));
        snprintf(text, sizeof text,
                 STRAIGHT "difference { box { -2, 2 } %s }", lathes[i]);
        free(same_frame(text));
    }
}

/* ---- How many segments a ray has ----------------------------------------- */

static size_t segments_of(const char *path)
{
    char text[2000];
    struct shape_words words;
    struct scene *scene;

    snprintf(text, sizeof text, "lathe { %s }", path);
    scene = read_text(text);
    shape_words(scene->primitives, &words);
    assert_int_equal(shape_table_count(scene->primitives, NULL) % 16, 0);
    scene_free(scene);
    return words.segments;
}

TEST(segments)
{
    char ball[2000] = "25";

    assert_int_equal(segments_of(DRUM), 1);
    assert_int_equal(segments_of(CONE), 1);
    assert_int_equal(segments_of(RING), 2);
    assert_int_equal(segments_of("4, <0, 1>, <1, 1>, <1, -1>, <0, -1>"), 1);
    /* two bulges, and a neck of two segments */
    assert_int_equal(segments_of("5, <0, 0>, <1, 1>, <.5, 2>, <1, 3>,"
                                 " <0, 4>"),
                     2);
    for (int i = 0; i <= 24; i++)
        add_text(ball, sizeof ball, ", <%.9f, %.9f>", sin(i * acos(-1) / 24),
                 -cos(i * acos(-1) / 24));
    assert_int_equal(segments_of(ball), 1);
}

/* No line crosses it more often than there is room for. */
static void check_crossings(const struct primitive *lathe)
{
    struct shape_words words;

    shape_words(lathe, &words);
    for (int try = 0; try < 100; try++) {
        struct crossing crossings[MOST_CROSSINGS];
        struct ray ray;

        for (int k = 0; k < 3; k++) {
            ray.origin[k] = between(-1, 1);
            ray.direction[k] = between(-1, 1);
        }
        assert_true(plain_crossings(lathe, &ray, crossings)
                    <= 2 * words.segments);
    }
}

/* ---- Normals ------------------------------------------------------------- */

enum { HEIGHT_WORD = 1, BEGINS_WORD = 2, RADIUS_WORD = 10 };

static bool is_closed(const struct primitive *lathe)
{
    const struct outline *path = &lathe->shape.lathe.path;
    const double *first = path->points[0];
    const double *last = path->points[path->count - 1];

    return (first[0] == 0 && last[0] == 0)
           || (first[0] == last[0] && first[1] == last[1]);
}

/* The normal of each segment leads from inside to outside; of what is open both
 * may be outside. */
static void check_normals(const struct primitive *lathe)
{
    size_t count = shape_table_count(lathe, NULL);
    double *table = shape_table(lathe, NULL, count);
    struct shape_words words;

    shape_words(lathe, &words);
    assert_non_null(table);
    for (double *row = table; row < table + 16 * (size_t)words.words[3];
         row += 16) {
        double outside[3] = { 0 }, inside[3] = { 0 };

        if (row[BEGINS_WORD] == 1)
            continue;
        for (int k = 0; k < 2; k++) {
            double corner = k ? words.words[0] + row[HEIGHT_WORD]
                              : row[RADIUS_WORD];
            double middle = corner + row[11 + k] * row[13] / 2;

            outside[k] = middle + 1e-7 * row[14 + k];
            inside[k] = middle - 1e-7 * row[14 + k];
        }
        if (inside[0] < 1e-6)
            continue;
        assert_true(plain_encloses(lathe, inside) || !is_closed(lathe));
        assert_false(plain_encloses(lathe, outside));
    }
    free(table);
}

TEST(paths)
{
    char text[4000];

    for (int try = 0; try < 400; try++) {
        struct scene *scene;

        strcpy(text, "");
        add_any_lathe(text, sizeof text, try % 2);
        add_text(text, sizeof text, "}");
        scene = read_text(text);
        check_crossings(scene->primitives);
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
