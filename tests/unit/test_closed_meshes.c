/* test_closed_meshes.c - pixels of closed meshes, seen from inside, are compared with
 * the background. No ray may pass to the outside, whether it is aimed at points, at
 * edges or at random, in either form. As solids the meshes have an inside, whose
 * boundary a ray crosses an even number of times. A ray that passes between two
 * triangles, or a crossing that is counted twice, fails here.
 *
 *     test_closed_meshes [SCENES [SEED]]
 */
#define MIDDLING_FRAMES
#include "tests/oracle/plain_shapes.h"
#include "tests/unit/random_mesh.h"
#include "tests/unit/random_solids.h"

static size_t scene_count = 4; /* number of scenes of each kind */
/* The scene around the camera: the inside of a shell, or a solid of the mesh and a
 * ball, which is completely invisible. */
static enum { SHELL, BALL_WITHIN, BALL_APART } sight;
static struct net net;
static char text[1 << 18];

static void set_size(size_t width, size_t height)
{
    traced.width = width;
    traced.height = height;
    traced.pixels = width * height;
}

/* Either no pixel or every pixel shows the background, in every method of tracing. */
static void check_closed(void)
{
    FREED struct words *words = same_frame(text);
    for (size_t k = 0; k < traced.pixels; k++)
        if ((c205_to_integer(words->channel[CHANNEL_ID][k]) == 0) == (sight == SHELL))
            fail_msg("pixel %zu of %zu by %zu: a ray slips out of\n%s", k, traced.width,
                     traced.height, text);
    check_paper_stage(text, words);
}

static void add_vector(const char *name, const double vector[3])
{
    add_text(text, sizeof text, "%s <%.17g, %.17g, %.17g> ", name, vector[0], vector[1],
             vector[2]);
}

static void begin_scene(const double location[3], const double ahead[3],
                        const double right[3], const double up[3])
{
    strcpy(text, HEAD "camera { ");
    add_vector("location", location);
    add_vector("direction", ahead);
    add_vector("right", right);
    add_vector("up", up);
    add_text(text, sizeof text, "}\n");
}

/* Begins a mesh of a given scale. It contains the ball, or is separate from it. */
static void begin_mesh(const double location[3], double scale)
{
    if (sight == SHELL)
        return;
    add_text(text, sizeof text, "%s { sphere {",
             sight == BALL_WITHIN ? "difference" : "intersection");
    add_vector("", location);
    add_text(text, sizeof text, ", %.17g }\n", .05 * scale);
}

static void inside_vector(void)
{
    if (sight != SHELL)
        add_vector("inside_vector", (double[]){ .3, .8, .1 });
}

static void end_mesh(void)
{
    add_text(text, sizeof text, sight == SHELL ? "}\n" : "} }\n");
}

/* Writes a closed mesh at a random position and scale. */
static void write_closed(void)
{
    double scale = pow(10, between(-2, 3)), location[3], by[3], ahead[3];
    static const double right[3] = { 3, 0, 0 }, up[3] = { 0, 3, 0 };
    net_random_body(&net, 1 + below(2), &traced.random);
    if (below(3) == 0)
        net_smooth(&net, .3, &traced.random);
    net_shuffle(&net, &traced.random);
    for (int i = 0; i < 3; i++) {
        by[i] = scale * between(-9, 9);
        location[i] = by[i] + scale * between(-.1, .1);
        ahead[i] = between(-1, 1);
    }
    begin_scene(location, ahead, right, up);
    begin_mesh(location, scale);
    net_text(&net, text, sizeof text, &traced.random);
    inside_vector();
    add_text(text, sizeof text, "scale %.17g translate <%.17g, %.17g, %.17g> ", scale,
             by[0], by[1], by[2]);
    end_mesh();
}

TEST(closed)
{
    static const size_t sizes[][2] = { { WIDTH, HEIGHT }, { 17, 9 }, { 40, 3 } };
    for (size_t i = 0; i < 3 * scene_count; i++) {
        set_size(sizes[i % 3][0], sizes[i % 3][1]);
        write_closed();
        check_closed();
    }
}

/* The camera looks from the middle of a body along an axis, at the middle of an edge,
 * or at a corner. The direction leads to a neighbour of a cube in a grid of cubes. A
 * cube has 26 neighbours. Index 13 is the cube itself. */
static void write_symmetric(size_t neighbour, const double middle[3])
{
    double ahead[3] = { (double)(neighbour % 3) - 1, (double)(neighbour / 3 % 3) - 1,
                        (double)(neighbour / 9) - 1 };
    double aside[3] = { 0, 0, 0 }, right[3], up[3];
    size_t axis = 0;
    while (ahead[axis] == 0)
        axis++;
    aside[(axis + 1) % 3] = 1;
    cross_product(ahead, aside, right);
    cross_product(right, ahead, up);
    begin_scene(middle, ahead, right, up);
    begin_mesh(middle, 4);
    net_mesh_text(&net, text, sizeof text);
    inside_vector();
    end_mesh();
}

TEST(symmetric)
{
    static const double middle[3] = { 5, -3, 8 };
    for (size_t i = 0; i < 27; i++)
        for (size_t body = 0; body < 2; body++) {
            if (i == 13)
                continue;
            net_take(&net, body ? BOX : OCTAHEDRON);
            if (i % 2)
                net_divide(&net);
            net_move(&net, 4, middle);
            set_size(i % 4 ? 9 : 1, i % 4 ? 9 : 1);
            write_symmetric(i, middle);
            check_closed();
        }
}

/* The camera looks from the middle of a cube at one side, with a ray to each integer
 * point of the side. The points of the mesh may be moved along the rays. */
static void write_whole(size_t side, const double middle[3])
{
    double ahead[3] = { 0, 0, 0 }, right[3] = { 0, 0, 0 }, up[3] = { 0, 0, 0 };
    size_t axis = side / 2;
    ahead[axis] = side % 2 ? -16 : 16;
    right[(axis + 1) % 3] = 32;
    up[(axis + 2) % 3] = 32;
    ahead[(axis + 1) % 3] = ahead[(axis + 2) % 3] = .5;
    begin_scene(middle, ahead, right, up);
    begin_mesh(middle, 16);
    net_mesh2_text(&net, text, sizeof text);
    inside_vector();
    end_mesh();
}

TEST(rays_to_points)
{
    static const double middle[3] = { 3, -40, 7 };
    set_size(32, 32);
    for (size_t side = 0; side < 6; side++) {
        net_cube(&net, 16, side % 2 ? 8 : 4, &traced.random);
        net_stretch(&net, .5, 2, .125, &traced.random);
        net_shuffle(&net, &traced.random);
        net_move(&net, 1, middle);
        write_whole(side, middle);
        check_closed();
    }
}

/* The rays of the first row hit points of a face's edge, including ends and midpoint.
 * The rays of the first column and of a diagonal hit the other two edges. */
static void write_aimed(const size_t face[3], const double location[3], double scale)
{
    double stretch = (double)traced.width / (double)(traced.width - 1);
    double half = .5 - .5 / (double)traced.width;
    double right[3], up[3], ahead[3];
    for (int i = 0; i < 3; i++) {
        double a = net.points[face[0]][i];
        right[i] = stretch * (net.points[face[1]][i] - a);
        up[i] = stretch * (a - net.points[face[2]][i]);
        ahead[i] = a - location[i] + half * right[i] - half * up[i];
    }
    begin_scene(location, ahead, right, up);
    begin_mesh(location, scale);
    net_mesh_text(&net, text, sizeof text);
    inside_vector();
    end_mesh();
}

/* Aims rays at edges of bodies. From outside they pass through a body. */
static void check_edges(bool outside)
{
    set_size(9, 9);
    for (size_t i = 0; i < 3 * scene_count; i++) {
        double scale = pow(10, between(-2, 3)), by[3], location[3];
        net_random_body(&net, 1 + i % 2, &traced.random);
        for (int k = 0; k < 3; k++) {
            by[k] = i % 3 ? scale * between(-9, 9) : 0;
            location[k] = by[k] + (!outside && i % 3 ? scale * between(-.1, .1) : 0);
        }
        if (outside)
            location[i % 3] += scale * (i % 2 ? 12 : -12);
        net_move(&net, scale, by);
        for (int tries = 0; tries < 3; tries++) {
            write_aimed(net.faces[below(net.face_count)], location, scale);
            check_closed();
        }
    }
}

TEST_CALL(rays_along_edges, check_edges(false))

FIXTURE(look_at_shell)
{
    sight = SHELL;
    return 0;
}

TEST_WITH(rays_from_outside, NULL, look_at_shell)
{
    sight = BALL_APART;
    check_edges(true);
}

TEST_WITH(solids, NULL, look_at_shell)
{
    sight = BALL_WITHIN;
    test_symmetric(test_state);
    test_rays_to_points(test_state);
    test_rays_along_edges(test_state);
    test_closed(test_state);
}

COUNT_AND_SEED(scene_count, traced.random);
