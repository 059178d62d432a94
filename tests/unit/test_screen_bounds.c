/* test_screen_bounds.c - the traversal of a mesh by windows must reach the triangles at
 * which rays through a viewpoint are aimed. Frames by windows are compared with frames
 * by boxes, over random meshes, viewpoints and lights. A window that is too small, or
 * is used for rays that miss the viewpoint, fails here.
 *
 *     test_screen_bounds [SCENES [SEED]]
 */
#define SMALL_FRAMES
#include "rt/layout/find_viewpoints.h"
#include "rt/bvh/mesh_hierarchy.h"
#include "rt/shapes/shape_words.h"
#include "tests/unit/random_mesh.h"
#include "tests/unit/random_solids.h"

static size_t scene_count = 12;
static struct net net;
static char text[1 << 20];

/* ---- Table lookups -------------------------------------------------------- */

/* Offsets in the table, as in records.s. */
enum {
    TABLE_VIEWPOINTS = 22,
    TABLE_VIEWPOINT_COUNT,
    VIEWPOINT_AXIS = 3,
    VIEWPOINT_SIGN,
    VIEWPOINT_FAR,
    VIEWPOINT_BOUNDS,
    VIEWPOINT_ROW,
    SCREEN_NEAR = 4,
    SCREEN_LINKS,
    SCREEN_FIRST = 7,
    SCREEN_COUNT
};
#define MET 0x1p40

/* A point as seen from a viewpoint: u and v are the slopes of the ray to the point, z
 * is its depth along the view axis. */
struct screen_point {
    double u, v, z;
};

static struct screen_point project(const double *eye, const double point[3])
{
    int w = (int)eye[VIEWPOINT_AXIS], u = (w + 1) % 3, v = (w + 2) % 3;
    double z = eye[VIEWPOINT_SIGN] * (point[w] - eye[w]);
    return (struct screen_point){ (point[u] - eye[u]) / z, (point[v] - eye[v]) / z, z };
}

/* Returns true if the triangle is reached. Adds the tested windows to *asked. */
static bool traversal_reaches(const double *table, const double *eye,
                              const struct screen_point *look, double triangle,
                              double row, size_t *asked)
{
    const double *rows = table + (size_t)eye[VIEWPOINT_BOUNDS];
    bool found = false;
    for (double at = 9; at != 0;) {
        const double *window = rows + (size_t)at;
        bool within = window[0] <= look->u && look->u <= window[1]
                      && window[2] <= look->v && look->v <= window[3]
                      && window[SCREEN_NEAR] < look->z;
        at = window[SCREEN_LINKS + !within];
        ++*asked;
        if (at < MET)
            continue;
        at -= MET;
        for (double i = 0; i < window[SCREEN_COUNT]; i++)
            found = found || window[SCREEN_FIRST] + row * i == triangle;
    }
    return found;
}

/* ---- Meshes and viewpoints ------------------------------------------------ */

static void random_net(void)
{
    switch (below(5)) {
    case 0: net_random_body(&net, 1 + below(3), &traced.random); break;
    case 1: net_sheet(&net, among(2, 12), .3, &traced.random); break;
    case 2: net_soup(&net, among(3, 200), below(2), &traced.random); break;
    case 3: net_cube(&net, 1, among(1, 6), &traced.random); break;
    default: net_fan(&net, among(3, 60), between(.2, 1), between(-1, 1));
    }
    if (below(3) == 0)
        net_shuffle(&net, &traced.random);
}

/* Makes a point outside or inside the mesh, near or far, integer or not. */
static void random_place(double place[3])
{
    double reach = below(4) ? between(1.2, 6) : pow(10, between(-2, 2));
    for (int k = 0; k < 3; k++) {
        place[k] = between(-1, 1) * reach;
        if (below(3) == 0)
            place[k] = round(place[k]);
    }
}

/* Returns a random corner, point of an edge or interior point. */
static void random_point(const double *corners, double point[3])
{
    double a = between(0, 1), b = between(0, 1 - a);
    size_t sort = below(3);
    if (sort == 0)
        a = (double)below(2), b = 0;
    if (sort == 1)
        b = 0;
    for (int k = 0; k < 3; k++)
        point[k] = corners[k] + a * (corners[3 + k] - corners[k])
                   + b * (corners[6 + k] - corners[k]);
}

/* Aims a ray at every triangle. Returns the mean number of tested windows. */
static double check_viewpoint(const struct primitive *mesh, const double *table,
                              const double *eye, double row)
{
    size_t count = mesh->shape.mesh.triangles.count, asked = 0;
    double first = 25. * (double)(mesh_hierarchy_nodes(count) + 1);
    for (size_t i = 0; i < count; i++) {
        double place = first + row * (double)i, point[3];
        random_point(table + (size_t)place, point);
        struct screen_point look = project(eye, point);
        assert_true(look.z > 0);
        FAIL_IF(!traversal_reaches(table, eye, &look, place, row, &asked),
                "from %.17g, %.17g, %.17g a ray to %.17g, %.17g, %.17g "
                "does not come to triangle %zu of %zu",
                eye[0], eye[1], eye[2], point[0], point[1], point[2], i, count);
    }
    return (double)asked / (double)count;
}

static bool is_inside(const double place[3], const double *table, double row,
                      size_t triangles)
{
    double first = 25. * (double)(mesh_hierarchy_nodes(triangles) + 1);
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < 3 * triangles; i++) {
            const double *corner = table + (size_t)first + (size_t)row * (i / 3)
                                   + i % 3 * 3;
            low = fmin(low, corner[k]);
            high = fmax(high, corner[k]);
        }
        if (place[k] < low || place[k] > high)
            return false;
    }
    return true;
}

/* Makes a primitive of the mesh without a transform. */
static void take_primitive(struct primitive *mesh)
{
    static const struct transform nowhere = {
        { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } }
    };
    net_primitive(&net, mesh);
    mesh->to_world = mesh->to_local = nowhere;
}

/* Checks three viewpoints of a mesh at a random scale and position. */
static void check_net(size_t *seeing, size_t *within)
{
    struct viewpoints viewpoints = { .count = 3 };
    struct primitive mesh;
    double scale = pow(10, between(-3, 3)), by[3];
    double row = 13;
    for (int k = 0; k < 3; k++)
        by[k] = below(2) ? 0 : between(-50, 50);
    random_net();
    for (size_t i = 0; i < viewpoints.count; i++) {
        random_place(viewpoints.places[i]);
        for (int k = 0; k < 3; k++)
            viewpoints.places[i][k] = scale * (viewpoints.places[i][k] + by[k]);
    }
    for (int k = 0; k < 3; k++)
        by[k] *= scale;
    net_move(&net, scale, by);
    take_primitive(&mesh);
    size_t count = shape_table_count(&mesh, &viewpoints);
    FREED double *table = NON_NULL(shape_table(&mesh, &viewpoints, count));
    if (net.smooth)
        row = 21;
    for (size_t i = 0; i < table[TABLE_VIEWPOINT_COUNT]; i++) {
        const double *eye = table + (size_t)table[TABLE_VIEWPOINTS] + VIEWPOINT_ROW * i;
        assert_true(eye[VIEWPOINT_BOUNDS] < (double)count);
        assert_false(is_inside(eye, table, row, mesh.shape.mesh.triangles.count));
        check_viewpoint(&mesh, table, eye, row);
    }
    for (size_t i = 0; i < viewpoints.count; i++)
        *within += is_inside(viewpoints.places[i], table, row,
                             mesh.shape.mesh.triangles.count);
    *seeing += (size_t)table[TABLE_VIEWPOINT_COUNT];
    free(mesh.shape.mesh.triangles.list);
}

/* Most viewpoints outside of a mesh have windows. */
TEST(ways)
{
    size_t seeing = 0, within = 0, nets = 40 * scene_count;
    for (size_t i = 0; i < nets; i++)
        check_net(&seeing, &within);
    assert_true(within > nets / 40);
    assert_true(seeing > (3 * nets - within) * 3 / 4);
}

/* A ray at a ball of many triangles tests few windows. */
TEST(few_are_asked)
{
    struct viewpoints viewpoints = { 1, { { 1, 2, -9 } } };
    struct primitive mesh;
    net_take(&net, OCTAHEDRON);
    for (int i = 0; i < 3; i++)
        net_divide(&net);
    take_primitive(&mesh);
    FREED double *table = NON_NULL(
        shape_table(&mesh, &viewpoints, shape_table_count(&mesh, &viewpoints)));
    assert_int_equal((int)table[TABLE_VIEWPOINT_COUNT], 1);
    assert_in_range((int)check_viewpoint(&mesh, table,
                                         table + (size_t)table[TABLE_VIEWPOINTS], 13),
                    8, 48);
    free(mesh.shape.mesh.triangles.list);
}

/* ---- Frames --------------------------------------------------------------- */

static void add_vector(const char *name, const double vector[3])
{
    add_text(text, sizeof text, "%s <%.17g, %.17g, %.17g> ", name, vector[0], vector[1],
             vector[2]);
}

/* Adds lights of all kinds. Some are at the same position. */
static void add_lights(void)
{
    static const char *const sorts[] = {
        "parallel point_at <.1, .2, .3>", "area_light <1, 0, 0>, <0, 1, 0>, 2, 2",
        "spotlight point_at <.13, .27, .41> radius 20 falloff 40", "shadowless"
    };
    double place[3];
    random_place(place);
    for (size_t i = among(1, 5); i > 0; i--) {
        if (below(3))
            random_place(place);
        add_vector("light_source {", place);
        size_t sort = below(2 * COUNT(sorts));
        add_text(text, sizeof text, ", rgb %.3f %s }\n", between(.1, .6),
                 sort < COUNT(sorts) ? "" : sorts[sort - COUNT(sorts)]);
    }
}

static void put_mesh(void)
{
    if (below(4) == 0)
        net_smooth(&net, .3, &traced.random);
    net_text(&net, text, sizeof text, &traced.random);
    add_random(text, sizeof text, "pigment { rgb <^2.2:1^, .5, .8> }");
    if (below(3) == 0)
        add_text(text, sizeof text, " finish { reflection .4 }");
    add_text(text, sizeof text, " }\n");
}

/* Writes meshes, and distant objects and a mirror behind them, so that rays come from
 * all directions. `camera` has further words of the camera. */
static void write_scene(const char *camera)
{
    double place[3];
    strcpy(text, "#version 3.7; global_settings { assumed_gamma 1 }\n");
    random_place(place);
    add_vector("#declare Eye =", place);
    add_random(text, sizeof text,
               ";\ncamera { location Eye angle ^320:90^ %s look_at "
               "<^3-.5:.5^, ^3-.5:.5^, ^3-.5:.5^> }\n",
               camera);
    add_lights();
    for (size_t i = among(1, 2); i > 0; i--) {
        random_net();
        put_mesh();
    }
    if (below(2))
        add_random(text, sizeof text, "plane { y, ^3-4:-1^ pigment { rgb .7 } }\n");
    if (below(2))
        add_random(
            text, sizeof text,
            "sphere { <^3p-2:2^, ^3p-2:2^, ^3p-2:2^>, .6 pigment { rgb .3 } finish "
            "{ reflection .6 } }\n");
}

/* Compares the frames of all forms with a variant of the kernels. If the variant is
 * NULL, compares them with runs without bounds. Returns the number of hit pixels. */
static size_t check_frame(const char *variant)
{
    FREED struct words *words = same_frame(text);
    check_paper_stage(text, words);
    traced.variant = variant;
    traced.no_bounds = !variant;
    FREED struct words *others = same_frame(text);
    traced.variant = NULL;
    traced.no_bounds = false;
    FAIL_IF(memcmp(words, others, sizeof *words) != 0, "%s: another frame of\n%s",
            variant ? variant : "no bounds", text);
    return hits(words);
}

TEST(frames)
{
    size_t seen = 0;
    traced.reported = true;
    for (size_t i = 0; i < scene_count; i++) {
        write_scene(below(8) ? "" : "orthographic");
        seen += check_frame("MESH_BOXES");
    }
    assert_true(seen > scene_count * traced.pixels / 4);
}

/* Writes meshes in front of the camera. One light is at the camera. Another light is at
 * the position that equals the camera's direction vector, because the kernels store
 * this vector in place of the location of an orthographic camera. */
static void write_before_camera(const char *camera)
{
    const double by[3] = { 0, 0, 6 };
    strcpy(text, "#version 3.7; global_settings { assumed_gamma 1 }\n");
    add_random(text, sizeof text,
               "#declare Eye = <^3-1:1^, ^3-1:1^, -2>;\n"
               "camera { %s location Eye direction z right 2*x up 2*y }\n"
               "light_source { Eye, .5 }\nlight_source { z, .5 }\n",
               camera);
    for (size_t i = among(1, 2); i > 0; i--) {
        random_net();
        net_move(&net, 1, by);
        put_mesh();
    }
    add_random(text, sizeof text,
               "plane { z, 9 pigment { rgb .7 } }\n"
               "sphere { <^3p-2:2^, ^3p-2:2^, 7>, .6 pigment { rgb .3 } finish "
               "{ reflection .6 } }\n");
}

/* The rays of these cameras do not pass through one point, but the rays to a light
 * do. */
TEST(other_cameras)
{
    static const char *const cameras[] = {
        "orthographic", "aperture 2 focal_point 5*z blur_samples 4",
        "orthographic aperture 2 focal_point 5*z blur_samples 4"
    };
    traced.reported = true;
    for (size_t i = 0; i < COUNT(cameras); i++)
        for (size_t k = 0; k < scene_count / 3; k++) {
            traced.samples = i ? 2 : 1;
            write_before_camera(cameras[i]);
            check_frame("MESH_BOXES");
        }
    traced.samples = 1;
}

/* Useless viewpoints are not recorded, because their windows need memory. */
TEST(places)
{
    static const struct {
        const char *camera, *light;
        size_t count;
    } cases[] = {
        { "", "", 2 },
        { "orthographic", "", 1 },
        { "aperture 2 focal_point 0", "", 1 },
        { "", "parallel point_at 0", 1 },
        { "", "shadowless", 1 },
        { "", "area_light x, y, 2, 2", 1 },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        struct viewpoints viewpoints;
        sprintf(text,
                "#version 3.7; global_settings { assumed_gamma 1 }\n"
                "camera { %s location -3*z look_at 0 }\n"
                "light_source { 9*y, 1 %s }\nsphere { 0, 1 }\n",
                cases[i].camera, cases[i].light);
        SCOPED(scene) *scene = read_text(text);
        viewpoints_find(scene, &viewpoints);
        assert_int_equal(viewpoints.count, cases[i].count);
    }
}

/* ---- Edge-on ---------------------------------------------------------------- */

/* Adds a triangle in a plane of the viewpoint, mostly without integers. */
static void add_edge_on(const double eye[3])
{
    double corners[3][3];
    for (int k = 0; k < 3; k++) {
        corners[0][k] = round(between(-40, 40)) / 20;
        corners[1][k] = round(between(-40, 40)) / 20;
    }
    for (int k = 0; k < 3; k++)
        corners[2][k] = corners[0][k] + .25 * (corners[1][k] - corners[0][k])
                        + .5 * (eye[k] - corners[0][k]);
    add_text(text, sizeof text, "triangle {");
    for (int i = 0; i < 3; i++)
        add_vector(i > 0 ? "," : "", corners[i]);
    add_text(text, sizeof text, "}\n");
}

/* Writes a lamp and an area light in one place, and near and very distant objects. */
static void write_edge_on(void)
{
    double eye[3], light[3];
    strcpy(text, "#version 3.7; global_settings { assumed_gamma 1 }\n");
    for (int k = 0; k < 3; k++) {
        eye[k] = round(between(-5, 5));
        light[k] = round(between(-9, 9)) / 2 + (k == 1 ? 6 : 0);
    }
    eye[2] -= 6;
    add_vector("camera { location", eye);
    add_text(text, sizeof text, "look_at 0 angle 50 }\n");
    add_vector("light_source {", light);
    add_text(text, sizeof text, ", rgb .2 }\n");
    add_vector("light_source {", light);
    add_text(text, sizeof text,
             ", rgb .6 area_light <1, 0, 0>, <0, 0, 1>, 3, 3 }\nmesh {\n");
    for (size_t i = among(1, 6); i > 0; i--)
        add_edge_on(below(2) ? eye : light);
    add_text(text, sizeof text,
             "pigment { rgb 1 } }\n"
             "intersection { plane { y, -6 } plane { x, 5 } pigment { rgb 1 } }\n"
             "plane { y, -9000 pigment { rgb 1 } }\n");
}

/* Rounding decides hits in a triangle's plane. All stages must decide the same. */
TEST(edge_on)
{
    for (size_t i = 0; i < scene_count; i++) {
        write_edge_on();
        check_frame(NULL);
    }
}

/* A scene that has failed: the centre of the area light is at the other light, and rays
 * from the lower plane start far away. */
TEST(known)
{
    strcpy(text, "#version 3.7; global_settings { assumed_gamma 1 }\n"
                 "camera { location <2.5, 8, 10> look_at <-1.5, .5, 2> angle 50 }\n"
                 "light_source { <1.5, 5, 8>, rgb .1 }\n"
                 "light_source { <1.5, 5, 8>, rgb 1\n"
                 "    area_light <1, 0, 0>, <0, 0, 1>, 3, 3 }\n"
                 "mesh {\n"
                 "    triangle { <-2, -1, 0>, <-1, .8, 3>, <.1, 3, 5> }\n"
                 "    triangle { <-2.1, -.6, .8>, <-1.5, .6, 2>, <-1.7, .4, 1.6> }\n"
                 "    pigment { rgb 1 }\n"
                 "}\n"
                 "intersection { plane { y, -6 } plane { x, 5 } pigment { rgb 1 } }\n"
                 "plane { y, -9000 pigment { rgb 1 } }\n");
    traced.width = 41;
    traced.height = 31;
    traced.pixels = traced.width * traced.height;
    check_frame(NULL);
    traced.width = WIDTH;
    traced.height = HEIGHT;
    traced.pixels = PIXELS;
}

/* ---- Clocks --------------------------------------------------------------- */

static uint64_t clocks_of(const struct scene *scene, enum trace_mode mode,
                          const char *variant)
{
    struct trace_options options = ON_PRIOR(.mode = mode, .queue = TRACE_QUEUE,
                                            .width = 48, .height = 36,
                                            .variant = variant);
    SCOPED(trace) *trace = run_trace(scene, &options);
    return trace_accounts(trace)->clocks;
}

/* Compares the clocks of windows and of boxes, without and with rays to a light. */
TEST(clocks)
{
    static const char *const lights[] = { " shadowless", "" };
    uint64_t windows[2], boxes[2];
    net_take(&net, OCTAHEDRON);
    for (int i = 0; i < 3; i++)
        net_divide(&net);
    net_stretch(&net, .9, 1.1, 0, &traced.random);
    for (int mode = 0; mode < 2; mode++) {
        for (int i = 0; i < 2; i++) {
            sprintf(text,
                    "#version 3.7; global_settings { assumed_gamma 1 }\n"
                    "camera { location <0, 1, -3> look_at 0 angle 44 }\n"
                    "light_source { <-4, 3, -2>, rgb 1 %s }\n",
                    lights[i]);
            net_mesh_text(&net, text, sizeof text);
            add_text(text, sizeof text, "pigment { rgb 1 } }\n");
            SCOPED(scene) *scene = read_text(text);
            windows[i] = clocks_of(scene, mode ? TRACE_VECTOR : TRACE_SCALAR, NULL);
            boxes[i] = clocks_of(scene, mode ? TRACE_VECTOR : TRACE_SCALAR,
                                 "MESH_BOXES");
        }
        assert_true(windows[0] < boxes[0] * 9 / 10);
        assert_true(windows[1] - windows[0] < (boxes[1] - boxes[0]) * 9 / 10);
    }
}

/* Slender oblique triangles fill a small part of their windows. */
TEST(where_they_do_not_pay)
{
    struct viewpoints viewpoints = { 1, { { -6, 8, -6 } } };
    struct triangle blades[100] = { { .smooth = false } };
    struct primitive mesh = { .kind = PRIMITIVE_MESH };
    take_primitive(&mesh);
    free(mesh.shape.mesh.triangles.list);
    for (int i = 0; i < 100; i++) {
        double x = .2 * (i % 10), z = .2 * (double)(i / 10);
        blades[i] = (struct triangle){
            .corners = { { x - .01, 0, z + .01 }, { x + .01, 0, z - .01 }, { x, 2, z } }
        };
    }
    mesh.shape.mesh.triangles.list = blades;
    mesh.shape.mesh.triangles.count = 100;
    FREED double *table = NON_NULL(
        shape_table(&mesh, &viewpoints, shape_table_count(&mesh, &viewpoints)));
    assert_int_equal((int)table[TABLE_VIEWPOINT_COUNT], 0);
}

/* Two lights are at the same position, and one of them has parallel rays. A third light
 * is inside the mesh, in front of its far side. */
TEST(lights)
{
    for (int i = 0; i < 3; i++) {
        net_random_body(&net, 1, &traced.random);
        strcpy(text, "#version 3.7; global_settings { assumed_gamma 1 }\n"
                     "camera { location <1, 3, -5> look_at <0, -.5, 0> angle 50 }\n"
                     "light_source { <-4, 3, -2>, rgb .4 }\n"
                     "light_source { <-4, 3, -2>, rgb .4 parallel point_at 0 }\n"
                     "light_source { <.1, .2, .1>, rgb .3 }\n");
        net_text(&net, text, sizeof text, &traced.random);
        add_text(text, sizeof text,
                 "pigment { rgb 1 } }\n"
                 "plane { y, -1.5 pigment { rgb .7 } }\n"
                 "sphere { <.1, .5, .2>, .12 pigment { rgb 1 } }\n");
        check_frame(NULL);
    }
}

COUNT_AND_SEED(scene_count, traced.random);
