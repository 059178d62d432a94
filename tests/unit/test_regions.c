/* Regions, nodes and steps as they stand in a machine's memory after a
 * layout. */
#include "tests/unit/laid_out.h"

#include "rt/layout/regions.h"
#include "tests/random.h"

static uint64_t random_state = RANDOM_SEED;

/* --- primitives ---------------------------------------------------------- */

#define PATCH "steiner_patch { x, y, z, 0, 0, 0 "
#define SQUARE "prism { 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> "

static const struct shape_row {
    const char *text;
    const char *alone, *kernel, *state; /* and in a tree */
    int segments, events, first_event;
} shape_rows[] = {
    { "sphere { 0, 1", "sphere", "sphere", NULL, 1, 2, 0 },
    { "box { 0, 1", "box", "box", NULL, 1, 2, 0 },
    { "cylinder { 0, y, 1", "cylinder", "cylinder", NULL, 1, 2, 0 },
    { "cylinder { 0, y, 1 open", "open_cylinder", "open_cylinder", "cylinder",
      1, 2, 2 },
    { "plane { y, 0", "plane", "plane", NULL, 1, 2, 0 },
    { "cone { 0, 1, y, 0", "cone", "cone", NULL, 1, 2, 0 },
    { "cone { 0, 1, y, 0 open", "open_cone", "open_cone", "cone", 1, 2, 2 },
    { "torus { 1, .2", "torus", "torus_solid", NULL, 2, 4, 0 },
    { "elliptical_torus { 1, .2, .3", "elliptical_torus",
      "elliptical_torus_solid", NULL, 2, 4, 0 },
    { "quadric { 1, 0, 0, -1", "quadric", "quadric_solid", NULL, 2, 4, 0 },
    { "quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,"
      "1,0,0,0,-1>",
      "quartic_surface", "quartic_solid", NULL, 3, 6, 0 },
    { SQUARE, "prism", "prism_solid", NULL, 1, 2, 0 },
    { SQUARE "open", "open_prism", "open_prism_sides", "prism_solid", 1, 2,
      2 },
    { "prism { 0, 1, 4, <0, 0>, <2, 1>, <0, 2>, <1, 1>", "prism",
      "prism_solid", NULL, 2, 4, 0 },
    { PATCH, "steiner", "steiner_crossings", NULL, 0, 4, 0 },
    { PATCH "weights 1,2,1,1,1,1", "rational_steiner",
      "rational_steiner_crossings", NULL, 0, 4, 0 },
};

static void check_kernel(const struct stage *stage, size_t i,
                         const char *kernel, const char *inner,
                         const char *expected)
{
    bool turned = expected && stage->scene->primitives[i].transformed
                  && stage->scene->primitives[i].kind != PRIMITIVE_PLANE;

    if (!expected)
        assert_int_equal(primitive(stage, i, kernel), 0);
    else if (primitive(stage, i, inner) != symbol(stage, expected)
             || primitive(stage, i, kernel)
                    != symbol(stage, turned ? "transformed" : expected))
        fail_msg("%s is not %s", kernel, expected);
}

/* Each in a tree behind a sphere, and alone. */
static void check_shape(const struct shape_row *row, const char *how)
{
    struct stage stage;
    char text[500];

    snprintf(text, sizeof text, "merge { sphere { 0, 3 } %s %s } } %s %s }",
             row->text, how, row->text, how);
    raise_curtain(&stage, text, BOUNDING_FLAT);
    check_kernel(&stage, 1, "P_KERNEL", "P_INNER", row->kernel);
    check_kernel(&stage, 1, "P_STATE_KERNEL", "P_STATE_INNER", row->state);
    assert_integer(primitive(&stage, 1, "P_SEGMENTS"), row->segments);
    assert_integer(primitive(&stage, 1, "P_EVENTS"), row->events);
    assert_integer(primitive(&stage, 1, "P_FIRST_STATE"), 2);
    assert_integer(primitive(&stage, 1, "P_FIRST_EVENT"),
                   2 + row->first_event);
    assert_integer(primitive(&stage, 1, "P_VALUE"), 1);
    assert_integer(region(&stage, 0, "R_SIMPLE"), 0);
    check_kernel(&stage, 2, "P_KERNEL", "P_INNER", row->alone);
    check_kernel(&stage, 2, "P_STATE_KERNEL", "P_STATE_INNER", NULL);
    assert_integer(region(&stage, 1, "R_SIMPLE"), 1);
    drop_curtain(&stage);
}

static void test_primitives(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(shape_rows); i++) {
        check_shape(&shape_rows[i], "");
        check_shape(&shape_rows[i], "scale <1, 2, 3> rotate 40*x");
    }
}

/* Open shapes need room for both, patches for their parameters. */
static void test_crossings(void **state)
{
    static const struct {
        const char *text;
        uint64_t crossings;
        size_t last, first_event;
    } rows[] = {
        { "merge { box { 0, 1 } cylinder { 0, y, 1 open } torus { 1, .2 } }",
          10, 2, 6 },
        { "merge { " PATCH "} sphere { 0, 1 } }", 14, 1, 12 },
        { "sphere { 0, 1 pigment { rgbt 1 } } torus { 1, .2 }", 2, 0, 0 },
        { "cylinder { 0, y, 1 open pigment { rgbt 1 } }", 4, 0, 2 },
        { "prism { 0, 1, 4, <0, 0>, <2, 1>, <0, 2>, <1, 1> open "
          "pigment { rgbt 1 } }",
          8, 0, 4 },
    };

    (void)state;
    for (size_t i = 0; i < COUNT(rows); i++) {
        struct stage stage;
        uint64_t room = 64 * 2 * rows[i].crossings, first;
        c205_word word;

        raise_curtain(&stage, rows[i].text, BOUNDING_FLAT);
        first = scene_word(&stage, "scene_crossings");
        assert_integer(primitive(&stage, rows[i].last, "P_FIRST_EVENT"),
                       (int64_t)rows[i].first_event);
        assert_true(c205_read(stage.machine, first + room - 64, &word, 1));
        drop_curtain(&stage);
    }
}

/* --- regions and nodes --------------------------------------------------- */

static void test_regions(void **state)
{
    static const struct {
        bool simple;
        int shadow, first, count, steps;
    } rows[] = {
        { true, 1, 0, 1, 0 },  { true, 0, 1, 1, 0 },  { false, 2, 2, 1, 0 },
        { false, 1, 3, 2, 1 }, { false, 2, 5, 2, 1 }, { false, 0, 7, 2, 1 },
        { true, 1, 9, 1, 0 },
    };
    struct stage stage;

    (void)state;
    raise_curtain(
        &stage,
        "sphere { 0, 1 } box { 0, 1 no_shadow }\n"
        "plane { y, 0 pigment { checker rgb 1, rgbf 1 } }\n"
        "merge { sphere { 0, 1 } box { 0, 1 no_shadow } }\n"
        "merge { sphere { 0, 1 } box { 0, 1 } pigment { rgbt 1 } }\n"
        "merge { sphere { 0, 1 } box { 0, 1 } no_shadow }\n"
        "sphere { 0, 1 inverse }",
        BOUNDING_FLAT);
    assert_integer(scene_word(&stage, "scene_region_count"), COUNT(rows));
    for (size_t i = 0; i < COUNT(rows); i++) {
        size_t first = (size_t)rows[i].first;

        assert_integer(region(&stage, i, "R_SIMPLE"), rows[i].simple);
        assert_integer(region(&stage, i, "R_SHADOW"), rows[i].shadow);
        assert_int_equal(region(&stage, i, "R_FIRST"),
                         primitive_at(&stage, first));
        assert_integer(region(&stage, i, "R_PRIMITIVES"), rows[i].count);
        assert_integer(region(&stage, i, "R_STEP_COUNT"), rows[i].steps);
    }
    assert_integer(primitive(&stage, 8, "P_INVERTED"), 0);
    assert_integer(primitive(&stage, 9, "P_INVERTED"), 1);
    drop_curtain(&stage);
}

/* In preorder, without complements: &(|(0,1), !(&(2, !(3))), 4). */
static void test_nodes(void **state)
{
    static const struct {
        int leaf, first;
        size_t next;
        double radius;
        int needed;
    } rows[] = {
        { 0, 0, 8, 2.5, 1 },        { 0, 0, 4, 4, 1 },   { 1, 0, 3, 2, 0 },
        { 1, 1, 4, 2, 0 },          { 0, 2, 7, 9, 0 },   { 1, 2, 6, 9, 0 },
        { 1, 3, 7, BOUND_NONE, 0 }, { 1, 4, 8, 2.5, 1 },
    };
    static const char text[] =
        "intersection { merge { sphere { -2*x, 2 } sphere { 2*x, 2 } }\n"
        "  difference { sphere { 0, 9 } plane { y, 0 } inverse }\n"
        "  sphere { x, 2.5 } }";
    struct stage stage;
    uint64_t nodes, size;

    (void)state;
    raise_curtain(&stage, text, BOUNDING_FLAT);
    nodes = region(&stage, 0, "R_NODES");
    size = 64 * symbol(&stage, "N_SIZE");
    assert_int_equal(region(&stage, 0, "R_NODES_END"), nodes + 8 * size);
    for (size_t i = 0; i < COUNT(rows); i++) {
        size_t first = (size_t)rows[i].first;
        uint64_t leaf = field_of(&stage, nodes, "N_SIZE", i, "N_PRIMITIVE");
        uint64_t bound = symbol(&stage, "N_BOUND") + 3;
        double radius = c205_to_double(
            stage_word(&stage, nodes + size * i + 64 * bound));

        assert_int_equal(leaf,
                         rows[i].leaf ? primitive_at(&stage, first) : 0);
        assert_int_equal(field_of(&stage, nodes, "N_SIZE", i, "N_NEXT"),
                         nodes + size * rows[i].next);
        assert_close(radius, rows[i].radius, .002 * rows[i].radius);
        assert_integer(field_of(&stage, nodes, "N_SIZE", i, "N_NEEDED"),
                       rows[i].needed);
    }
    drop_curtain(&stage);
}

static void check_bound(const struct stage *stage, uint64_t address,
                        const char *name)
{
    uint64_t bound = address + 64 * symbol(stage, name);

    assert_int_equal(stage_word(stage, bound + 64 * 3),
                     scene_word(stage, "k_big"));
    assert_number(stage_word(stage, bound + 64 * 4), 1e60);
}

/* No bounds, where there are none and where nobody wants them. */
static void test_no_bounds(void **state)
{
    static const char *const texts[] = { "plane { y, 0 }",
                                         "sphere { 0, 1 }" };

    (void)state;
    for (size_t i = 0; i < COUNT(texts); i++) {
        struct stage stage;

        raise_curtain(&stage, texts[i],
                      i == 0 ? BOUNDING_FLAT : BOUNDING_NONE);
        check_bound(&stage, scene_word(&stage, "scene_regions"), "R_BOUND");
        check_bound(&stage, region(&stage, 0, "R_NODES"), "N_BOUND");
        drop_curtain(&stage);
    }
}

static void test_bounds(void **state)
{
    struct stage stage;
    uint64_t bound;

    (void)state;
    raise_curtain(&stage,
                  "difference { sphere { <1, 2, 3>, 2 } box { 0, 9 }"
                  " inverse }",
                  BOUNDING_FLAT);
    bound = scene_word(&stage, "scene_regions")
            + 64 * symbol(&stage, "R_BOUND");
    for (int i = 0; i < 3; i++)
        assert_number(stage_word(&stage, bound + 64 * (uint64_t)i), i + 1);
    double radius = c205_to_double(stage_word(&stage, bound + 64 * 3));
    assert_close(radius, 2.002, 1e-6);
    assert_close(c205_to_double(stage_word(&stage, bound + 64 * 4)),
                 radius * radius, 1e-9);
    drop_curtain(&stage);
}

/* --- steps --------------------------------------------------------------- */

/* Some solid of at most so many primitives, in the scene language. */
static char *add_solid(char *end, size_t most)
{
    static const char *const words[] = { "union", "merge", "intersection",
                                         "difference" };
    size_t children = 2 + xorshift(&random_state) % 4;

    if (most < children || xorshift(&random_state) % 4 == 0) {
        end += sprintf(end, "sphere { 0, 1");
    } else {
        end += sprintf(end, "%s { ", words[xorshift(&random_state) % 4]);
        for (size_t i = 0; i < children; i++)
            end = add_solid(end, most / children);
    }
    return end
           + sprintf(end, "%s } ",
                     xorshift(&random_state) % 4 ? "" : " inverse");
}

/* The value of a node where the i-th primitive's is bit i. */
static bool tree_value(const struct scene *scene, size_t node, size_t first,
                       uint64_t bits)
{
    const struct tree_node *tree = &scene->nodes[node];
    bool value = tree->operation == TREE_AND;

    if (tree->operation == TREE_LEAF)
        return bits >> (tree->primitive - first) & 1;
    for (size_t child = node + 1; child < tree->next;
         child = scene->nodes[child].next) {
        bool other = tree_value(scene, child, first, bits);
        value = tree->operation == TREE_AND  ? value && other
                : tree->operation == TREE_OR ? value || other
                                             : !other;
    }
    return value;
}

static bool steps_value(const struct stage *stage, size_t i, uint64_t bits)
{
    uint64_t steps = region(stage, i, "R_STEPS");
    int64_t count = c205_to_integer(region(stage, i, "R_STEP_COUNT"));
    int64_t leaves = c205_to_integer(region(stage, i, "R_PRIMITIVES"));
    bool values[200];

    for (int64_t k = 0; k < leaves; k++)
        values[k] = bits >> k & 1;
    for (size_t k = 0; k < (size_t)count; k++) {
        int64_t step[4];

        for (int part = 0; part < 4; part++) {
            static const char *const names[] = { "T_OPERATION", "T_LEFT",
                                                 "T_RIGHT", "T_RESULT" };
            step[part] = c205_to_integer(
                field_of(stage, steps, "T_SIZE", k, names[part]));
            assert_true(step[part] >= 0 && step[part] < 200);
        }
        assert_true(step[3] >= leaves); /* the primitives' stay */
        values[step[3]] = step[0] == STEP_AND
                              ? values[step[1]] && values[step[2]]
                          : step[0] == STEP_OR
                              ? values[step[1]] || values[step[2]]
                              : values[step[1]] && !values[step[2]];
    }
    return values[c205_to_integer(region(stage, i, "R_RESULT"))];
}

/* Steps tell the tree's value or, always, its complement. */
static void test_steps(void **state)
{
    enum { SCENES = 300, MOST = 40, TRIES = 50 };

    (void)state;
    for (int scene = 0; scene < SCENES; scene++) {
        char text[4000];
        struct stage stage;

        add_solid(text, MOST);
        raise_curtain(&stage, text, BOUNDING_FLAT);
        for (size_t i = 0; i < stage.scene->region_count; i++) {
            const struct region *tree = &stage.scene->regions[i];
            bool complement = tree_value(stage.scene, tree->first_node,
                                         tree->first_primitive, 0)
                              != steps_value(&stage, i, 0);
            for (int try = 0; try < TRIES; try++) {
                uint64_t bits = xorshift(&random_state);
                bool value = tree_value(stage.scene, tree->first_node,
                                        tree->first_primitive, bits);
                if (steps_value(&stage, i, bits) != (value != complement))
                    fail_msg("region %zu, primitives %llX of %s", i,
                             (unsigned long long)bits, text);
            }
        }
        drop_curtain(&stage);
    }
}

/* Each step has a value to itself, and each value but the last is a part of
 * one step: so from any primitive there is one way up. */
static void test_values(void **state)
{
    static const char *const texts[] = {
        "sphere { 0, 1 inverse }",
        "difference { box { 0, 1 } box { 0, 1 } box { 0, 1 } }",
        "merge { box { 0, 1 } intersection { box { 0, 1 } box { 0, 1 } } }",
        "merge { intersection { box { 0, 1 } box { 0, 1 } }"
        " intersection { box { 0, 1 } box { 0, 1 } } }",
    };

    (void)state;
    for (size_t i = 0; i < COUNT(texts); i++) {
        struct scene *scene = read_scene(texts[i]);
        struct tree_step steps[8];
        struct tree_plan plan = { .steps = steps };
        size_t leaves = scene->primitive_count, parts[16] = { 0 };

        assert_true(plan_tree(scene, scene->regions, &plan));
        assert_int_equal(plan.step_count, leaves - 1);
        for (size_t k = 0; k < plan.step_count; k++) {
            assert_int_equal(steps[k].result, leaves + k);
            assert_true(steps[k].left < leaves + k);
            assert_true(steps[k].right < leaves + k);
            parts[steps[k].left]++;
            parts[steps[k].right]++;
        }
        for (size_t k = 0; k < leaves + plan.step_count; k++)
            assert_int_equal(parts[k], k != plan.result);
        scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_primitives), cmocka_unit_test(test_crossings),
        cmocka_unit_test(test_regions),    cmocka_unit_test(test_nodes),
        cmocka_unit_test(test_no_bounds),  cmocka_unit_test(test_bounds),
        cmocka_unit_test(test_steps),      cmocka_unit_test(test_values),
    };

    return cmocka_run_group_tests_name("regions", tests, set_up_model,
                                       tear_down_model);
}
