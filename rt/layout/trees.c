/* trees.c - plans the evaluation of a region's tree. */
#include "rt/layout/trees.h"

#include <stdlib.h>

#include "rt/shapes/shape_words.h"

/* The number of crossings that the kernels can store for a primitive if
 * scene_has_crossed_meshes is true. A mesh may have more crossings; its kernel then
 * stores as many as fit. */
enum { CROSSINGS_WITH_MESHES = 8 };

bool primitive_is_mesh(const struct primitive *primitive)
{
    return shape_of(primitive)->crossings != NULL;
}

/* ---- Crossings ----------------------------------------------------------- */

bool region_is_simple(const struct scene *scene, const struct region *region)
{
    const struct primitive *first = &scene->primitives[region->first_primitive];
    return !scene->every_crossing && region->primitive_count == 1
           && !pigment_is_clear(&first->pigment);
}

static bool is_closed(const struct primitive *primitive)
{
    struct shape_words shape;
    shape_words(primitive, &shape);
    return shape.segments > 0 && !shape.state;
}

bool region_is_closed(const struct scene *scene, const struct region *region)
{
    for (size_t i = 0; i < region->primitive_count; i++)
        if (!is_closed(&scene->primitives[region->first_primitive + i]))
            return false;
    return true;
}

/* Assigns positions to the crossings of a mesh and to their triangles. */
static size_t place_mesh(const struct primitive *primitive,
                         const struct shape_words *shape, size_t next,
                         struct leaf_plan *plan)
{
    plan->first_state = plan->first_event = next;
    if (shape->state) {
        next += 4 * shape->segments;
        plan->first_event = next;
    }
    return next + (primitive->invisible ? 1 : 2) * shape->events;
}

/* Assigns positions to the crossings of a primitive: the ends of its segments, and its
 * visible crossings. These are the same positions in a solid, and two lists in other
 * shapes. In a patch, the two parameters of each visible crossing follow the lists. */
static size_t place_leaf(const struct primitive *primitive, size_t next,
                         struct leaf_plan *plan)
{
    struct shape_words shape;
    shape_words(primitive, &shape);
    if (shape.on_mesh)
        return place_mesh(primitive, &shape, next, plan);
    plan->first_state = next;
    plan->first_event = next;
    next += 2 * shape.segments;
    if (shape.state || shape.on_patch) {
        plan->first_event = next;
        next += shape.events;
    }
    return next + (shape.on_patch ? 2 * shape.events : 0);
}

size_t plan_leaves(const struct scene *scene, struct leaf_plan *plans)
{
    size_t most = 0;
    for (size_t i = 0; i < scene->region_count; i++) {
        const struct region *region = &scene->regions[i];
        bool simple = region_is_simple(scene, region);
        size_t next = 0;
        for (size_t k = 0; k < region->primitive_count; k++) {
            size_t leaf = region->first_primitive + k;
            plans[leaf].simple = simple;
            plans[leaf].value = k;
            next = place_leaf(&scene->primitives[leaf], next, &plans[leaf]);
        }
        if (!simple && next > most)
            most = next;
    }
    return most;
}

bool scene_has_crossed_meshes(const struct scene *scene)
{
    for (size_t i = 0; i < scene->region_count; i++) {
        const struct region *region = &scene->regions[i];
        if (region_is_simple(scene, region))
            continue;
        for (size_t k = 0; k < region->primitive_count; k++)
            if (primitive_is_mesh(&scene->primitives[region->first_primitive + k]))
                return true;
    }
    return false;
}

/* Returns the number of crossings that a kernel lists, or 0 for two shapes: a blob
 * alone reports only its nearest crossing, and a mesh has its own count. */
static size_t crossings_of(const struct primitive *primitive, bool alone)
{
    struct shape_words shape;
    if (alone && primitive->kind == PRIMITIVE_BLOB)
        return 0;
    shape_words(primitive, &shape);
    return shape.on_mesh ? 0 : shape.events;
}

size_t most_crossings(const struct scene *scene)
{
    size_t most = scene_has_crossed_meshes(scene) ? CROSSINGS_WITH_MESHES : 0;
    for (size_t i = 0; i < scene->region_count; i++) {
        const struct region *region = &scene->regions[i];
        const struct primitive *first = scene->primitives + region->first_primitive;
        bool alone = region_is_simple(scene, region);
        for (size_t k = 0; k < region->primitive_count; k++) {
            size_t count = crossings_of(&first[k], alone);
            if (count > most)
                most = count;
        }
    }
    return most;
}

size_t max_ray_hits(const struct scene *scene)
{
    size_t most = 0;
    for (size_t i = 0; i < scene->primitive_count; i++) {
        struct shape_words shape;
        shape_words(&scene->primitives[i], &shape);
        if (!scene->primitives[i].invisible)
            most += shape.events;
    }
    return most;
}

/* ---- The tree ------------------------------------------------------------ */

/* A value during the evaluation: the value at an index, or its complement. */
struct tree_term {
    size_t place;
    bool complement;
};

/* A stack of the values of nodes whose parents have not been evaluated. The value of
 * the first of these nodes is on top. */
struct evaluation {
    struct tree_plan *plan;
    size_t leaf_count, depth;
    struct tree_term *stack;
};

/* Returns the conjunction of x and y. De Morgan's rules avoid steps for complements.
 * Each step has its own value, so that all values can be inspected afterwards. */
static struct tree_term both(struct evaluation *evaluation, struct tree_term x,
                             struct tree_term y)
{
    struct tree_plan *plan = evaluation->plan;
    size_t result = evaluation->leaf_count + plan->step_count;
    struct tree_step *step = &plan->steps[plan->step_count++];
    bool turned = x.complement && !y.complement;
    step->operation = x.complement != y.complement ? STEP_AND_NOT
                      : x.complement               ? STEP_OR
                                                   : STEP_AND;
    step->left = turned ? y.place : x.place;
    step->right = turned ? x.place : y.place;
    step->result = result;
    return (struct tree_term){ result, x.complement && y.complement };
}

/* Returns the disjunction of x and y: the complement of (not x and not y). */
static struct tree_term either(struct evaluation *evaluation, struct tree_term x,
                               struct tree_term y)
{
    struct tree_term value;
    x.complement = !x.complement;
    y.complement = !y.complement;
    value = both(evaluation, x, y);
    value.complement = !value.complement;
    return value;
}

/* Combines the top `count` values of the stack into one by an operation. */
static void join_terms(struct evaluation *evaluation, size_t count,
                       enum tree_operation operation)
{
    struct tree_term *children = evaluation->stack + evaluation->depth - count;
    struct tree_term value = children[0];
    for (size_t i = 1; i < count; i++)
        value = operation == TREE_AND ? both(evaluation, value, children[i])
                                      : either(evaluation, value, children[i]);
    evaluation->depth -= count;
    evaluation->stack[evaluation->depth++] = value;
}

static size_t count_children(const struct scene *scene, size_t node)
{
    size_t count = 0;
    for (size_t child = node + 1; child < scene->nodes[node].next;
         child = scene->nodes[child].next)
        count++;
    return count;
}

static void evaluate(struct evaluation *evaluation, const struct scene *scene,
                     const struct region *region, size_t node)
{
    struct tree_plan *plan = evaluation->plan;
    struct tree_join *made = &plan->joins[node - region->first_node];
    struct tree_term *top = evaluation->stack + evaluation->depth;
    made->first_step = plan->step_count;
    switch (scene->nodes[node].operation) {
    case TREE_LEAF:
        top->place = scene->nodes[node].primitive - region->first_primitive;
        top->complement = false;
        evaluation->depth++;
        break;
    case TREE_NOT: top[-1].complement = !top[-1].complement; break;
    case TREE_AND:
    case TREE_OR:
        join_terms(evaluation, count_children(scene, node),
                   scene->nodes[node].operation);
        break;
    }
    made->value = evaluation->stack[evaluation->depth - 1].place;
    made->step_count = plan->step_count - made->first_step;
}

/* The loop runs backwards, because the value of a node depends on the values of its
 * children, which come after it. */
bool plan_tree(const struct scene *scene, const struct region *region,
               struct tree_plan *plan)
{
    struct evaluation evaluation = { .plan = plan,
                                     .leaf_count = region->primitive_count };
    plan->step_count = 0;
    evaluation.stack = calloc(region->node_count + 1, sizeof *evaluation.stack);
    if (!evaluation.stack)
        return false;
    for (size_t i = region->node_count; i-- > 0;)
        evaluate(&evaluation, scene, region, region->first_node + i);
    plan->result = evaluation.stack[0].place;
    plan->complement = evaluation.stack[0].complement;
    free(evaluation.stack);
    return true;
}

size_t most_leaves(const struct scene *scene)
{
    size_t most = 1;
    for (size_t i = 0; i < scene->region_count; i++)
        if (scene->regions[i].primitive_count > most)
            most = scene->regions[i].primitive_count;
    return most;
}
