/* test_scene_blobs.c - blobs of the scene language. The components, motions, materials,
 * pieces and table rows of texts are compared with values computed by hand. A motion in
 * the wrong order, a material of the wrong component, or an error at another column
 * fails here. */
#include "tests/unit/scene_reading.h"

#include "rt/scene/vector3.h"
#include "rt/shapes/blob.h"
#include "rt/shapes/shape_words.h"
#include "tests/oracle/plain_regions.h"

static const struct blob_part *parts_of(const struct scene *scene, size_t count)
{
    assert_int_equal(scene->primitive_count, 1);
    assert_int_equal(scene->primitives->kind, PRIMITIVE_BLOB);
    assert_int_equal(scene->primitives->shape.blob.parts.count, count);
    return scene->primitives->shape.blob.parts.list;
}

static void assert_part(const struct blob_part *part, bool cylinder, double radius,
                        double strength)
{
    assert_int_equal(part->cylinder, cylinder);
    assert_close(part->radius, radius, 0);
    assert_close(part->strength, strength, 0);
}

TEST(components)
{
    SCOPED(scene) *scene = read_scene(
        "blob { threshold .7 sphere { <1, 2, 3>, -2, strength 4 }"
        " cylinder { x 2*y .5 strength -1 } component .5, 3, z"
        " sphere { 0 1, 0 } threshold .6 sphere { 0, 1, 1 } sturm 1 hierarchy off }");
    const struct blob_part *parts = parts_of(scene, 4);
    assert_close(scene->primitives->shape.blob.threshold, .6, 0);
    assert_part(&parts[0], false, 2, 4);
    assert_vector(parts[0].base, 1, 2, 3);
    assert_part(&parts[1], true, .5, -1);
    assert_vector(parts[1].base, 1, 0, 0);
    assert_vector(parts[1].cap, 0, 2, 0);
    assert_part(&parts[2], false, 3, .5);
    assert_vector(parts[2].base, 0, 0, 1);
    assert_part(&parts[3], false, 1, 1);
    SCOPED(scene) *other = read_scene("blob { sphere { 0, 1, 2 } }");
    assert_close(other->primitives->shape.blob.threshold, 1, 0);
}

/* A component first moves within the blob, then with the blob. */
TEST(motions)
{
    SCOPED(scene) *scene = read_scene(
        "blob { sphere { x, 1, 2 scale 2 rotate 90*z translate <1, 0, 5> }"
        " translate 3*y }");
    const struct blob_part *part = parts_of(scene, 1);
    double center[3], back[3];
    to_other_space(&part->to_blob, part->base, center);
    to_other_space(&part->to_local, (double[]){ 1, 2, 5 }, back);
    assert_vector(center, 1, 2, 5);
    assert_vector(back, 1, 0, 0);
    assert_close(scene->primitives->to_world.rows[1][3], 3, 0);
}

/* Components' materials cause one report. The blob's is used, or else the first. */
TEST(looks)
{
    static const char text[] =
        "blob { sphere { 0, 1, 2 pigment { rgb x } finish { ambient 1 } }"
        " cylinder { 0, x, 1, 1 texture { pigment { rgb y } } scale 2 }%s }";
    static const char *const own[] = { " pigment { rgb <.25, .5, .75> }", "" };
    static const char *const by[] = { "the texture of the blob", "the first one" };
    static const double colors[][3] = { { .25, .5, .75 }, { 1, 0, 0 } };
    for (int i = 0; i < 2; i++) {
        const char *blob = formatted(text, own[i]);
        SCOPED(scene) *scene = read_with(blob, 1);
        parts_of(scene, 2);
        assert_numbers(blob, scene->primitives->pigment.color[0], colors[i], 3, CLOSE);
        assert_error(blob, &strict_options, 1, 25, by[i]);
    }
}

/* A single component's material moves with the component and with the blob. */
TEST(one_look)
{
    SCOPED(scene) *scene = read_scene(
        "blob { sphere { 0, 1, 2 pigment { rgb z } translate x } scale 2 }");
    const struct pigment *pigment = &scene->primitives->pigment;
    assert_vector(pigment->color[0], 0, 0, 1);
    assert_close(pigment->to_local.rows[0][0], .5, 0);
    assert_close(pigment->to_local.rows[0][3], -1, 0);
}

static const struct line_error errors[] = {
    { "blob { cylinder { x, x, 1, 1 } }", 19, "the cylinder has no length" },
    { "blob { sphere { 0, 1 } }", 22, "expected a number" },
    { "blob { sphere { 0, 1, 1 interior { ior 2 } } }", 25,
      "a modifier of the component" },
    { "blob { sphere { 0, 1, 1 } box { 0, 1 } }", 27,
      "a component or an object modifier" },
    { "blob { sphere { 0, 1, 1 } sturm sphere { 0, 1, 1 } }", 33,
      "an object modifier" },
    { "blob { #for (I, 1, 1501) sphere { 0, 1, 1 } #end }", 26,
      "more than 1500 components in one blob" },
};

TEST_CALL(errors, assert_errors(errors, COUNT(errors)))

/* ---- Words that the machine reads ---------------------------------------- */

static size_t pieces_of(const char *text)
{
    SCOPED(scene) *scene = read_scene(text);
    return blob_pieces_most(scene);
}

TEST(pieces)
{
    assert_int_equal(pieces_of("sphere { 0, 1 }"), 0);
    assert_int_equal(pieces_of("blob { sphere { 0, 1, 1 } }"), 1);
    assert_int_equal(pieces_of("blob { sphere { 0, 1, 1 }"
                               " cylinder { 0, x, 1, 1 } }"
                               " blob { sphere { 0, 1, 1 } }"),
                     4);
}

/* A row of the table describes a component in its own space. The radius is one, the
 * base is the origin, and the axis is z. */
TEST(rows)
{
    enum { ROW = 20, LENGTH = 7, MATRIX = 8 };
    SCOPED(scene) *scene = read_scene(
        "blob { cylinder { <1, 2, 3>, <1, 5, 7>, .5, 2 scale <1, 2, 1> }"
        " sphere { <1, 2, 3>, .5, 1 translate x } sphere { 0, 2, 1 scale 2 } }");
    const struct primitive *primitive = scene->primitives;
    struct shape_words words;
    FREED double *table = shape_table(primitive, NULL, 3 * ROW);
    static const double ends[2][3] = { { 1, 4, 3 }, { 1, 10, 7 } };
    assert_int_equal(shape_table_count(primitive, NULL), 3 * ROW);
    shape_words(primitive, &words);
    assert_close(words.words[4], 1, 0);
    assert_close(words.words[5], 3, 0);
    assert_close(table[0], 2, 0);
    assert_close(table[LENGTH], 10, CLOSE);
    for (int end = 0; end < 2; end++) {
        double own[3], from[3];
        subtract3(ends[end], words.words, from);
        for (int i = 0; i < 3; i++)
            own[i] = dot3(table + MATRIX + 4 * i, from) + table[MATRIX + 4 * i + 3];
        assert_vector(own, 0, 0, end * 10);
    }
    assert_close(table[ROW], 0, 0);
    assert_close(table[ROW + 1] + words.words[0], 2, CLOSE);
    assert_close(table[ROW + 4], .25, 0);
    assert_close(table[ROW + 5], 4, 0);
    assert_close(table[2 * ROW], 1, 0);
}
