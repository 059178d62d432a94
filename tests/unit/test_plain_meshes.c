/* test_plain_meshes.c - lines that cross meshes. The plain tracer's crossings are
 * compared with random points, volumes in closed form and closed bodies. A line that
 * passes between triangles, or a wrong normal, fails here. */
#include "tests/unit/random_mesh.h"
#include "tests/unit/plain_surface.h"

static struct net net;

static struct surface mesh_of(const struct triangle *triangles, size_t count)
{
    struct surface surface = one(PRIMITIVE_MESH);
    surface.parts[0].shape.mesh.triangles.list = (struct triangle *)triangles;
    surface.parts[0].shape.mesh.triangles.count = count;
    return surface;
}

/* ---- One triangle -------------------------------------------------------- */

/* Normals of different lengths tilt outwards by 45 degrees at two corners. */
TEST(known_smooth)
{
    static const struct triangle smooth = {
        .corners = { { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 0 } },
        .normals = { { 1, 0, 1 }, { 0, 7, 7 }, { 0, 0, .1 } },
        .smooth = true
    };
    double h = sqrt(.5), m = hypot(h / 2, (1 + h) / 2);
    const struct expectation rows[] = {
        { { 4, 0, 5 }, { 0, 0, -1 }, 5, { h, 0, h } },
        { { 0, 4, 5 }, { 0, 0, -1 }, 5, { 0, h, h } },
        { { 0, 0, 5 }, { 0, 0, -1 }, 5, { 0, 0, 1 } },
        { { 0, 0, -5 }, { 0, 0, 1 }, 5, { 0, 0, -1 } },
        { { 2, 0, 5 }, { 0, 0, -1 }, 5, { h / 2 / m, 0, (1 + h) / 2 / m } },
        { { 2, 2, 5 }, { 0, 0, -1 }, 5, { 1 / sqrt(6), 1 / sqrt(6), 2 / sqrt(6) } },
    };
    struct surface surface = mesh_of(&smooth, 1);
    ASSERT_HITS(&surface, rows);
}

static void random_triangle(uint64_t *random, struct triangle *triangle)
{
    triangle->smooth = xorshift(random) % 2;
    for (int k = 0; k < 3; k++) {
        random_direction(random, triangle->corners[k]);
        for (int i = 0; i < 3; i++)
            triangle->normals[k][i] = number_between(random, .2, 1);
        normalise(triangle->normals[k]);
    }
}

/* Makes barycentric coordinates: all above `least`, or one below -least. */
static void random_shares(uint64_t *random, bool within, double shares[3])
{
    static const double least = 1e-6;
    do {
        shares[0] = number_between(random, -1, 1);
        shares[1] = number_between(random, -1, 1);
        shares[2] = 1 - shares[0] - shares[1];
    } while (within != (shares[0] > least && shares[1] > least && shares[2] > least)
             || fabs(shares[0]) < least || fabs(shares[1]) < least
             || fabs(shares[2]) < least);
}

static void mixed(const double corners[3][3], const double shares[3], double point[3])
{
    memset(point, 0, 3 * sizeof *point);
    for (int k = 0; k < 3; k++)
        add_scaled(point, point, shares[k], corners[k]);
}

/* The normal of a flat triangle must be perpendicular to two edges. */
static void assert_normal(const struct triangle *triangle, const double shares[3],
                          const double found[3])
{
    double way[3];
    if (triangle->smooth) {
        mixed(triangle->normals, shares, way);
        assert_near(fabs(dot(found, way)) / sqrt(dot(found, found) * dot(way, way)), 1,
                    1e-9);
        return;
    }
    for (int k = 1; k < 3; k++) {
        add_scaled(way, triangle->corners[k], -1, triangle->corners[0]);
        assert_near(dot(way, found), 0, 1e-12);
    }
}

/* Makes a random point, and a ray that reaches it at distance 1.5. */
static void assert_there_and_back(uint64_t *random, const struct triangle *triangle)
{
    struct surface surface = mesh_of(triangle, 1);
    bool within = xorshift(random) % 2;
    double shares[3], point[3];
    struct ray ray;
    random_shares(random, within, shares);
    mixed(triangle->corners, shares, point);
    random_direction(random, ray.direction);
    add_scaled(ray.origin, point, -1.5, ray.direction);
    struct spelling found = shoot(&surface, &ray);
    if (within) {
        assert_near(found.distance, 1.5, 1e-9);
        assert_normal(triangle, shares, found.normal);
    } else {
        assert_true(isinf(found.distance));
    }
}

TEST(there_and_back)
{
    uint64_t random = RANDOM_SEED;
    for (int i = 0; i < 20000; i++) {
        struct triangle triangle;
        random_triangle(&random, &triangle);
        assert_there_and_back(&random, &triangle);
    }
}

/* ---- Closed bodies ------------------------------------------------------- */

/* The line starts in a star-shaped body: one crossing is ahead, one behind. */
static void assert_two(const struct primitive *mesh, const double from[3],
                       const double to[3])
{
    struct crossing crossings[MAX_CROSSINGS];
    struct ray ray;
    copy(ray.origin, from);
    add_scaled(ray.direction, to, -1, from);
    assert_int_equal(plain_crossings(mesh, &ray, crossings), 2);
    assert_true(crossings[0].distance > 0);
    assert_true(crossings[1].distance < 0);
}

/* Aims lines at the points, and at points of the edges including their midpoints. */
static void assert_closed(uint64_t *random, const struct primitive *mesh,
                          const double from[3])
{
    for (size_t i = 0; i < 3 * net.face_count; i++) {
        const double *a = net.points[net.faces[i / 3][i % 3]];
        const double *b = net.points[net.faces[i / 3][(i + 1) % 3]];
        double to[3];
        assert_two(mesh, from, a);
        for (int k = 0; k < 2; k++) {
            double share = k == 0 ? .5 : number_between(random, 0, 1);
            for (int axis = 0; axis < 3; axis++)
                to[axis] = a[axis] + share * (b[axis] - a[axis]);
            assert_two(mesh, from, to);
        }
        random_direction(random, to);
        assert_two(mesh, from, to);
    }
}

static void random_body(uint64_t *random, size_t i)
{
    net_take(&net, (enum net_body)(i % NET_BODIES));
    net_divide(&net);
    if (i % 2)
        net_divide(&net);
    net_stretch(&net, .9, 1.1, i % 3 == 0 ? 1. / 64 : 0, random);
}

TEST(closed)
{
    uint64_t random = RANDOM_SEED;
    for (size_t i = 0; i < 24; i++) {
        static const double origin[3];
        double by[3], scale = pow(10, number_between(&random, -3, 3));
        struct primitive mesh;
        random_body(&random, i);
        random_direction(&random, by);
        scale_by(by, i % 4 ? 3 * scale : 0);
        net_move(&net, scale, by);
        net_primitive(&net, &mesh);
        assert_closed(&random, &mesh, i % 4 ? by : origin);
        free(mesh.shape.mesh.triangles.list);
    }
}

static double volume_of(enum net_body body, size_t times)
{
    struct surface surface = one(PRIMITIVE_MESH);
    net_take(&net, body);
    for (size_t i = 0; i < times; i++)
        net_divide(&net);
    net_primitive(&net, &surface.parts[0]);
    double found = volume(&surface, 1.99);
    free(surface.parts[0].shape.mesh.triangles.list);
    return found;
}

TEST(volumes)
{
    assert_near(volume_of(OCTAHEDRON, 0), 4. / 3, 2e-3);
    assert_near(volume_of(OCTAHEDRON, 1), 4. / 3, 2e-3);
    assert_near(volume_of(ICOSAHEDRON, 0), 10. / 3 * (3 + sqrt(5)), 2e-2);
}

TEST(box)
{
    struct surface box = one(PRIMITIVE_BOX), mesh = one(PRIMITIVE_MESH);
    for (int i = 0; i < 3; i++) {
        box.parts[0].shape.box.corner[0][i] = -1;
        box.parts[0].shape.box.corner[1][i] = 1;
    }
    net_take(&net, BOX);
    net_primitive(&net, &mesh.parts[0]);
    assert_same_surface(&box, &mesh, 1.5);
    free(mesh.parts[0].shape.mesh.triangles.list);
}

/* ---- Large meshes -------------------------------------------------------- */

/* The triangles are at z = 1, 2, .. in a permuted order. A ray that starts between them
 * has more crossings on each side than there is room for. */
TEST(no_room)
{
    enum { COUNT = 151, FROM = 70 };
    static struct triangle triangles[COUNT];
    struct surface surface = mesh_of(triangles, COUNT);
    struct crossing crossings[MAX_CROSSINGS];
    const struct ray ray = { { .1, .1, FROM + .5 }, { 0, 0, 1 } };
    const struct ray back = { { .1, .1, 19.5 }, { 0, 0, -1 } };
    for (int i = 0; i < COUNT; i++) {
        double z = 1 + i * 32 % COUNT;
        triangles[i] = (struct triangle){
            .corners = { { -1, -1, z }, { 2, -1, z }, { -1, 2, z } }
        };
    }
    assert_int_equal(plain_crossings(surface.parts, &ray, crossings), MAX_CROSSINGS);
    for (int i = 0; i < MAX_CROSSINGS; i++)
        assert_near(crossings[i].distance, .5 + i, 1e-12);
    assert_int_equal(plain_crossings(surface.parts, &back, crossings), MAX_CROSSINGS);
    for (int i = 0; i < MAX_CROSSINGS; i++)
        assert_near(crossings[i].distance, i < 19 ? .5 + i : 18.5 - i, 1e-12);
}

/* Of two coincident triangles the first is hit. */
TEST(ties)
{
    struct triangle triangles[2] = {
        { .corners = { { -1, -1, 0 }, { 2, -1, 0 }, { -1, 2, 0 } } },
    };
    struct surface surface = mesh_of(triangles, 2);
    const struct ray ray = { { 0, 0, -1 }, { 0, 0, 1 } };
    triangles[1] = triangles[0];
    triangles[1].smooth = true;
    for (int k = 0; k < 3; k++)
        triangles[1].normals[k][0] = triangles[1].normals[k][2] = 1;
    assert_near(shoot(&surface, &ray).normal[0], 0, 0);
    triangles[0] = triangles[1];
    triangles[1].smooth = false;
    assert_near(shoot(&surface, &ray).normal[0], -sqrt(.5), 1e-15);
}
