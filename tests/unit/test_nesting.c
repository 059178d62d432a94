/* test_nesting.c - trees with many parts are compared with the grouped trees that
 * replace them. Over random trees, both must be the same solid of the same primitives.
 * A part in the wrong group fails here. */
#include "rt/layout/nesting.h"
#include "tests/unit/draw.h"
#include "tests/unit/scene_reading.h"
#include "tests/unit/tree_value.h"

/* ---- Random trees ----------------------------------------------------- */

enum { NODES = 2000 };

struct forest {
    struct scene scene;
    struct tree_node nodes[NODES];
    struct region region;
    struct primitive primitives[NODES];
};

static size_t add_node(struct forest *forest, enum tree_operation operation)
{
    size_t node = forest->scene.node_count++;
    assert_true(node < NODES);
    forest->nodes[node].operation = operation;
    return node;
}

/* Adds a sphere at a random position, or a plane, which is unbounded. */
static void add_leaf(struct forest *forest)
{
    size_t node = add_node(forest, TREE_LEAF);
    size_t primitive = forest->scene.primitive_count++;
    struct primitive *leaf = &forest->primitives[primitive];
    *leaf = (struct primitive){ .kind = below(12) ? PRIMITIVE_SPHERE
                                                  : PRIMITIVE_PLANE };
    for (int i = 0; i < 3; i++)
        leaf->to_local.rows[i][i] = leaf->to_world.rows[i][i] = 1;
    if (leaf->kind == PRIMITIVE_SPHERE) {
        for (int i = 0; i < 3; i++)
            leaf->shape.sphere.center[i] = (double)below(below(3) ? 30 : 1);
        leaf->shape.sphere.radius = 1 + (double)below(3);
    } else {
        leaf->shape.plane.normal[1] = 1;
    }
    forest->nodes[node].primitive = primitive;
    forest->nodes[node].next = node + 1;
}

static void add_tree(struct forest *forest, int depth)
{
    enum tree_operation operation = (enum tree_operation)below(4);
    size_t children = operation == TREE_NOT ? 1 : 1 + below(14);
    if (depth == 0 || operation == TREE_LEAF || forest->scene.node_count > NODES / 2) {
        add_leaf(forest);
        return;
    }
    if (operation != TREE_NOT && below(20) == 0)
        children *= 20;
    size_t node = add_node(forest, operation);
    bool difference = operation == TREE_AND && below(2) == 0;
    for (size_t i = 0; i < children; i++) {
        size_t away = difference && i > 0 ? add_node(forest, TREE_NOT) : 0;
        add_tree(forest, children > 14 ? 0 : depth - 1);
        if (away > 0)
            forest->nodes[away].next = forest->scene.node_count;
    }
    forest->nodes[node].next = forest->scene.node_count;
}

static void grow(struct forest *forest)
{
    forest->scene = (struct scene){ .nodes = forest->nodes,
                                    .regions = &forest->region,
                                    .region_count = 1,
                                    .primitives = forest->primitives };
    add_tree(forest, 4);
    forest->region = (struct region){
        .primitive_count = forest->scene.primitive_count,
        .node_count = forest->scene.node_count,
    };
}

/* ---- Rules for nested trees ---------------------------------------------- */

/* Checks the nodes from `node` to `end`. The descendants of a node follow it, child by
 * child. A complement has one child. */
static void check_shape(const struct scene *scene, size_t node, size_t end)
{
    const struct tree_node *tree = &scene->nodes[node];
    size_t child = node + 1, children = 0;
    assert_true(tree->next > node && tree->next <= end);
    for (; child < tree->next; child = scene->nodes[child].next) {
        check_shape(scene, child, tree->next);
        children++;
    }
    assert_int_equal(child, tree->next);
    assert_true(tree->operation == TREE_LEAF  ? children == 0
                : tree->operation == TREE_NOT ? children == 1
                                              : children > 0);
}

/* All parts below a union, at any depth, must be within the bound of the union. */
static void check_within(const struct nested_scene *nested, size_t node,
                         const struct bound *whole)
{
    const struct tree_node *nodes = nested->scene.nodes;
    if (nodes[node].operation != TREE_OR)
        assert_true(bound_reach(&nested->bounds[node], whole->center)
                    <= 1.001 * whole->radius);
    else
        for (size_t child = node + 1; child < nodes[node].next;
             child = nodes[child].next)
            check_within(nested, child, whole);
}

/* Checks that each primitive of the scene is exactly one leaf of the nested scene. */
static void check_leaves(const struct scene *scene, const struct scene *nested)
{
    FREED bool *there = NON_NULL(calloc(scene->primitive_count, sizeof *there));
    size_t count = 0;
    for (size_t i = 0; i < nested->node_count; i++) {
        size_t leaf = nested->nodes[i].primitive;
        if (nested->nodes[i].operation != TREE_LEAF)
            continue;
        assert_true(leaf < scene->primitive_count && !there[leaf]);
        there[leaf] = true;
        count++;
    }
    assert_int_equal(count, scene->primitive_count);
}

static void check_values(const struct scene *scene, const struct scene *nested)
{
    enum { TRIES = 40 };
    static bool inside[NODES];
    for (int try = 0; try < TRIES; try++) {
        size_t few = 1 + below(try % 2 ? 400 : 4);
        for (size_t i = 0; i < scene->primitive_count; i++)
            inside[i] = below(few) == 0;
        assert_int_equal(tree_value(nested, nested->regions[0].first_node, inside),
                         tree_value(scene, scene->regions[0].first_node, inside));
    }
}

TEST(random_trees)
{
    enum { FORESTS = 400 };
    static struct forest forest;
    size_t nested_more = 0;
    for (int i = 0; i < FORESTS; i++) {
        FREED_BY(nesting_free) struct nested_scene nested;
        grow(&forest);
        assert_true(nesting_make(&forest.scene, &nested));
        assert_int_equal(nested.scene.regions[0].first_node, 0);
        assert_int_equal(nested.scene.regions[0].node_count, nested.scene.node_count);
        check_shape(&nested.scene, 0, nested.scene.node_count);
        assert_int_equal(nested.scene.nodes[0].next, nested.scene.node_count);
        check_leaves(&forest.scene, &nested.scene);
        check_values(&forest.scene, &nested.scene);
        for (size_t k = 0; k < nested.scene.node_count; k++)
            if (nested.scene.nodes[k].operation == TREE_OR
                && !bound_is_none(&nested.bounds[k]))
                check_within(&nested, k, &nested.bounds[k]);
        assert_true(nested.scene.node_count <= 3 * forest.scene.node_count);
        nested_more += nested.scene.node_count > forest.scene.node_count;
    }
    assert_in_range(nested_more, FORESTS / 10, FORESTS);
}

/* ---- Depth --------------------------------------------------------------- */

static size_t depth_of(const struct scene *scene, size_t node)
{
    size_t most = 0;
    for (size_t child = node + 1; child < scene->nodes[node].next;
         child = scene->nodes[child].next) {
        size_t depth = depth_of(scene, child);

        most = depth > most ? depth : most;
    }
    return 1 + most;
}

/* Spheres in a row, at one point, or at increasing distances. */
TEST(depth)
{
    static const struct {
        const char *sphere;
        size_t count, least, most;
    } rows[] = {
        { "I*x, .6", 1000, 8, 24 },
        { "3*I*x, 1", 8, 3, 5 },
        { "0, 1", 1000, 2, 2 },
        { "pow(2, I/2)*x, pow(2, I/2)/3", 400, 8, 80 },
        { "<mod(I, 40), int(I/40), 0>, .4", 4000, 8, 40 },
    };
    for (size_t i = 0; i < COUNT(rows); i++) {
        SCOPED(scene)
        *scene = read_format("merge { #for (I, 1, %zu) sphere { %s } #end }",
                             rows[i].count, rows[i].sphere);
        FREED_BY(nesting_free) struct nested_scene nested;
        assert_true(nesting_make(scene, &nested));
        assert_in_range(depth_of(&nested.scene, 0), rows[i].least, rows[i].most);
        check_leaves(scene, &nested.scene);
    }
}

/* Trees with few parts do not change. Neither do unions that are several regions. */
TEST(few_parts)
{
    static const char *const texts[] = {
        "sphere { 0, 1 }",
        "union { #for (I, 1, 100) sphere { 3*I*x, 1 } #end }",
        "merge { #for (I, 1, 7) sphere { 3*I*x, 1 } #end }",
        "difference { box { 0, 9 } #for (I, 1, 7) sphere { 3*I*x, 1 } #end }",
        "intersection { #for (I, 1, 50) sphere { I/99*x, 1 } #end }",
        "merge { #for (I, 1, 50) plane { y, I } #end }",
    };
    for (size_t i = 0; i < COUNT(texts); i++) {
        SCOPED(scene) *scene = read_scene(texts[i]);
        FREED_BY(nesting_free) struct nested_scene nested;
        assert_true(nesting_make(scene, &nested));
        assert_int_equal(nested.scene.node_count, scene->node_count);
        for (size_t k = 0; k < scene->node_count; k++) {
            assert_int_equal(nested.scene.nodes[k].operation,
                             scene->nodes[k].operation);
            assert_int_equal(nested.scene.nodes[k].next, scene->nodes[k].next);
        }
    }
}
