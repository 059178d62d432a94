/* test_scene_meshes.c - the scene language. The triangles of triangle, smooth_triangle,
 * mesh and mesh2 are compared with expected triangles and, over random meshes, with
 * each other. A wrong index, normal or texture fails here. */
#include "tests/random.h"
#include "tests/unit/random_mesh.h"
#include "tests/unit/scene_reading.h"

#define HALF 0.70710678118654752440

/* ---- Reading ------------------------------------------------------------- */

TEST(lone_triangles)
{
    SCOPED(scene) *scene = read_scene(
        "triangle { 0, x, <1, 2, 3> scale 2 pigment { rgb y } no_shadow }\n"
        "smooth_triangle { 0, -z x, -2*z y <-3, 0, -3> rotate x }\n"
        "smooth_triangle { 0, z+x, x, z+x, y, z+x }\n"
        "#declare T = triangle { 0, x, y }\n"
        "object { T } union { object { T } triangle { 0, y, z } }\n");
    const struct triangle *first = triangles_of_part(scene, 0)->list;
    const struct triangle *smooth = triangles_of_part(scene, 1)->list;
    assert_int_equal(scene->primitive_count, 6);
    assert_int_equal(scene->region_count, 6);
    for (size_t i = 0; i < 6; i++)
        assert_int_equal(triangles_of_part(scene, i)->count, 1);
    assert_false(first->smooth);
    assert_vector(first->corners[0], 0, 0, 0);
    assert_vector(first->corners[1], 1, 0, 0);
    assert_vector(first->corners[2], 1, 2, 3);
    assert_true(scene->primitives[0].transformed);
    assert_true(scene->primitives[0].no_shadow);
    assert_vector(scene->primitives[0].pigment.color[0], 0, 1, 0);
    assert_true(smooth->smooth);
    assert_vector(smooth->corners[1], 1, 0, 0);
    assert_vector(smooth->normals[0], 0, 0, -1);
    assert_vector(smooth->normals[1], 0, 0, -1);
    assert_vector(smooth->normals[2], -HALF, 0, -HALF);
    assert_true(triangles_of_part(scene, 2)->list->smooth); /* with equal normals */
    assert_vector(triangles_of_part(scene, 2)->list->normals[1], HALF, 0, HALF);
    assert_int_equal(scene->primitives[2].line, 3);
    assert_ptr_equal(triangles_of_part(scene, 3)->list,
                     triangles_of_part(scene, 4)->list);
}

TEST(meshes)
{
    SCOPED(scene) *scene = read_scene(
        "#macro Two(A) triangle { A, x, y } triangle { A, y, z } #end\n"
        "mesh { triangle { 0, x, y uv_vectors <0, 0>, <1, 0>, <0, 1> }\n"
        "  #for (I, 1, 3) triangle { 0, x, I*z } #end Two(<1, 2, 3>)\n"
        "  smooth_triangle { 0, 2*z, x, z, y, z+x }\n"
        "  smooth_triangle { 0, 2*z, x, z, y, z }\n"
        "  triangle { 0, x, 2*x } inside_vector y\n"
        "  #declare Inner = mesh { triangle { z, x, y } }\n"
        "  triangle { x, y, z } hierarchy off hierarchy on hierarchy\n"
        "  scale 2 pigment { rgb x } sturm inverse }\n"
        "object { Inner inverse }");
    const struct triangles *triangles = triangles_of_part(scene, 0);
    const struct primitive *p = scene->primitives;
    assert_int_equal(scene->primitive_count, 2);
    assert_int_equal(triangles->count, 9); /* one triangle has no area */
    assert_vector(triangles->list[3].corners[2], 0, 0, 3);
    assert_vector(triangles->list[5].corners[0], 1, 2, 3);
    assert_true(triangles->list[6].smooth);
    assert_vector(triangles->list[6].normals[0], 0, 0, 1);
    assert_vector(triangles->list[6].normals[2], HALF, 0, HALF);
    assert_false(triangles->list[7].smooth); /* with equal normals */
    assert_false(triangles->list[8].smooth);
    assert_vector(p[0].pigment.color[0], 1, 0, 0);
    assert_true(p[0].transformed && p[0].inverted && !p[1].inverted);
    assert_true(p[0].shape.mesh.solid && !p[1].shape.mesh.solid);
    assert_int_equal(scene->node_count, 3); /* a surface is not inverted */
    assert_int_equal(scene->nodes[0].operation, TREE_NOT);
    assert_int_equal(triangles_of_part(scene, 1)->count, 1);
}

#define FOUR "mesh2 { vertex_vectors { 4, 0, x, y, z } "

TEST(mesh2)
{
    SCOPED(scene) *scene = read_scene(
        FOUR "face_indices { 2, <0, 1, 2>, <1, 2.9, 3> } }\n" FOUR
             "normal_vectors { 4, x, 2*y, z, -x }  uv_vectors { 1, <0, 1> }\n"
             "  face_indices { 2 <3, 2, 1> <-.5, 1, 3> } scale 2 }\n"
             "mesh2 { normal_vectors { 2 x y } vertex_vectors { 4 0 x y z }"
             "  uv_vectors { 0 } face_indices { 3, <0, 1, 2>, <0, 2, 3>, <1, 2, 3> }"
             "  normal_indices { 2, <0, 1, 1>, <0, 0, 0> } hierarchy off }\n" FOUR
             "normal_vectors { 4, x, 2*y, z, -x }"
             "  face_indices { 2 <3, 2, 1> <0, 1, 3> } uv_indices { 2, 0, 0 }"
             "  normal_indices { 1 <0, 2, 3> } inside_vector x inside_vector y }\n");
    const struct triangle *list = triangles_of_part(scene, 0)->list;
    assert_int_equal(scene->primitive_count, 4);
    assert_int_equal(triangles_of_part(scene, 0)->count, 2);
    assert_false(list[0].smooth || list[1].smooth);
    assert_vector(list[1].corners[0], 1, 0, 0);
    assert_vector(list[1].corners[1], 0, 1, 0);
    assert_vector(list[1].corners[2], 0, 0, 1);
    list = triangles_of_part(scene, 1)->list;
    assert_true(list[0].smooth && list[1].smooth);
    assert_vector(list[0].normals[0], -1, 0, 0);
    assert_vector(list[0].normals[2], 0, 1, 0);
    assert_vector(list[1].corners[0], 0, 0, 0);
    list = triangles_of_part(scene, 2)->list;
    assert_true(list[0].smooth);
    assert_false(list[1].smooth || list[2].smooth); /* the second triangle has equal
                                                     * normals, the third has none */
    assert_vector(list[0].normals[1], 0, 1, 0);
    list = triangles_of_part(scene, 3)->list;
    assert_true(list[0].smooth && !list[1].smooth);
    assert_vector(list[0].normals[0], 1, 0, 0);
    assert_vector(list[0].normals[2], -1, 0, 0);
}

/* As in POV-Ray, a zero normal in a mesh is replaced by x. A single triangle with such
 * a normal, or without area, is omitted. */
TEST(nothing)
{
    SCOPED(scene) *scene =
        read_with("mesh { smooth_triangle { 0, 1e-11*z, x, y, y, <1e-200, 0, 0> } }\n"
                  "mesh2 { vertex_vectors { 3 0 x y } normal_vectors { 3 0 y z }"
                  " face_indices { 1 <0, 1, 2> } }\n"
                  "smooth_triangle { 0, 1e-200*z, x, y, y, z }\n",
                  1); /* all reports have the same cause */
    const struct triangle *list = triangles_of_part(scene, 0)->list;
    assert_int_equal(scene->primitive_count, 3);
    assert_vector(list->normals[0], 1, 0, 0);
    assert_vector(list->normals[2], 1, 0, 0);
    assert_vector(triangles_of_part(scene, 1)->list->normals[0], 1, 0, 0);
    assert_vector(triangles_of_part(scene, 2)->list->normals[0], 0, 0, 1);
    static const char flat[] =
        "smooth_triangle { 0, 0, x, y, y, z pigment { rgb 1 } }\n"
        "union { triangle { 0, x, 2*x } sphere { 0, 1 } }\n"
        "triangle { 1, 1, 1 translate x inverse }\n";
    SCOPED(scene) *other = read_with(flat, 1);
    assert_int_equal(other->primitive_count, 1);
}

/* ---- Materials ----------------------------------------------------------- */

#define LOOKS \
    "#declare A = texture { pigment { rgb x } }\n" \
    "#declare B = texture { pigment { rgb y } }\n" \
    "#declare C = texture { pigment { rgb x } finish { diffuse 0 } }\n"
#define LIST \
    "mesh2 { vertex_vectors { 3, 0, x, y }\n" \
    "texture_list { 2, texture { A }, texture { B translate x } }"

/* As in POV-Ray, the texture of a triangle overrides the texture of the mesh. */
TEST(textures)
{
    static const struct {
        const char *text;
        size_t reports;
        double red, green;
    } rows[] = {
        { "mesh { triangle { 0, x, y texture { A } } }", 0, 1, 0 },
        { "mesh { triangle { 0, x, y texture { A } } triangle { 0, y, z "
          "uv_vectors 0, x, y texture { A } } texture { B } }",
          0, 1, 0 },
        { "mesh { triangle { 0, x, y texture { A } } triangle { 0, y, z "
          "texture { pigment { rgb x } } } }",
          0, 1, 0 },
        { "mesh { triangle { 0, x, y texture { A } } triangle { 0, y, z "
          "texture { B } } }",
          1, 1, 0 },
        { "mesh { triangle { 0, x, y texture { A } } triangle { 0, y, z "
          "texture { C } } }",
          1, 1, 0 },
        { "mesh { triangle { 0, x, y } triangle { 0, y, z texture { B } } }", 1, 0, 1 },
        { "mesh { triangle { 0, x, y } triangle { 0, y, z texture { B } } "
          "texture { A } }",
          1, 1, 0 },
        { "mesh { triangle { 0, x, y } triangle { 0, y, z texture { B } } "
          "pigment { rgb x } }",
          1, 1, 0 },
        { "object { mesh { triangle { 0, x, y texture { B } } } texture { A } }", 0, 0,
          1 },
        { "object { mesh { triangle { 0, x, y } } texture { A } }", 0, 1, 0 },
        { "mesh { triangle { 0, x, y texture_list { A, B C } } }", 1, 1, 0 },
        { "mesh { triangle { 0, x, y texture_list { B B B } } }", 0, 0, 1 },
        { "mesh { smooth_triangle { 0, x, x, y, y, z texture { B } } }", 0, 0, 1 },
        { LIST "face_indices { 1, <0, 1, 2> } }", 0, 0, 0 },
        { LIST "face_indices { 1, <0, 1, 2>, 1 } }", 0, 0, 1 },
        { LIST "face_indices { 1, <0, 1, 2>, 1 } texture { A } }", 0, 0, 1 },
        { LIST "face_indices { 1, <0, 1, 2>, 0, 0, 0 } }", 0, 1, 0 },
        { LIST "face_indices { 1, <0, 1, 2>, 0, 1, 0 } }", 1, 1, 0 },
        { LIST "face_indices { 2, <0, 1, 2> 1 <1, 2, 0> } }", 1, 0, 1 },
        { LIST "face_indices { 2, <0, 1, 2> <1, 2, 0>, 0 } texture { B } }", 1, 0, 1 },
        { "#declare F = <0, 1, 2>; #declare N = 1;" LIST
          "face_indices { 3, F F N F (1 - 1) } texture { A } }",
          1, 1, 0 },
        { "mesh { triangle { 0, x, y texture { pigment { rgb x } normal { "
          "bumps } } } }",
          1, 1, 0 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        char text[700];
        snprintf(text, sizeof text, LOOKS "%s", rows[i].text);
        SCOPED(scene) *scene = read_with(text, rows[i].reports);
        assert_int_equal(scene->primitive_count, 1);
        assert_vector(scene->primitives->pigment.color[0], rows[i].red, rows[i].green,
                      0);
    }
}

/* The texture of a triangle moves with the mesh. */
TEST(moved_texture)
{
    SCOPED(scene) *scene = read_scene(
        "mesh { triangle { 0, x, y texture { pigment { checker } } } translate 3*x }");
    assert_close(scene->primitives->pigment.to_local.rows[0][3], -3, CLOSE);
}

TEST(messages)
{
    static const struct place_error rows[] = {
        { LOOKS "mesh { triangle { 0, x, y texture { B } } triangle { 0, y, z "
                "texture { A } } }",
          4, 27,
          "separate textures of mesh triangles are not supported; "
          "the first one is used instead" },
        { LOOKS "mesh { triangle { 0, x, y texture { B } } triangle { 0, y, z "
                "} texture { A } }",
          4, 27, "the texture of the mesh is used instead" },
        { LOOKS LIST "\nface_indices { 2, <0, 1, 2>, 1, <0, 2, 1>, 0 } }", 6, 30,
          "the first one is used instead" },
        { "triangle { 0, x, 2*x }", 1, 1, "is ignored" },
        { "intersection { sphere { 0, 1 } mesh { triangle { 0, x, y } "
          "inside_vector 1e-11 } }",
          1, 32, "a patch in an intersection or difference has no inside" },
        { "mesh { smooth_triangle { 0, 0, x, y, y, z } }", 1, 8,
          "<1, 0, 0> is used instead" },
    };
    assert_place_errors(rows, COUNT(rows), &strict_options);
}

/* Transparent pigments of a mesh are recorded as such. */
TEST(clear)
{
    SCOPED(scene) *scene = read_scene(
        "#declare M = mesh { triangle { 0, x, y } }\n"
        "object { M pigment { checker rgb 1 rgbf 1 } }\n"
        "union { object { M } sphere { 0, 1 } pigment { rgbt .5 } }\n");
    const struct primitive *p = scene->primitives;
    assert_int_equal(scene->primitive_count, 3);
    for (size_t i = 0; i < 3; i++)
        assert_true(pigment_is_clear(&p[i].pigment));
}

/* ---- In solids ----------------------------------------------------------- */

TEST(clipped)
{
    SCOPED(scene) *scene = read_scene(
        "mesh { triangle { 0, x, y } clipped_by { mesh { triangle { 0, x, y "
        "} inside_vector y } } }");
    assert_int_equal(scene->primitive_count, 2);
    assert_false(scene->primitives[0].shape.mesh.solid);
    assert_true(scene->primitives[1].shape.mesh.solid);
    assert_true(scene->primitives[1].invisible);
}

/* ---- Errors -------------------------------------------------------------- */

#define THREE "mesh2 { vertex_vectors { 3, 0, x, y } " /* the text has 38 columns */
#define FACE "face_indices { 1, <0, 1, 2> } "          /* the text has 30 columns */
#define MESH "mesh { triangle { 0, x, y } }"

static const struct line_error errors[] = {
    { "triangle { 0, x }", 17, "expected a number or a vector" },
    { "triangle 0, x, y", 10, "expected '{'" },
    { "triangle { 0, x, y uv_vectors x, y, z }", 20, "'uv_vectors'" },
    { "triangle { 0, x, y", 19, "to close the '{' of line 1" },
    { "smooth_triangle { 0, x, y }", 27, "expected a number" },
    { "mesh { sphere { 0, 1 } }", 8, "expected a triangle or an object modifier" },
    { "mesh { triangle { 0, x, y, z } triangle { 0, x, y } }", 26,
      "expected a keyword of a mesh triangle" },
    { "mesh { triangle { 0, x, y translate x } }", 27, "found 'translate'" },
    { "mesh { triangle { 0, x, y uv_vectors x, y } }", 43, "a number" },
    { "mesh { triangle { 0, x, y texture { A } } }", 37, "'A', which is not declared" },
    { "mesh { triangle { 0, x, y texture_list { 1 } } }", 42,
      "expected the name of a texture" },
    { "#declare T = texture { }; mesh { triangle { 0, x, y "
      "texture_list { T T T T } } }",
      74, "expected '}'" },
    { "mesh { triangle { 0, x, y } inside_vector }", 43, "a number" },
    { "mesh { triangle { 0, x, y } scale 2 triangle { 0, x, y } }", 37,
      "found 'triangle'" },
    { "mesh2 { }", 1, "'vertex_vectors' is missing" },
    { THREE "}", 1, "'face_indices' is missing" },
    { "mesh2 { face_indices { 1, 0 } }", 9,
      "'vertex_vectors' must be before 'face_indices'" },
    { "mesh2 { texture_list { 0 } " FACE "}", 9,
      "'vertex_vectors' must be before 'texture_list'" },
    { "mesh2 { uv_indices { 1, 0 } }", 9,
      "'face_indices' must be before 'uv_indices'" },
    { THREE "vertex_vectors { 1, 0 } " FACE "}", 39,
      "'vertex_vectors' is already defined" },
    { THREE FACE "face_indices { 1, 0 } }", 69, "'face_indices' is already defined" },
    { THREE FACE "normal_vectors { 1, x } }", 69,
      "'normal_vectors' must be before 'face_indices'" },
    { THREE "texture_list { 0 } uv_vectors { 0 } " FACE "}", 58,
      "'uv_vectors' must be before 'texture_list'" },
    { THREE "inside_vector x " FACE "}", 55,
      "'face_indices' must be before 'inside_vector'" },
    { THREE FACE "scale 2 inside_vector x }", 77, "'inside_vector'" },
    { "mesh2 { vertex_vectors { 0 } " FACE "}", 26,
      "the number of 'vertex_vectors' must be an integer above 0" },
    { "mesh2 { vertex_vectors { 3.5, 0, x, y } " FACE "}", 26, "must be an integer" },
    { "mesh2 { vertex_vectors { x, 0, x, y } " FACE "}", 26, "found 3" },
    { THREE "face_indices { -1 } }", 54, "above 0" },
    { THREE "normal_vectors { -1 } " FACE "}", 56,
      "'normal_vectors' must be an integer of at least 0" },
    { "mesh2 { vertex_vectors { 1e7 + 1, x } }", 26,
      "more than 4000000 'vertex_vectors'" },
    { "mesh2 { vertex_vectors { 3, 0, x } " FACE "}", 34,
      "found only 2 of 3 'vertex_vectors'" },
    { "mesh2 { vertex_vectors { 3, 0, x, y, z } " FACE "}", 38,
      "expected '}', found 'z'" },
    { "mesh2 { vertex_vectors { 3, 0, <1, 2, 3, 4> } " FACE "}", 32, "a vector of 3" },
    { THREE "texture_list { 1, pigment { } } " FACE "}", 57, "expected a texture" },
    { THREE "face_indices { 2, <0, 1, 2>, <0, 3, 1> } }", 68,
      "a face has the vertex 3, but there are only 3" },
    { THREE "face_indices { 1, <0, -1, 2> } }", 57, "the vertex -1" },
    { THREE "face_indices { 1, 0 } }", 57, "the three vertices" },
    { THREE "face_indices { 1, <0, 1, 2>, 0 } }", 68,
      "a face has the texture 0, but there are only 0" },
    { THREE "texture_list { 1 texture { } } face_indices { 1, <0, 1, 2>, 0, 0 } }", 104,
      "one texture or three, not two" },
    { THREE "texture_list { 1 texture { } } face_indices { 2, <0, 1, 2> 0 "
            "0 0 0 <0, 1, 2> } }",
      104, "the three vertices of a face" },
    { THREE "normal_vectors { 2 x y } " FACE "}", 1,
      "'normal_indices' is missing: there are 2 'normal_vectors', but 3" },
    { THREE "uv_vectors { 2 x y } " FACE "}", 1, "'uv_indices' is missing" },
    { THREE FACE "normal_indices { 1, <0, 1, 2> } }", 89,
      "the normal 0, but there are only 0" },
    { THREE "normal_vectors { 1 x } " FACE "normal_indices { 2, 0, 0 } }", 109,
      "2 'normal_indices' cannot match 1 face" },
    { THREE "uv_vectors { 1, 0 } " FACE "uv_indices { 0 } }", 102,
      "0 'uv_indices' cannot match 1 face" },
    { THREE FACE "uv_indices { 1, <0, 0, 1> } }", 85,
      "the uv vector 1, but there are only 1" },
    { THREE FACE "wibble }", 69, "expected a keyword of mesh2" },
    { "#declare mesh2 = 1;", 10, "a keyword, not a name" },
};

TEST_CALL(errors, assert_errors(errors, COUNT(errors)))

/* The limit includes copies of declared meshes. */
TEST(copies_count)
{
    static const char many[] =
        "#declare M = mesh { #for (I, 1, 40000) triangle { 0, x, y } #end }\n"
        "#for (I, 1, %s) object { M } #end";
    char text[sizeof many + 8];
    scene_free(read_format(many, "99"));
    (void)snprintf(text, sizeof text, many, "100");
    assert_error(text, &reading_options, 2, 27,
                 "more than 4000000 triangles, including copies");
}

/* An error in a section of a mesh2, or in a triangle, causes no other errors. */
TEST(recovery)
{
    assert_error("mesh2 { vertex_vectors { 3, 0, x }\n"
                 "normal_vectors { 3, x, y, z }\n"
                 "face_indices { 2, <0, 1, 2> <0, 1, 9> }\n"
                 "normal_indices { 2, <0, 1, 2> <0, 1, 7> } scale 2 }",
                 &reading_options, 1, 34, "found only 2 of 3");
    assert_error("mesh { triangle { 0, x } triangle { 0, x, y }\n"
                 "smooth_triangle { 0, x, y, x, y, z } scale 2 }",
                 &reading_options, 1, 24, "expected a number");
    assert_refused_last("mesh { triangle { 0, x } triangle { 0, y } wibble }", 3,
                        "found 'wibble'");
}

/* ---- Three notations of a mesh ------------------------------------------- */

enum { MAX_POINTS = 12, MAX_FACES = 20, MESHES = 300 };

/* Makes a mesh on a small grid, with empty triangles. All normals differ. */
static void draw_mesh(struct net *net, size_t directions[MAX_FACES][3],
                      uint64_t *random)
{
    net->point_count = (size_t)xorshift_between(random, 3, MAX_POINTS);
    net->face_count = (size_t)xorshift_between(random, 1, MAX_FACES);
    net->smooth = xorshift_between(random, 0, 1);
    net->directions = (const size_t(*)[3])directions;
    for (size_t i = 0; i < net->point_count; i++)
        for (int k = 0; k < 3; k++) {
            net->points[i][k] = (double)xorshift_between(random, -2, 2);
            net->normals[i][k] = k ? (double)xorshift_between(random, -9, 9)
                                   : (double)(i + 1);
        }
    for (size_t i = 0; i < net->face_count; i++)
        for (int k = 0; k < 3; k++) {
            size_t *index = &directions[i][k];
            net->faces[i][k] = xorshift(random) % net->point_count;
            *index = xorshift(random) % net->point_count;
            if (k > 0 && *index == directions[i][0])
                *index = (*index + 1) % net->point_count;
        }
}

static void assert_same_triangle(const struct triangle *a, const struct triangle *b)
{
    assert_int_equal(a->smooth, b->smooth);
    assert_memory_equal(a->corners, b->corners, sizeof a->corners);
    if (a->smooth)
        assert_memory_equal(a->normals, b->normals, sizeof a->normals);
}

/* The triangles of the union's meshes, in order, must equal the triangles of each of
 * the two meshes before the union. */
static void assert_same(const struct scene *scene)
{
    const struct triangles *mesh = triangles_of_part(scene, 0);
    const struct triangles *mesh2 = triangles_of_part(scene, 1);
    assert_int_equal(mesh->count, mesh2->count);
    assert_int_equal(mesh->count + 2, scene->primitive_count);
    for (size_t i = 0; i < mesh->count; i++) {
        assert_same_triangle(&mesh->list[i], &mesh2->list[i]);
        assert_same_triangle(&mesh->list[i], triangles_of_part(scene, i + 2)->list);
    }
}

/* A mesh without triangles is an error. */
TEST(three_ways)
{
    static struct net net;
    static char text[40000];
    size_t directions[MAX_FACES][3];
    uint64_t random = RANDOM_SEED;
    size_t compared = 0;
    for (int i = 0; i < MESHES; i++) {
        SCOPED_VALUE(diagnostics) reports = { 0 };
        draw_mesh(&net, directions, &random);
        text[0] = '\0';
        net_mesh_text(&net, text, sizeof text);
        strcat(text, "}\n");
        net_mesh2_text(&net, text, sizeof text);
        strcat(text, "}\n");
        net_triangles_text(&net, "union", text, sizeof text);
        strcat(text, "}\n");
        SCOPED(scene) *scene = scene_read_text("test.pov", text, &reading_options,
                                               &reports);
        FAIL_IF(!scene, "%s: %s", reports.items->message, text);
        bool seen = !strstr(reports.items->message, "no triangle of the mesh");
        if (seen)
            assert_same(scene);
        compared += seen;
    }
    assert_true(compared > MESHES / 2);
}

/* A large mesh whose array grows many times. */
TEST(many)
{
    enum { MANY = 40000 };
    SCOPED(scene) *scene = read_scene(
        "mesh { #for (I, 1, 40000) triangle { I*x, y, z } #end }\n"
        "mesh2 { vertex_vectors { 40002, y, z,"
        " #for (I, 1, 40000) <I, 0, 0>, #end }"
        " face_indices { 40000, #for (I, 1, 40000) <I + 1, 0, 1> #end } }");
    const struct triangles *mesh = triangles_of_part(scene, 0);
    assert_int_equal(mesh->count, MANY);
    assert_int_equal(triangles_of_part(scene, 1)->count, MANY);
    for (size_t i = 0; i < MANY; i++)
        assert_same_triangle(&mesh->list[i], &triangles_of_part(scene, 1)->list[i]);
    assert_close(mesh->list[MANY - 1].corners[0][0], MANY, 0);
}
