/* test_ray_query.c - all crossings of lines with random solids of all shapes are
 * compared between forms, queues and bounds, and with the plain tracer. The nearest
 * crossing is compared with a frame. A crossing that is lost, out of order or of
 * another body fails here.
 *
 *     test_ray_query [SCENES [SEED]]
 */
#include "tests/unit/random_solids.h"

#include "tests/oracle/ray_query_rules.h"

enum { LINES = 60 };

static size_t scene_count = 6; /* number of scenes of each kind */

/* ---- Random solids ------------------------------------------------------- */

static void write_scene(char *text, size_t size, const char *camera)
{
    text[0] = '\0';
    add_text(text, size, HEAD "camera { %s }\n", camera);
    for (size_t i = 1 + below(3); i > 0; i--)
        add_solid(text, size, 1 + below(2));
}

static void check(bool good, const char *reason, const char *text)
{
    FAIL_IF(!good, "%s in\n%s", reason, text);
}

/* Compares all forms and the plain tracer. Depending on z, the camera is on either side
 * of the solids or inside them. */
static void check_solids(double z, double behind)
{
    static const size_t queues[] = { 1, 7, LINES - 1, 2000, 2000, 300 };
    static char text[1 << 18];
    struct ray_query_options options = ON_PRIOR(.normals = true, .bodies = true,
                                                .behind = behind);
    struct scene_ray list[LINES];
    char camera[80], reason[LINE_REASON];
    snprintf(camera, sizeof camera,
             "location <%.3f, %.3f, %.3f> look_at <0, .1, .2> angle 40", between(-3, 3),
             between(-3, 3), z);
    write_scene(text, sizeof text, camera);
    SCOPED(scene) *scene = read_text(text);
    draw_camera_lines(&traced.random, scene, list, LINES);
    SCOPED_VALUE(ray_hits) found = find_lines(scene, &options, list, LINES);
    for (size_t i = 0; i < COUNT(queues); i++) {
        options.mode = i % 2 ? TRACE_KERNELS : TRACE_VECTOR;
        options.queue = queues[i];
        options.packet = i == 1 ? LINES / 3 : 0;
        options.flat = i == 2;
        options.no_bounds = i == 3;
        SCOPED_VALUE(ray_hits) vector = find_lines(scene, &options, list, LINES);
        check(same_crossings(&found, &vector, reason), reason, text);
    }
    check(keep_line_rules(scene, list, &found, behind, reason), reason, text);
    check(same_as_plain_lines(scene, list, &found, behind, true, reason), reason, text);
}

TEST(random_solids)
{
    for (size_t i = 0; i < scene_count; i++) {
        check_solids(-6, 0);
        check_solids(7, 0);
        check_solids(.3, 12);
    }
}

/* ---- The nearest --------------------------------------------------------- */

enum { SIDE = 32 };

/* A camera whose rays have exact coordinates. */
#define EXACT "orthographic location -8*z direction z right 4*x up 4*y"

/* For a mesh alone, the kernel of frames keeps the signs of products, and the kernel of
 * all crossings uses magnitudes. Because of truncation, their last bits may differ. */
static bool is_word(c205_word found, c205_word expected, bool mesh)
{
    return found == expected
           || (mesh && fabs(c205_to_double(found) - c205_to_double(expected)) < 1e-12);
}

/* A frame must have the distance, the normal and the id of the first crossing. */
static void check_nearest(const struct scene *scene, const struct words *words,
                          size_t pixel, const struct ray_hits *found, const char *text)
{
    size_t first = found->first[pixel];
    c205_word zero = c205_from_double(0);
    const struct ray_hit none = { .primitive = (size_t)-1,
                                  .distance = zero,
                                  .normal = { zero, zero, zero } };
    const struct ray_hit *seen = first < found->first[pixel + 1] ? &found->list[first]
                                                                 : &none;
    size_t id = (size_t)c205_to_integer(words->channel[CHANNEL_ID][pixel]);
    bool mesh = id > 0 && scene->primitives[id - 1].kind == PRIMITIVE_MESH;
    bool same = id == seen->primitive + 1
                && is_word(words->channel[CHANNEL_DEPTH][pixel], seen->distance, mesh);
    for (int i = 0; i < 3; i++)
        same = same
               && is_word(words->channel[CHANNEL_NORMAL_X + i][pixel], seen->normal[i],
                          mesh);
    FAIL_IF(!same, "pixel %zu: not the first along its line in\n%s", pixel, text);
}

TEST(nearest)
{
    static char text[1 << 18];
    static struct scene_ray list[SIDE * SIDE];
    struct ray_query_options options = ON_PRIOR(.queue = 300, .normals = true,
                                                .bodies = true);
    traced.width = traced.height = SIDE;
    traced.pixels = SIDE * SIDE;
    for (size_t i = 0; i < SIDE * SIDE; i++)
        list[i] = (struct scene_ray){
            .origin = { ((double)(i % SIDE) + .5) / (SIDE / 4) - 2,
                        2 - ((double)(i / SIDE) + .5) / (SIDE / 4), -8 },
            .direction = { 0, 0, 1 },
        };
    for (size_t i = 0; i < scene_count; i++) {
        char reason[LINE_REASON];
        write_scene(text, sizeof text, EXACT);
        SCOPED(scene) *scene = read_text(text);
        FREED struct words *words = trace_words(scene, TRACE_VECTOR, 2000);
        options.mode = TRACE_SCALAR;
        SCOPED_VALUE(ray_hits) scalar = find_lines(scene, &options, list, SIDE * SIDE);
        options.mode = TRACE_KERNELS;
        SCOPED_VALUE(ray_hits) serial = find_lines(scene, &options, list, SIDE * SIDE);
        options.mode = TRACE_VECTOR;
        SCOPED_VALUE(ray_hits) found = find_lines(scene, &options, list, SIDE * SIDE);
        for (size_t k = 0; k < SIDE * SIDE; k++)
            check_nearest(scene, words, k, &found, text);
        check(same_crossings(&scalar, &found, reason), reason, text);
        check(same_crossings(&scalar, &serial, reason), reason, text);
        check(keep_line_rules(scene, list, &found, 0, reason), reason, text);
    }
    traced.width = WIDTH;
    traced.height = HEIGHT;
    traced.pixels = PIXELS;
}

/* ---- Cases by hand ------------------------------------------------------- */

/* An expected crossing. */
struct expected {
    double distance;
    size_t primitive, object;
    int crossing, object_depth, scene_depth;
};

/* The number of copies of a line, which is sufficient to fill pages with crossings. */
enum { COPIES = 64 };

static void check_form(const char *text, enum trace_mode mode, double behind,
                       size_t count, const struct expected *expected)
{
    struct ray_query_options options = ON_PRIOR(.mode = mode, .queue = 10,
                                                .bodies = true, .behind = behind);
    struct scene_ray list[COPIES];
    SCOPED(scene) *scene = read_text(text);
    for (size_t i = 0; i < COPIES; i++)
        list[i] = (struct scene_ray){ { 0, .125, -4 }, { 0, 0, 2 } };
    SCOPED_VALUE(ray_hits) found = find_lines(scene, &options, list, COPIES);
    for (size_t i = 0; i < COPIES; i++) {
        FAIL_IF(found.first[i + 1] != (i + 1) * count, "%zu crossings, not %zu, in\n%s",
                found.first[i + 1] - i * count, count, text);
        for (size_t k = 0; k < count; k++) {
            const struct ray_hit *seen = &found.list[i * count + k];
            double distance = c205_to_double(seen->distance) - expected[k].distance;
            if (!(fabs(distance) <= 1e-12) || seen->primitive != expected[k].primitive
                || seen->object != expected[k].object
                || seen->crossing != expected[k].crossing
                || seen->object_depth != expected[k].object_depth
                || seen->scene_depth != expected[k].scene_depth)
                fail_msg("another crossing %zu in\n%s", k, text);
        }
    }
}

/* The expected crossings are written as the members of struct expected. */
static const struct {
    const char *objects;
    double behind;
    const char *expected;
} cases[] = {
    /* Two solids touch. Parts of a union are bodies. A merge has no inner surfaces. */
    { "box { -1, 1 } box { <-1, -1, 1>, <1, 1, 2> }", 0,
      "3 0 0 1 1 1; 5 0 0 -1 0 0; 5 1 1 1 1 1; 6 1 1 -1 0 0" },
    { "union { box { -1, 1 } box { <-1, -1, 0>, <1, 1, 2> } }", 0,
      "3 0 0 1 1 1; 4 1 0 1 2 2; 5 0 0 -1 1 1; 6 1 0 -1 0 0" },
    { "merge { box { -1, 1 } box { <-1, -1, 0>, <1, 1, 2> } }", 0,
      "3 0 0 1 1 1; 6 1 0 -1 0 0" },
    { "merge { box { -1, 1 } box { -1, 1 } }", 0, "3 0 0 1 1 1; 5 0 0 -1 0 0" },
    { "merge { box { -1, 1 } box { <-1, -1, -1.00000005>, 1 } }", 0,
      "2.99999995 0 0 1 1 1; 5 0 0 -1 0 0" },
    { "difference { box { -1, 1 } box { -1, 1 } }", 0, "" },
    { "difference { box { -1, 1 } box { -.5, .5 } }", 0,
      "3 0 0 1 1 1; 3.5 1 0 -1 0 0; 4.5 1 0 1 1 1; 5 0 0 -1 0 0" },
    /* Open surfaces are crossed, but do not belong to a body. */
    { "cylinder { -y, y, 1 open } disc { 0, z, 1 }", 0,
      "3 0 0 0 0 0; 4 1 1 0 0 0; 5 0 0 0 0 0" },
    { "box { -1, 1 clipped_by { plane { z, 0 } } } plane { z, 2 }", 0,
      "3 0 0 0 0 0; 6 2 1 -1 -1 -1" },
    /* Distances are measured from the origin. Crossings behind it are negative. */
    { "box { <-1, -1, -7>, <1, 1, -6> } box { -1, 1 inverse }", 8,
      "-3 0 0 1 1 1; -2 0 0 -1 0 0; 3 1 1 -1 -1 -1; 5 1 1 1 0 0" },
    { "box { <-1, -1, -7>, <1, 1, -6> } box { -1, 1 }", 0,
      "3 1 1 1 1 1; 5 1 1 -1 0 0" },
    { "box { <-1, -1, -7>, <1, 1, -6> } box { -1, 1 }", 2.5,
      "-2 0 0 -1 -1 -1; 3 1 1 1 1 0; 5 1 1 -1 0 -1" },
};

TEST(lines)
{
    for (size_t i = 0; i < COUNT(cases) * TRACE_MODES; i++) {
        const char *at = cases[i / TRACE_MODES].expected;
        struct expected list[4], *next = list;
        char text[1000] = HEAD;
        add_text(text, sizeof text, "%s", cases[i / TRACE_MODES].objects);
        for (int end; *at; at += strspn(at, "; "), next++) {
            assert_int_equal(sscanf(at, "%lf %zu %zu %d %d %d%n", &next->distance,
                                    &next->primitive, &next->object, &next->crossing,
                                    &next->object_depth, &next->scene_depth, &end),
                             6);
            at += end;
        }
        check_form(text, (enum trace_mode)(i % TRACE_MODES),
                   cases[i / TRACE_MODES].behind, (size_t)(next - list), list);
    }
}

/* All crossings are found, whatever their order is. */
TEST(many)
{
    enum { SPHERES = 300 };
    static struct expected expected[2 * SPHERES];
    static char text[1 << 16];
    strcpy(text, HEAD "union {\n");
    for (size_t i = 0; i < SPHERES; i++) {
        size_t at = i * 7 % SPHERES;
        double middle = (double)at + 4;
        add_text(text, sizeof text, "sphere { <0, .125, %zu>, .25 }\n", at);
        expected[2 * at] = (struct expected){ middle - .25, i, 0, 1, 1, 1 };
        expected[2 * at + 1] = (struct expected){ middle + .25, i, 0, -1, 0, 0 };
    }
    add_text(text, sizeof text, "}\n");
    for (int mode = 0; mode < TRACE_MODES; mode++)
        check_form(text, (enum trace_mode)mode, 0, 2 * SPHERES, expected);
}

/* ---- Errors -------------------------------------------------------------- */

TEST(refused)
{
    static const struct {
        struct ray_query_options options;
        const char *message;
    } rows[] = {
        { { .mode = TRACE_MODES, .queue = 10 },
          "unknown mode: expected scalar, vector or kernels" },
        { { .mode = TRACE_VECTOR, .queue = 0 },
          "the queue must be between 1 and 65535 rays" },
        { { .mode = TRACE_VECTOR, .queue = 65536 },
          "the queue must be between 1 and 65535 rays" },
        { { .mode = TRACE_SCALAR, .behind = -1 },
          "the distance before the origins must be finite and not below 0" },
        { { .mode = TRACE_SCALAR, .behind = INFINITY },
          "the distance before the origins must be finite and not below 0" },
    };
    SCOPED(scene) *scene = read_text(HEAD "sphere { 0, 1 }");
    for (size_t i = 0; i < COUNT(rows); i++) {
        c205_error error = { "" };
        assert_null(ray_query_new(scene, &rows[i].options, &error));
        assert_string_equal(error.message, rows[i].message);
    }
}

TEST(no_lines)
{
    static const struct scene_ray bad[][2] = {
        { { { 0 }, { 0, 0, 1 } }, { { 0 }, { 0, 0, 0 } } },
        { { { 0 }, { 0, 0, 1 } }, { { NAN, 0, 0 }, { 0, 0, 1 } } },
        { { { 0 }, { 0, 0, 1 } }, { { 0 }, { 0, 0, INFINITY } } },
    };
    const struct ray_query_options options = { .mode = TRACE_SCALAR,
                                               .model = prior_model };
    SCOPED(scene) *scene = read_text(HEAD "sphere { 0, 1 }");
    c205_error error = { "" };
    SCOPED(ray_query) *lines = NON_NULL(ray_query_new(scene, &options, &error));
    SCOPED_VALUE(ray_hits) found;
    for (size_t i = 0; i < 3; i++) {
        assert_false(ray_query_find(lines, bad[i], 2, &found, &error));
        assert_string_equal(error.message,
                            "ray 1 must have a direction and finite numbers");
        assert_null(found.list);
    }
    assert_true(ray_query_find(lines, NULL, 0, &found, &error));
    assert_int_equal(found.first[0], 0);
}

ARGUMENTS(argc, argv)
{
    traced.reported = true; /* some patches are in intersections */
    solids.surfaces = true;
    scene_count = argument(argc, argv, 1, share_of(scene_count));
    traced.random ^= argument(argc, argv, 2, 0) << 13;
}
