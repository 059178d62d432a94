/* test_meshes.c - meshes. The frames of both forms are compared with each other and
 * with the plain tracer, over random meshes. A triangle for each pixel must be found.
 * Of equal triangles the first must be found. A triangle that is lost or a wrong normal
 * fails here.
 *
 *     test_meshes [SCENES [SEED]]
 */
#define MIDDLING_FRAMES
#include "tests/unit/random_mesh.h"
#include "tests/unit/plain_surface.h"
#include "tests/unit/random_solids.h"

static size_t scene_count = 4; /* number of scenes of each kind */
static struct net net;
static char text[1 << 18];

/* ---- Random scenes ------------------------------------------------------- */

/* Makes a mesh with few faces. */
static void random_net(void)
{
    switch (below(4)) {
    case 0: net_random_body(&net, below(2), &traced.random); break;
    case 1: net_sheet(&net, 1 + below(4), .5, &traced.random); break;
    case 2: net_fan(&net, 2 + below(9), between(.2, 1), between(-1, 1)); break;
    default: net_soup(&net, 1 + below(20), below(2), &traced.random); break;
    }
    if (below(2))
        net_smooth(&net, between(0, .5), &traced.random);
    net_shuffle(&net, &traced.random);
}

static void add_mesh(char *to, size_t size)
{
    random_net();
    net_text(&net, to, size, &traced.random);
    add_random(
        to, size,
        "scale ^41:1.8^ rotate <^2-90:90^, ^2-90:90^, ^2-90:90^> translate @1.3@ ");
}

TEST_CALL(random_scenes, check_random_scenes(add_mesh, 2 * scene_count))

/* ---- Shadows and mirrors ------------------------------------------------- */

/* Adds a sphere or a mesh. Only spheres may be transparent. */
static void add_thing(char *to, size_t size)
{
    bool ball = below(5) == 0, clear = solids.clear;
    if (ball) {
        add_random(to, size, "sphere { 0, ^4.3:.8^ ");
    } else {
        random_net();
        net_text(&net, to, size, &traced.random);
    }
    solids.clear = clear && ball;
    add_look(to, size);
    solids.clear = clear;
    if (clear && below(2))
        add_random(to, size, "finish { reflection ^2.1:.6^ } ");
    add_random(to, size,
               "scale <^3.5:1.4^, ^3.5:1.4^, ^3.5:1.4^> "
               "rotate <^2-90:90^, ^2-90:90^, ^2-90:90^> translate @.8@}\n");
}

/* Writes objects that intersect and contain each other, over a floor. */
static void write_world(void)
{
    text[0] = '\0';
    add_random(text, sizeof text,
               "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 4 }\n"
               "background { rgb <.2, .3, .5> } light_source { <^1-7:7^, 8, -7>, .7 }\n"
               "light_source { <7, 3, -^22:6^>, rgb <.3, .2, .4> }\n"
               "camera { location <^3-2:2^, ^3-1:3^, -5> look_at 0 angle 45 }\n"
               "plane { y, -1.2 pigment { checker rgb .8 rgb .4 } "
               "finish { reflection .2 } }\n");
    for (size_t i = 3 + below(3); i > 0; i--)
        add_thing(text, sizeof text);
    if (below(2))
        return;
    add_text(text, sizeof text, "union { ");
    for (size_t i = 2 + below(2); i > 0; i--)
        add_thing(text, sizeof text);
    add_text(text, sizeof text, "}\n");
}

/* Traces a text by another method, or another text of the scene. The frame must be the
 * same. */
static void check_other_way(const struct words *words)
{
    FREED struct words *others = same_frame(text);
    FAIL_IF(memcmp(words, others, sizeof *words) != 0,
            "another way gives another frame of\n%s", text);
}

static void check_world(void)
{
    FREED struct words *words = plain_frame(text);
    check_paper_stage(text, words);
    traced.visible = VISIBLE_EVERY;
    traced.no_bounds = true;
    check_other_way(words);
    traced.visible = VISIBLE_DEFAULT;
    traced.no_bounds = false;
    traced.flat = true;
    check_other_way(words);
    traced.flat = false;
}

TEST(worlds)
{
    for (size_t i = 0; i < 2 * scene_count; i++) {
        solids.clear = i % 2;
        write_world();
        check_world();
    }
    solids.clear = false;
}

/* ---- Every triangle ------------------------------------------------------ */

/* Adds a triangle around a point at `factor` times the length of a ray. */
static void add_small(const double ray[3], double factor)
{
    static const double around[3][3] = { { -.3, -.25, 0 },
                                         { .35, -.2, 0 },
                                         { 0, .4, 0 } };
    size_t corners[3];
    for (int k = 0; k < 3; k++) {
        double point[3];
        add_scaled(point, ray, 1, around[k]);
        scale_by(point, factor);
        corners[k] = net_point(&net, point);
    }
    net_face(&net, corners[0], corners[1], corners[2]);
}

/* Writes a triangle for each pixel, and records its depth. */
static void write_pixels(double depths[PIXELS])
{
    net_soup(&net, 0, false, &traced.random);
    for (size_t i = 0; i < PIXELS; i++) {
        double factor = (double)among(64, 1024) / 256;
        const double ray[3] = { (double)(i % WIDTH) - (WIDTH - 1) / 2,
                                (HEIGHT - 1) / 2 - (double)(i / WIDTH), 48 };
        add_small(ray, factor);
        depths[i] = factor * sqrt(dot(ray, ray));
    }
    net_shuffle(&net, &traced.random);
    strcpy(text, HEAD "camera { location 0 " STRAIGHT_AHEAD " }\n");
    net_mesh_text(&net, text, sizeof text);
    add_text(text, sizeof text, "}\n");
}

TEST(every_triangle)
{
    double depths[PIXELS];
    write_pixels(depths);
    FREED struct words *words = same_frame(text);
    assert_int_equal(hits(words), PIXELS);
    for (size_t k = 0; k < PIXELS; k++)
        assert_near(c205_to_double(words->channel[CHANNEL_DEPTH][k]), depths[k],
                    1e-9 * depths[k]);
    check_paper_stage(text, words);
}

/* Meshes with hundreds of triangles are traced. */
TEST(big)
{
    for (size_t i = 0; i < scene_count; i++) {
        strcpy(text, HEAD "camera { location <0, 1, -4> look_at 0 }\n");
        if (i % 2)
            net_soup(&net, 200, i % 4 == 3, &traced.random);
        else
            net_random_body(&net, 2, &traced.random);
        if (i % 3)
            net_smooth(&net, .2, &traced.random);
        net_text(&net, text, sizeof text, &traced.random);
        add_text(text, sizeof text, "pigment { rgb .8 } rotate %.2f }\n", angle());
        free(plain_frame(text));
    }
}

static uint64_t checksum_of(const struct scene *scene, enum trace_mode mode,
                            size_t queue)
{
    enum { SIDE = 250 };
    struct trace_options options = ON_PRIOR(.mode = mode, .width = SIDE, .height = SIDE,
                                            .band = SIDE * SIDE, .queue = queue);
    SCOPED(trace) *trace = run_trace(scene, &options);
    return trace_checksum(trace);
}

/* A triangle in front of a shadow ray's end casts a shadow, one at the end none. */
TEST(shadow_limit)
{
    free(plain_frame(
        "camera { location 4*y right x up y look_at 0 sky z angle 60 }\n"
        "light_source { 8*y rgb 1 }\n"
        "plane { y, 0 pigment { rgb 1 } finish { ambient .1 diffuse .9 } }\n"
        "mesh { triangle { <-.5, 7.999, -.5>, <.5, 7.999, -.5>, <0, 7.999, .5> }\n"
        "triangle { <-.5, 5, -.5>, <.5, 5, -.5>, <0, 5, .5> }\n"
        "pigment { rgb <1, .2, .1> } }\n"));
}

/* Queues have nearly as many rays as the longest vector has elements. */
TEST(long_queues)
{
    static const size_t queues[] = { 40000, MAX_TRACE_QUEUE - 4, MAX_TRACE_QUEUE };
    strcpy(text, HEAD "camera { location <0, 1, -2> look_at 0 }\n");
    net_random_body(&net, 1, &traced.random);
    net_mesh_text(&net, text, sizeof text);
    add_text(text, sizeof text, "}\n");
    SCOPED(scene) *scene = read_text(text);
    uint64_t scalar = checksum_of(scene, TRACE_SCALAR, 1);
    for (size_t i = 0; i < COUNT(queues); i++)
        assert_true(checksum_of(scene, TRACE_VECTOR, queues[i]) == scalar);
}

/* ---- Equivalent texts ---------------------------------------------------- */

static void write_mesh(bool mesh2)
{
    strcpy(text, HEAD "camera { location <0, 1, -5> look_at 0 }\n");
    if (mesh2)
        net_mesh2_text(&net, text, sizeof text);
    else
        net_mesh_text(&net, text, sizeof text);
    add_text(text, sizeof text, "rotate <20, 30, 40> }\n");
}

/* The order of the triangles does not change the nearest hits. */
TEST(other_words)
{
    for (size_t i = 0; i < scene_count; i++) {
        net_random_body(&net, 2, &traced.random);
        if (i % 2)
            net_smooth(&net, .2, &traced.random);
        write_mesh(false);
        FREED struct words *words = same_frame(text);
        write_mesh(true);
        check_other_way(words);
        net_shuffle(&net, &traced.random);
        write_mesh(false);
        FREED struct words *others = same_frame(text);
        for (size_t k = 0; k < PIXELS; k++)
            assert_near(c205_to_double(others->channel[CHANNEL_DEPTH][k]),
                        c205_to_double(words->channel[CHANNEL_DEPTH][k]), 1e-10);
    }
}

#define CORNERS "<-1, -1, 0>, <2, -1, 0>, <-1, 2, 0>"
#define LEANING \
    "smooth_triangle { <-1, -1, 0>, <3, 0, -4>, <2, -1, 0>, -z, " \
    "<-1, 2, 0>, -2*z }"
#define FLAT "triangle { " CORNERS " }"

/* Triangles are traced without a mesh. */
TEST(triangles_alone)
{
    static const char *const triangles[] = { FLAT, LEANING };
    for (size_t i = 0; i < 2; i++) {
        snprintf(text, sizeof text, "%s%s", AHEAD, triangles[i]);
        FREED struct words *words = plain_frame(text);
        snprintf(text, sizeof text, "%smesh { %s }", AHEAD, triangles[i]);
        check_other_way(words);
    }
}

/* ---- Ties ---------------------------------------------------------------- */

static void check_normal(const char *scene, double x, double y, double z)
{
    FREED struct words *words = same_frame(scene);
    size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
    double expected[3] = { x, y, z };
    normalise(expected);
    for (int i = 0; i < 3; i++)
        assert_near(c205_to_double(words->channel[CHANNEL_NORMAL_X + i][middle]),
                    expected[i], 1e-10);
}

TEST(ties)
{
    check_normal(STRAIGHT "mesh { " FLAT LEANING FLAT " }", 0, 0, -1);
    check_normal(STRAIGHT "mesh { " LEANING FLAT LEANING " }", .6, 0, -2.8);
    check_middle(STRAIGHT "mesh { " FLAT " } mesh { " LEANING " }", 2, 5);
    check_middle(STRAIGHT "mesh { " LEANING " } mesh { " FLAT " }", 2, 5);
    check_normal(STRAIGHT "mesh { " FLAT " } mesh { " LEANING " }", .6, 0, -2.8);
    check_middle(STRAIGHT "mesh { triangle { <-1, -1, 1>, <2, -1, 1>, "
                          "<-1, 2, 1> } } mesh { " FLAT " } " FLAT,
                 3, 5);
}

/* Adds a copy of every face after all faces, with other normals. */
static void add_doubles(void)
{
    size_t count = net.face_count;
    for (size_t i = 0; i < count; i++) {
        size_t points[3];
        for (int k = 0; k < 3; k++) {
            points[k] = net.point_count++;
            copy(net.points[points[k]], net.points[net.faces[i][k]]);
            copy(net.normals[points[k]], net.normals[net.faces[0][k]]);
        }
        net_face(&net, points[0], points[1], points[2]);
    }
}

/* Of equal triangles in a mesh the first is visible, of equal meshes the second. */
TEST(doubles)
{
    net_take(&net, ICOSAHEDRON);
    net_divide(&net);
    net_smooth(&net, 0, &traced.random);
    write_mesh(false);
    FREED struct words *words = same_frame(text);
    add_doubles();
    write_mesh(false);
    check_other_way(words);
    net_mesh_text(&net, text, sizeof text);
    add_text(text, sizeof text, "rotate <20, 30, 40> }\n");
    for (size_t k = 0; k < PIXELS; k++)
        if (c205_to_integer(words->channel[CHANNEL_ID][k]) == 1)
            words->channel[CHANNEL_ID][k] = c205_from_integer(2);
    check_other_way(words);
}

/* ---- Special cases ------------------------------------------------------- */

static size_t triangles_of(const char *scene)
{
    SCOPED(scene) *read = read_text(scene);
    size_t count = read->primitives[0].shape.mesh.triangles.count;
    assert_int_equal(read->primitives[0].kind, PRIMITIVE_MESH);
    return count;
}

#define NO_AREA \
    "triangle { <0, 0, -1>, <1, 1, -1>, <2, 2, -1> } " \
    "triangle { <0, 0, -1>, <0, 0, -1>, <1, 0, -1> } " \
    "smooth_triangle { <0, 0, -1>, z, <0, 0, -1>, z, <0, 0, -1>, z } "

TEST(no_area)
{
    assert_int_equal(triangles_of("mesh { " FLAT " }"), 1);
    assert_int_equal(triangles_of("mesh { " NO_AREA FLAT NO_AREA " }"), 1);
    assert_int_equal(triangles_of("mesh { " FLAT NO_AREA FLAT " }"), 2);
    check_middle(STRAIGHT "mesh { " NO_AREA FLAT " }", 1, 5);
    check_middle(STRAIGHT "mesh { " FLAT NO_AREA " }", 1, 5);
}

/* Small meshes, seen from far away, where a loss of precision would be visible. The
 * view is not along an axis, because rays that hit an edge may hit either side. */
TEST(distant)
{
    for (int i = 0; i < 3; i++) {
        strcpy(text, HEAD "camera { location <13, 21, -1000> look_at 0 angle .2 }\n");
        net_random_body(&net, 1, &traced.random);
        net_mesh_text(&net, text, sizeof text);
        add_text(text, sizeof text, "}\n");
        free(plain_frame(text));
    }
}

COUNT_AND_SEED(scene_count, traced.random);
