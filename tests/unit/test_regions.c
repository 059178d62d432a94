/* test_regions.c - the regions, nodes and steps in a machine's memory are compared with
 * the scene, and their values with the values of the trees, over random solids. A wrong
 * kernel, link, bound or operation of a step fails here. */
#include "tests/unit/scene_fixture.h"

#include "rt/layout/trees.h"
#include "rt/bvh/bound.h"
#include "tests/unit/draw.h"
#include "tests/unit/tree_value.h"

enum { PLACES = 400 }; /* largest number of values of a tree */

/* ---- Primitives --------------------------------------------------------- */

#define PATCH "steiner_patch { x, y, z, 0, 0, 0 "
#define CURVED \
    "prism { quadratic_spline 0, 1, 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <1, 0> "
#define SQUARE "prism { 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> "

static const struct shape_row {
    const char *text;
    const char *alone, *kernel, *state; /* kernel of the shape alone; kernels in a
                                         * tree */
    int segments, events, first_event;
} shape_rows[] = {
    { "sphere { 0, 1", "sphere", "sphere", NULL, 1, 2, 0 },
    { "box { 0, 1", "box", "box", NULL, 1, 2, 0 },
    { "cylinder { 0, y, 1", "cylinder", "cylinder", NULL, 1, 2, 0 },
    { "cylinder { 0, y, 1 open", "open_cylinder", "open_cylinder", "cylinder", 1, 2,
      2 },
    { "plane { y, 0", "plane", "plane", NULL, 1, 2, 0 },
    { "cone { 0, 1, y, 0", "cone", "cone", NULL, 1, 2, 0 },
    { "cone { 0, 1, y, 0 open", "open_cone", "open_cone", "cone", 1, 2, 2 },
    { "torus { 1, .2", "torus", "torus_solid", NULL, 2, 4, 0 },
    { "elliptical_torus { 1, .2, .3", "elliptical_torus", "elliptical_torus_solid",
      NULL, 2, 4, 0 },
    { "quadric { 1, 0, 0, -1", "quadric", "quadric_solid", NULL, 2, 4, 0 },
    { "quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,"
      "1,0,0,0,-1>",
      "quartic_surface", "quartic_solid", NULL, 3, 6, 0 },
    { SQUARE, "prism", "prism_solid", NULL, 1, 2, 0 },
    { SQUARE "open", "open_prism", "open_prism_sides", "prism_solid", 1, 2, 2 },
    { "prism { 0, 1, 4, <0, 0>, <2, 1>, <0, 2>, <1, 1>", "prism", "prism_solid", NULL,
      2, 4, 0 },
    { CURVED, "quadratic_prism", "quadratic_prism_solid", NULL, 1, 2, 0 },
    { CURVED "open", "open_quadratic_prism", "open_quadratic_prism_sides",
      "quadratic_prism_solid", 1, 2, 2 },
    { "lathe { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1>", "lathe", "lathe_solid", NULL, 1, 2,
      0 },
    { "lathe { 3, <0, 0>, <1, 1>, <1, 2>", "lathe", "open_lathe_crossings",
      "lathe_solid", 2, 4, 4 },
    { "blob { sphere { 0, 1, 2 }", "blob", "blob_solid", NULL, 1, 2, 0 },
    { "blob { sphere { 0, 1, 2 } sphere { 1, 1, -1 }", "blob", "blob_solid", NULL, 6,
      12, 0 },
    { "blob { cylinder { 0, y, 1, 2 } sphere { 1, 1, 2 }", "blob", "blob_solid", NULL,
      5, 10, 0 },
    { PATCH, "steiner", "steiner_crossings", NULL, 0, 4, 0 },
    { PATCH "weights 1,2,1,1,1,1", "rational_steiner", "rational_steiner_crossings",
      NULL, 0, 4, 0 },
};

/* Returns the flags of a region's record, REGION_SIMPLE and REGION_BOXED. */
static int64_t way_of(const struct stage *stage, size_t i)
{
    return c205_to_integer(region(stage, i, "R_FLAGS"));
}

/* Returns a position's distance from the first crossing or value, in such units. */
static int64_t behind_first(const struct stage *stage, size_t i, const char *name,
                            const char *size)
{
    const char *first = strcmp(name, "P_VALUE") == 0 ? name : "P_FIRST_STATE";
    uint64_t bits = primitive(stage, i, name) - primitive(stage, 0, first);
    assert_int_equal(bits % (64 * symbol(stage, size)), 0);
    return (int64_t)(bits / (64 * symbol(stage, size)));
}

static void check_kernel(const struct stage *stage, size_t i, const char *kernel,
                         const char *inner, const char *expected)
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

/* Checks a shape in a tree after a sphere, and alone. */
static void check_shape(const struct shape_row *row, const char *how)
{
    const char *text = formatted("merge { sphere { 0, 3 } %s %s } } %s %s }", row->text,
                                 how, row->text, how);
    SCOPED_VALUE(stage) stage = stage_of(text, BOUNDING_FLAT);
    check_kernel(&stage, 1, "P_KERNEL", "P_INNER", row->kernel);
    check_kernel(&stage, 1, "P_STATE_KERNEL", "P_STATE_INNER", row->state);
    assert_integer(primitive(&stage, 1, "P_SEGMENTS"), row->segments);
    assert_integer(primitive(&stage, 1, "P_EVENTS"), row->events);
    assert_int_equal(behind_first(&stage, 1, "P_FIRST_STATE", "CROSSING_SIZE"), 2);
    assert_int_equal(behind_first(&stage, 1, "P_FIRST_EVENT", "CROSSING_SIZE"),
                     2 + row->first_event);
    assert_int_equal(behind_first(&stage, 1, "P_VALUE", "VALUE_SIZE"), 1);
    assert_int_equal(way_of(&stage, 0) & 1, 0);
    check_kernel(&stage, 2, "P_KERNEL", "P_INNER", row->alone);
    check_kernel(&stage, 2, "P_STATE_KERNEL", "P_STATE_INNER", NULL);
    assert_int_equal(way_of(&stage, 1) & 1, 1);
}

TEST(primitives)
{
    for (size_t i = 0; i < COUNT(shape_rows); i++) {
        check_shape(&shape_rows[i], "");
        check_shape(&shape_rows[i], "scale <1, 2, 3> rotate 40*x");
    }
}

/* Open shapes need room for crossings and events. Patches need room for parameters. */
TEST(crossings)
{
    static const struct {
        const char *text;
        uint64_t crossings;
        size_t last, first_event;
    } rows[] = {
        { "merge { box { 0, 1 } cylinder { 0, y, 1 open } torus { 1, .2 } }", 10, 2,
          6 },
        { "merge { " PATCH "} sphere { 0, 1 } }", 14, 1, 12 },
        { "sphere { 0, 1 pigment { rgbt 1 } } torus { 1, .2 }", 2, 0, 0 },
        { "cylinder { 0, y, 1 open pigment { rgbt 1 } }", 4, 0, 2 },
        { "prism { 0, 1, 4, <0, 0>, <2, 1>, <0, 2>, <1, 1> open pigment { rgbt 1 } }",
          8, 0, 4 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        uint64_t room = 64 * 2 * rows[i].crossings;
        c205_word word;
        SCOPED_VALUE(stage) stage = stage_of(rows[i].text, BOUNDING_FLAT);
        uint64_t first = primitive(&stage, 0, "P_FIRST_STATE");
        assert_int_equal(behind_first(&stage, rows[i].last, "P_FIRST_EVENT",
                                      "CROSSING_SIZE"),
                         rows[i].first_event);
        assert_true(c205_read(stage.machine, first + room - 64, &word, 1));
    }
}

/* A tree of n leaves has n values and n - 1 steps. */
TEST(room)
{
    enum { LEAVES = 5 };
    SCOPED_VALUE(stage) stage =
        stage_of("sphere { 0, 1 } merge { sphere { 0, 1 } sphere { x, 1 }"
                 " box { 0, 1 } box { 0, 1 } sphere { y, 1 } }",
                 BOUNDING_HIERARCHY);
    uint64_t values = primitive(&stage, 0, "P_VALUE");
    uint64_t leaves = scene_word(&stage, "scene_leaves");
    uint64_t branches = scene_word(&stage, "scene_branches");
    assert_int_equal(leaves - values,
                     64 * symbol(&stage, "VALUE_SIZE") * (2 * LEAVES - 1));
    assert_int_equal(branches - leaves, 64 * symbol(&stage, "LEAF_SIZE") * LEAVES);
}

/* ---- Regions and nodes -------------------------------------------------- */

TEST(regions)
{
    /* 1: the region is simple; 2: its box is much smaller than its sphere */
    static const struct {
        int way, shadow, first;
    } rows[] = {
        { 1, 1, 0 }, { 3, 0, 1 }, { 0, 2, 2 }, { 0, 1, 3 },
        { 0, 2, 5 }, { 2, 0, 7 }, { 1, 1, 9 },
    };
    SCOPED_VALUE(stage) stage =
        stage_of("sphere { 0, 1.2 } box { .1, .9 no_shadow }\n"
                 "plane { y, 0 pigment { checker rgb 1, rgbf 1 } }\n"
                 "merge { sphere { 0, 1 } box { 0, 1 no_shadow } }\n"
                 "merge { sphere { 0, 1 } box { 0, 1 } pigment { rgbt 1 } }\n"
                 "merge { sphere { 0, 1 } box { 0, <9, 1, 1> } no_shadow }\n"
                 "sphere { 0, 1.5 inverse }",
                 BOUNDING_FLAT);
    assert_integer(scene_word(&stage, "scene_region_count"), COUNT(rows));
    for (size_t i = 0; i < COUNT(rows); i++) {
        size_t first = (size_t)rows[i].first;
        assert_int_equal(way_of(&stage, i), rows[i].way);
        assert_integer(region(&stage, i, "R_SHADOW"), rows[i].shadow);
        assert_int_equal(region(&stage, i, "R_FIRST"), primitive_at(&stage, first));
    }
    assert_integer(primitive(&stage, 8, "P_INVERTED"), 0);
    assert_integer(primitive(&stage, 9, "P_INVERTED"), 1);
}

/* The classes of rays from which a region is hidden. */
TEST(hidden)
{
    static const int hidden_from[] = { 0, 1, 2, 3, 1, 3, 1, 0, 0 };
    SCOPED_VALUE(stage) stage =
        stage_of("sphere { 0, 1 } sphere { 0, 1 no_image }\n"
                 "sphere { 0, 1 no_reflection }\n"
                 "merge { sphere { 0, 1 } box { 0, 1 } no_image no_reflection }\n"
                 "union { sphere { 0, 1 } box { 0, 1 no_reflection"
                 " no_image off } no_image }\n"
                 "sphere { 0, 1 clipped_by { plane { y, 0 } } no_image }\n"
                 "sphere { 0, 1 clipped_by { plane { y, 0 no_image } } }\n"
                 "intersection { sphere { 0, 1 no_image } box { 0, 1 no_image } }",
                 BOUNDING_FLAT);
    assert_integer(scene_word(&stage, "scene_region_count"), COUNT(hidden_from));
    for (size_t i = 0; i < COUNT(hidden_from); i++)
        assert_integer(region(&stage, i, "R_HIDDEN_FROM"), hidden_from[i]);
}

/* The nodes in preorder, without complements, of &(|(0,1), !(&(2, !(3))), 4). */
TEST(nodes)
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
    SCOPED_VALUE(stage) stage = stage_of(text, BOUNDING_FLAT);
    uint64_t nodes = region(&stage, 0, "R_NODES");
    uint64_t size = 64 * symbol(&stage, "N_SIZE");
    assert_int_equal(region(&stage, 0, "R_NODES_END"), nodes + 8 * size);
    for (size_t i = 0; i < COUNT(rows); i++) {
        size_t first = (size_t)rows[i].first;
        uint64_t leaf = field_of(&stage, nodes, "N_SIZE", i, "N_PRIMITIVE");
        uint64_t bound = symbol(&stage, "N_BOUND") + 3;
        double radius = c205_to_double(
            stage_word(&stage, nodes + size * i + 64 * bound));
        assert_int_equal(leaf, rows[i].leaf ? primitive_at(&stage, first) : 0);
        assert_int_equal(field_of(&stage, nodes, "N_SIZE", i, "N_NEXT"),
                         nodes + size * rows[i].next);
        assert_close(radius, rows[i].radius, .002 * rows[i].radius);
        assert_integer(field_of(&stage, nodes, "N_SIZE", i, "N_NEEDED"),
                       rows[i].needed);
    }
}

static void check_bound(const struct stage *stage, uint64_t address, const char *name)
{
    uint64_t bound = address + 64 * symbol(stage, name);
    assert_int_equal(stage_word(stage, bound + 64 * 3), scene_word(stage, "k_big"));
    assert_number(stage_word(stage, bound + 64 * 4), 1e60);
}

/* Unbounded regions have no bounds. No region has a bound if bounding is disabled. */
TEST(no_bounds)
{
    static const char *const texts[] = { "plane { y, 0 }", "sphere { 0, 1 }" };
    for (size_t i = 0; i < COUNT(texts); i++) {
        SCOPED_VALUE(stage) stage = stage_of(texts[i],
                                             i == 0 ? BOUNDING_FLAT : BOUNDING_NONE);
        check_bound(&stage, scene_word(&stage, "scene_regions"), "R_BOUND");
        check_bound(&stage, region(&stage, 0, "R_NODES"), "N_BOUND");
    }
}

TEST(bounds)
{
    SCOPED_VALUE(stage) stage =
        stage_of("difference { sphere { <1, 2, 3>, 2 } box { 0, 9 } inverse }",
                 BOUNDING_FLAT);
    uint64_t bound = scene_word(&stage, "scene_regions")
                     + 64 * symbol(&stage, "R_BOUND");
    for (int i = 0; i < 3; i++)
        assert_number(stage_word(&stage, bound + 64 * (uint64_t)i), i + 1);
    double radius = c205_to_double(stage_word(&stage, bound + 64 * 3));
    assert_close(radius, 2.002, 1e-6);
    assert_close(c205_to_double(stage_word(&stage, bound + 64 * 4)), radius * radius,
                 1e-9);
}

/* ---- Steps -------------------------------------------------------------- */

/* Writes a random solid with at most `most` primitives. */
static char *add_solid(char *end, size_t most)
{
    static const char *const words[] = { "union", "merge", "intersection",
                                         "difference" };
    size_t children = 2 + below(4);
    if (most > 16 && below(2) == 0)
        children = 8 + below(9);
    if (most < children || below(4) == 0) {
        int radius = 1 + (int)below(4), z = (int)below(3), y = (int)below(20);
        end += sprintf(end, "sphere { <%d, %d, %d>, %d", (int)below(20), y, z, radius);
    } else {
        end += sprintf(end, "%s { ", words[below(4)]);
        for (size_t i = 0; i < children; i++)
            end = add_solid(end, most / children);
    }
    return end + sprintf(end, "%s } ", below(4) ? "" : " inverse ");
}

/* Evaluates a region's tree like the machine, for given values of the primitives.
 * Reading an unknown value is a failure. */
struct evaluation {
    const struct stage *stage;
    const bool *inside; /* for each primitive: the point is inside */
    bool value[PLACES], known[PLACES];
    size_t visited; /* number of visited nodes */
    uint64_t branches[PLACES];
    size_t branch_count;
};

static size_t value_place(const struct stage *stage, uint64_t address)
{
    uint64_t bits = address - primitive(stage, 0, "P_VALUE");
    assert_true(bits < 64 * symbol(stage, "VALUE_SIZE") * PLACES);
    return (size_t)(bits / (64 * symbol(stage, "VALUE_SIZE")));
}

static void print_value(struct evaluation *evaluation, uint64_t address, bool value)
{
    size_t place = value_place(evaluation->stage, address);
    evaluation->value[place] = value;
    evaluation->known[place] = true;
}

static bool ask_value(const struct evaluation *evaluation, uint64_t address)
{
    size_t place = value_place(evaluation->stage, address);
    assert_true(evaluation->known[place]);
    return evaluation->value[place];
}

static bool is_inside(const struct evaluation *evaluation, uint64_t leaf)
{
    uint64_t bits = leaf - primitive_at(evaluation->stage, 0);
    return evaluation->inside[bits / (64 * symbol(evaluation->stage, "P_SIZE"))];
}

/* Returns true if the point is in a primitive of the node, or it has no bound. */
static bool may_be_inside(const struct evaluation *evaluation, uint64_t node)
{
    const struct stage *stage = evaluation->stage;
    uint64_t next = field_of(stage, node, "N_SIZE", 0, "N_NEXT");
    uint64_t radius = node + 64 * (symbol(stage, "N_BOUND") + 3);
    bool may_be = stage_word(stage, radius) == scene_word(stage, "k_big");
    for (; node != next; node += 64 * symbol(stage, "N_SIZE")) {
        uint64_t leaf = field_of(stage, node, "N_SIZE", 0, "N_PRIMITIVE");
        may_be = may_be || (leaf && is_inside(evaluation, leaf));
    }
    return may_be;
}

/* Visits the nodes of a region. Skips those below a node that excludes the point. */
static void visit_nodes(struct evaluation *evaluation, size_t i)
{
    const struct stage *stage = evaluation->stage;
    uint64_t node = region(stage, i, "R_NODES");
    while (node != region(stage, i, "R_NODES_END")) {
        uint64_t leaf = field_of(stage, node, "N_SIZE", 0, "N_PRIMITIVE");
        uint64_t value = field_of(stage, node, "N_SIZE", 0, "N_VALUE");
        bool near = may_be_inside(evaluation, node);
        evaluation->visited++;
        if (near && !leaf)
            evaluation->branches[evaluation->branch_count++] = node;
        else
            print_value(evaluation, value, near && is_inside(evaluation, leaf));
        node = near ? node + 64 * symbol(stage, "N_SIZE")
                    : field_of(stage, node, "N_SIZE", 0, "N_NEXT");
    }
}

static void take_steps(struct evaluation *evaluation, uint64_t node)
{
    const struct stage *stage = evaluation->stage;
    uint64_t step = field_of(stage, node, "N_SIZE", 0, "N_STEPS");
    int64_t count = c205_to_integer(field_of(stage, node, "N_SIZE", 0, "N_STEP_COUNT"));
    for (; count > 0; count--, step += 64 * symbol(stage, "T_SIZE")) {
        bool left = ask_value(evaluation, field_of(stage, step, "T_SIZE", 0, "T_LEFT"));
        bool right = ask_value(evaluation,
                               field_of(stage, step, "T_SIZE", 0, "T_RIGHT"));
        int64_t operation = c205_to_integer(
            field_of(stage, step, "T_SIZE", 0, "T_OPERATION"));
        print_value(evaluation, field_of(stage, step, "T_SIZE", 0, "T_RESULT"),
                    operation == STEP_AND  ? left && right
                    : operation == STEP_OR ? left || right
                                           : left && !right);
    }
}

static bool machine_value(const struct stage *stage, size_t i, const bool *inside,
                          size_t *visited)
{
    struct evaluation evaluation = { .stage = stage, .inside = inside };
    visit_nodes(&evaluation, i);
    while (evaluation.branch_count > 0)
        take_steps(&evaluation, evaluation.branches[--evaluation.branch_count]);
    *visited = evaluation.visited;
    return ask_value(&evaluation, region(stage, i, "R_RESULT"));
}

/* Records of regions are in the order of the hierarchy. */
static void check_region(const struct stage *stage, size_t i, const char *text)
{
    enum { TRIES = 50 };
    const struct region *tree = stage->scene->regions;
    while (primitive_at(stage, tree->first_primitive) != region(stage, i, "R_FIRST"))
        tree++;
    size_t last = tree->first_primitive + tree->primitive_count, visited;
    bool inside[PLACES] = { false };
    bool nothing = machine_value(stage, i, inside, &visited);
    bool complement = tree_value(stage->scene, tree->first_node, inside) != nothing;

    for (int try = 0; try < TRIES; try++) {
        uint64_t few = 1 + below(8);
        for (size_t k = tree->first_primitive; k < last; k++)
            inside[k] = below(few) == 0;
        bool value = tree_value(stage->scene, tree->first_node, inside);
        FAIL_IF(machine_value(stage, i, inside, &visited) != (value != complement),
                "region %zu of %s", i, text);
    }
}

/* The steps compute the value of the tree, or always its complement. If the point is
 * outside of a node, the steps below the node are not needed. */
TEST(steps)
{
    enum { SCENES = 300, MAX = 40 };
    for (int scene = 0; scene < SCENES; scene++) {
        char text[8000];
        add_solid(text, MAX);
        SCOPED_VALUE(stage) stage = stage_of(text, scene % 2 ? BOUNDING_FLAT
                                                             : BOUNDING_HIERARCHY);
        for (size_t i = 0; i < stage.scene->region_count; i++)
            check_region(&stage, i, text);
    }
}

#define BALLS "#for (I, 0, 149) sphere { I*x, .6 } #end "

/* In a tree with many parts, a point inside one part visits few nodes. */
TEST(many_parts)
{
    static const char *const texts[] = {
        "merge { " BALLS "}",
        "difference { box { -1, 1 } " BALLS "}",
        "intersection { box { -1, 1 } merge { " BALLS "} }",
    };
    for (size_t way = 0; way < COUNT(texts); way++) {
        size_t visited;
        SCOPED_VALUE(stage) stage = stage_of(texts[way], BOUNDING_HIERARCHY);
        for (size_t i = 0; i < stage.scene->primitive_count; i++) {
            bool inside[PLACES] = { false };
            inside[0] = inside[i] = true;
            machine_value(&stage, 0, inside, &visited);
            assert_in_range(visited, 3, 50);
        }
    }
}

/* Each step has its own value, and each value except the last belongs to one step.
 * Every primitive therefore has a unique path to the root. */
TEST(values)
{
    static const char *const texts[] = {
        "sphere { 0, 1 inverse }",
        "difference { box { 0, 1 } box { 0, 1 } box { 0, 1 } }",
        "merge { box { 0, 1 } intersection { box { 0, 1 } box { 0, 1 } } }",
        "merge { intersection { box { 0, 1 } box { 0, 1 } }"
        " intersection { box { 0, 1 } box { 0, 1 } } }",
    };
    for (size_t i = 0; i < COUNT(texts); i++) {
        SCOPED(scene) *scene = read_scene(texts[i]);
        struct tree_step steps[8];
        struct tree_join joins[16];
        struct tree_plan plan = { .steps = steps, .joins = joins };
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
    }
}

/* The body inside a region is its value or the complement of its value. There is no
 * body if a part is open or invisible. */
TEST(bodies)
{
    static const struct {
        const char *text;
        int64_t body;
    } cases[] = {
        { "sphere { 0, 1 }", 1 },
        { "sphere { 0, 1 inverse }", -1 },
        { "plane { y, 0 }", 1 },
        { "difference { box { -1, 1 } sphere { 0, 1 } }", 1 },
        { "merge { box { -1, 1 inverse } sphere { 0, 1 inverse } }", -1 },
        { "intersection { box { -1, 1 } sphere { 0, 1 inverse } inverse }", -1 },
        { "disc { 0, y, 1 }", 0 },
        { "cylinder { 0, y, 1 open }", 0 },
        { "difference { box { -1, 1 } cylinder { -2*y, 2*y, .5 open } }", 0 },
        { "triangle { 0, x, y }", 0 },
        { "mesh { triangle { 0, x, y } triangle { 0, y, z }"
          " triangle { 0, z, x } triangle { x, y, z } inside_vector x }",
          1 },
        { "steiner_patch { 0, x, y, x + z, y + z, x + y }", 0 },
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        SCOPED_VALUE(stage) stage = stage_of(cases[i].text, BOUNDING_HIERARCHY);
        assert_integer(region(&stage, 0, "R_BODY"), cases[i].body);
    }
}
