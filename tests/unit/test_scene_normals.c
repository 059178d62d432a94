/* test_scene_normals.c - the scene language. Normals by patterns and maps are compared
 * with expected fields in all forms. A wrong amount, transform or entry fails here. */
#include "rt/scene/transform.h"
#include "tests/unit/scene_reading.h"

/* Reads a sphere with this normal. */
static struct scene *scene_with(const char *words, size_t reports)
{
    return read_with(formatted("sphere { 0, 1 normal { %s } }", words), reports);
}

static const struct bump_list *list_of(const struct scene *scene)
{
    return NON_NULL(scene->primitives[0].bumps.list);
}

static void check_bump(const char *words, enum pattern_function function, double amount,
                       double accuracy)
{
    static const char *const forms[] = {
        "sphere { 0, 1 normal { %s } }",
        "sphere { 0, 1 texture { normal { %s } } }",
        "#declare N = normal { %s } sphere { 0, 1 normal { N } }",
        "#default { normal { %s } } sphere { 0, 1 }",
        "#declare M = material { texture { normal { %s } } }"
        " sphere { 0, 1 material { M } }",
        "#declare A = array[1] { normal { %s } } sphere { 0, 1 normal { A[0] } }",
    };
    for (size_t i = 0; i < COUNT(forms); i++) {
        SCOPED(scene) *scene = read_format(forms[i], words);
        const struct bump *bump = &list_of(scene)->bump;
        assert_true(bumps_show(&scene->primitives[0].bumps));
        assert_int_equal(bump->pattern.kind, PIGMENT_PATTERN);
        assert_int_equal(bump->pattern.pattern.function, function);
        assert_close(bump->amount, amount, 0);
        assert_close(bump->accuracy, accuracy, 0);
    }
}

TEST(bumps)
{
    check_bump("gradient x", PATTERN_GRADIENT, .5, .02);
    check_bump("gradient x, 3", PATTERN_GRADIENT, 3, .02);
    check_bump("gradient <1, 2, 3> 3 bump_size 2", PATTERN_GRADIENT, 2, .02);
    check_bump("bump_size 2 gradient y", PATTERN_GRADIENT, 2, .02);
    check_bump("onion -1 accuracy .3", PATTERN_ONION, -1, .3);
    check_bump("onion accuracy .3 brick .7", PATTERN_BRICK, .7, .02);
    check_bump("checker .1", PATTERN_CHECKER, .1, .02);
    check_bump("hexagon", PATTERN_HEXAGON, .5, .02);
    check_bump("quilted 2", PATTERN_QUILTED, 2, .02);
    check_bump("radial 2 frequency 8 sine_wave", PATTERN_RADIAL, 2, .02);
}

/* A normal without a pattern, or with an unknown pattern, has no effect. */
TEST(none)
{
    static const struct {
        const char *text;
        size_t reports;
    } rows[] = {
        { "sphere { 0, 1 }", 0 },
        { "sphere { 0, 1 normal { bump_size 2 } }", 0 },
        { "sphere { 0, 1 normal { gradient x } normal { bumps 2 scale 3 } }", 1 },
        { "sphere { 0, 1 normal { bumps 2 normal_map { [0 onion] } } }", 1 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene) *scene = read_with(rows[i].text, rows[i].reports);
        assert_false(bumps_show(&scene->primitives[0].bumps));
    }
}

/* Normals are added. They move with their object, texture and material. */
TEST(motions)
{
    static const char *const texts[] = {
        "sphere { 0, 1 normal { onion scale 2 translate x } }",
        "sphere { 0, 1 normal { onion scale 2 } translate x }",
        "sphere { 0, 1 texture { normal { onion } scale 2 translate x } }",
        "sphere { 0, 1 normal { onion scale 2 } normal { translate x } }",
        "sphere { 0, 1 texture { pigment { rgb 1 } scale 3 }"
        " normal { onion scale 2 } translate x }",
        "union { sphere { 0, 1 pigment { rgb 1 } scale 3"
        " normal { onion scale 2 } } box { 0, 1 } translate x }",
        "#declare N = normal { onion scale 2 }"
        " sphere { 0, 1 normal { N translate x } }",
        "#declare M = material { texture { normal { onion } } scale 2 }"
        " sphere { 0, 1 material { M } translate x }",
        "union { sphere { 0, 1 } box { 0, 1 } normal { onion scale 2 } translate x }",
        "union { sphere { 0, 1 normal { onion } } box { 0, 1 } scale 2 translate x }",
    };
    for (size_t i = 0; i < COUNT(texts); i++) {
        SCOPED(scene) *scene = read_scene(texts[i]);
        double point[3] = { 3, 2, 4 };
        transform_point(&scene->primitives[0].bumps.to_local, point);
        assert_numbers(texts[i], point, (double[]){ 1, 1, 2 }, 3, 1e-15);
        assert_int_equal(list_of(scene)->bump.pattern.pattern.function, PATTERN_ONION);
    }
}

TEST(unscaled)
{
    SCOPED(scene) *scene = read_scene(
        "sphere { 0, 1 normal { onion no_bump_scale } }"
        "sphere { 0, 1 texture { normal { onion } no_bump_scale } }"
        "sphere { 0, 1 texture { normal { onion } } }");
    assert_true(scene->primitives[0].bumps.unscaled);
    assert_true(scene->primitives[1].bumps.unscaled);
    assert_false(scene->primitives[2].bumps.unscaled);
}

TEST(slope_maps)
{
    static const char *const texts[] = {
        "gradient x slope_map { [.2 <0, 1>] [.1, <.5, -1>] [1 <2, 0>] }",
        "gradient x normal_map { [0 onion] [1 radial] }"
        " slope_map { [.2 <0, 1>], [.2, <.5, -1>] [1 <2, 0>] }",
    };
    for (size_t i = 0; i < COUNT(texts); i++) {
        SCOPED(scene) *scene = scene_with(texts[i], 0);
        const struct bump *bump = &list_of(scene)->bump;
        assert_int_equal(list_of(scene)->count, 0);
        assert_int_equal(bump->stop_count, 3);
        assert_close(bump->stops[1].at, .2, 0);
        assert_close(bump->stops[1].height, .5, 0);
        assert_close(bump->stops[1].slope, -1, 0);
        assert_close(bump->stops[2].height, 2, 0);
    }
}

static void check_entries(const char *words, size_t count, const double *at)
{
    SCOPED(scene) *scene = scene_with(words, 0);
    const struct bump_list *list = list_of(scene);
    assert_int_equal(list->count, count);
    assert_int_equal(list->bump.stop_count, 0);
    for (size_t i = 0; i < count; i++)
        assert_close(list->entries[i].at, at[i], 0);
}

TEST(normal_maps)
{
    check_entries("gradient x normal_map { [.3 onion] [.2 radial] [2 planar] }", 3,
                  (double[]){ .3, .3, 2 });
    check_entries("gradient x slope_map { [0 <0, 1>] }"
                  " normal_map { [0 onion] [1 radial] }",
                  2, (double[]){ 0, 1 });
    check_entries("average normal_map { [onion] [3 radial] [2, planar] }", 3,
                  (double[]){ 1, 3, 2 });
    check_entries("checker normal { onion } normal { radial }", 2, (double[]){ 0, 1 });
    check_entries("onion slope_map { [0 <0, 1>] } brick", 0, NULL);
    check_entries("onion normal_map { [0 onion] } brick", 0, NULL);
    check_entries("hexagon normal { onion }, normal { radial } normal { boxed }", 3,
                  (double[]){ 0, 1, 2 });
    static const char mixed[] = "average normal_map { [onion 2 scale 2] [bumps 3] }";
    SCOPED(scene) *average = scene_with(mixed, 1);
    const struct bump_list *list = list_of(average);
    assert_true(list->average);
    assert_close(list->entries[0].bump.amount, 2, 0);
    assert_close(list->entries[0].bump.pattern.to_local.rows[1][1], .5, 0);
    assert_int_equal(list->entries[1].bump.pattern.kind, PIGMENT_COLOR);
    SCOPED(scene) *scene = read_scene(
        "#declare S = slope_map { [0 <0, 1>] [1 <1, 0>] }"
        "#declare M = normal_map { [0 onion] [1 radial] }"
        "sphere { 0, 1 normal { planar slope_map { S } } }"
        "sphere { 0, 1 normal { planar normal_map { M } } }");
    assert_int_equal(scene->primitives[0].bumps.list->bump.stop_count, 2);
    assert_int_equal(scene->primitives[1].bumps.list->count, 2);
    assert_false(scene->primitives[1].bumps.list->average);
}

/* The first normal of a map inside an entry is used at the value of the entry. */
TEST(nested)
{
    static const char text[] = "onion normal_map { [0 radial] [1 planar scale 2"
                               " normal_map { [0 boxed translate x] [1 leopard] }] }";
    SCOPED(scene) *scene = scene_with(text, 1);
    const struct bump *bump = &list_of(scene)->entries[1].bump;
    assert_int_equal(bump->pattern.pattern.function, PATTERN_BOXED);
    assert_close(bump->pattern.to_local.rows[0][0], .5, 0);
    assert_close(bump->pattern.to_local.rows[0][3], -1, 0);
}

TEST(quilted)
{
    static const char text[] = "onion slope_map { [0 <0, 1>] } quilted control1 .3";
    SCOPED(scene) *scene = scene_with(text, 0);
    const struct bump *bump = &list_of(scene)->bump;
    assert_close(bump->controls[0], 1, 0);
    assert_close(bump->controls[1], .3, 0);
    assert_int_equal(bump->stop_count, 0);
}

/* The layout writes the pattern of each entry. */
TEST(quilted_without_effect)
{
    static const char text[] = "onion normal_map { [0 quilted bozo] [1 onion] }";
    SCOPED(scene) *scene = scene_with(text, 1);
    const struct bump *bump = &list_of(scene)->entries[0].bump;
    assert_int_equal(bump->pattern.kind, PIGMENT_COLOR);
    assert_int_equal(bump->pattern.pattern.function, PATTERN_PLANAR);
}

static const struct line_error errors[] = {
    { "sphere { 0, 1 normal { onion accuracy 0 } }", 30, "the accuracy must not be 0" },
    { "sphere { 0, 1 normal { average } }", 22, "'average' requires 'normal_map'" },
    { "sphere { 0, 1 normal { brick slope_map { [0 <0, 1>] } } }", 30,
      "a list of normals cannot be combined with 'slope_map'" },
    { "sphere { 0, 1 normal { checker normal { onion } } }", 49, "expected a normal" },
    { "sphere { 0, 1 normal { onion normal_map { } } }", 43, "expected '['" },
    { "sphere { 0, 1 normal { onion normal_map { [onion] } } }", 44, "expected" },
    { "sphere { 0, 1 normal { onion slope_map { [0 1 2] } } }", 47, "expected" },
    { "sphere { 0, 1 normal { onion rgb 1 } }", 30, "expected a keyword of normal" },
    { "sphere { 0, 1 normal { gradient 0 } }", 24,
      "the vector of a gradient must have a finite length above 0" },
    { "sphere { 0, 1 normal { onion scale 1e200 scale 1e200 } }", 1, "out of range" },
};

TEST_CALL(errors, assert_errors(errors, COUNT(errors)))
