#include "rt/layout/regions.h"

#include <stdlib.h>

#include "rt/shapes/shape_words.h"

/* --- crossings ----------------------------------------------------------- */

static bool is_simple(const struct scene *scene, const struct region *region)
{
    const struct primitive
        *first = &scene->primitives[region->first_primitive];

    return region->primitive_count == 1 && !pigment_is_clear(&first->pigment);
}

/* A solid's segments are what can be seen of it; other shapes have both, and
 * a patch the two parameters of each behind its crossings. */
static size_t place_leaf(const struct primitive *primitive, size_t next,
                         struct leaf_plan *plan)
{
    struct shape_words shape;

    shape_words(primitive, &shape);
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
        bool simple = is_simple(scene, region);
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

size_t most_crossings(const struct scene *scene)
{
    size_t most = 0;

    for (size_t i = 0; i < scene->primitive_count; i++) {
        struct shape_words shape;

        shape_words(&scene->primitives[i], &shape);
        if (shape.events > most)
            most = shape.events;
    }
    return most;
}

/* --- the tree ------------------------------------------------------------ */

/* A value under way: where it stands, or where its complement does. */
struct tree_term {
    size_t place;
    bool complement;
};

/* The values of the nodes that have no parent yet, the first node's on top. */
struct evaluation {
    struct tree_plan *plan;
    size_t leaf_count, depth;
    struct tree_term *stack;
};

/* x and y, by de Morgan's rules without complements of their own.  Each step
 * has a value to itself, so that all can be looked at afterwards. */
static struct tree_term both(struct evaluation *evaluation,
                             struct tree_term x, struct tree_term y)
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

static struct tree_term either(struct evaluation *evaluation,
                               struct tree_term x, struct tree_term y)
{
    struct tree_term value;

    x.complement = !x.complement;
    y.complement = !y.complement;
    value = both(evaluation, x, y);
    value.complement = !value.complement;
    return value;
}

/* The topmost values become one. */
static void join(struct evaluation *evaluation, size_t count,
                 enum tree_operation operation)
{
    struct tree_term *children = evaluation->stack + evaluation->depth
                                 - count;
    struct tree_term value = children[0];

    for (size_t i = 1; i < count; i++)
        value = operation == TREE_AND
                    ? both(evaluation, value, children[i])
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
    struct tree_term *top = evaluation->stack + evaluation->depth;

    switch (scene->nodes[node].operation) {
    case TREE_LEAF:
        top->place = scene->nodes[node].primitive - region->first_primitive;
        top->complement = false;
        evaluation->depth++;
        break;
    case TREE_NOT: top[-1].complement = !top[-1].complement; break;
    case TREE_AND:
    case TREE_OR:
        join(evaluation, count_children(scene, node),
             scene->nodes[node].operation);
        break;
    }
}

/* Backwards, so that what is below a node comes before it. */
bool plan_tree(const struct scene *scene, const struct region *region,
               struct tree_plan *plan)
{
    struct evaluation evaluation = { .plan = plan,
                                     .leaf_count = region->primitive_count };

    plan->step_count = 0;
    evaluation.stack = calloc(region->node_count + 1,
                              sizeof *evaluation.stack);
    if (!evaluation.stack)
        return false;
    for (size_t i = region->node_count; i-- > 0;)
        evaluate(&evaluation, scene, region, region->first_node + i);
    plan->result = evaluation.stack[0].place;
    free(evaluation.stack);
    return true;
}

/* --- records ------------------------------------------------------------- */

/* What the records of a scene's regions refer to. */
struct places {
    const struct scene *scene;
    enum bounding bounding;
    struct bound *bounds; /* of the nodes */
    struct hierarchy hierarchy;
    uint64_t *clear; /* of the regions: the address of its word, or 0 */
    bool *needed;    /* without which their trees have no value */
    size_t *kept;    /* how many nodes before each are no complements */
    bool *spheres;   /* nodes of the hierarchy with spheres alone below */
    struct tree_step *steps;
    uint64_t primitives, nodes, regions; /* addresses of the first */
    size_t primitive_size, node_size, region_size;
    size_t values; /* of the region that has most */
};

static uint64_t primitive_at(const struct places *places, size_t i)
{
    return places->primitives + UINT64_C(64) * places->primitive_size * i;
}

static uint64_t node_at(const struct places *places, size_t i)
{
    return places->nodes + UINT64_C(64) * places->node_size * places->kept[i];
}

/* The parts of an intersection are needed where it is; complements are not
 * recorded. */
static void find_needed(const struct scene *scene,
                        const struct region *region, bool *needed)
{
    needed[region->first_node] = true;
    for (size_t i = 0; i < region->node_count; i++) {
        size_t node = region->first_node + i;

        if (!needed[node] || scene->nodes[node].operation != TREE_AND)
            continue;
        for (size_t child = node + 1; child < scene->nodes[node].next;
             child = scene->nodes[child].next)
            needed[child] = true;
    }
}

static void count_nodes(struct places *places)
{
    const struct scene *scene = places->scene;

    for (size_t i = 0; i < scene->node_count; i++) {
        bool kept = scene->nodes[i].operation != TREE_NOT;

        places->kept[i + 1] = places->kept[i] + kept;
    }
}

static void layout_node(struct record *record, const struct places *places,
                        size_t i)
{
    const struct tree_node *node = &places->scene->nodes[i];

    record_bound(record, "N_BOUND", &places->bounds[i]);
    if (node->operation == TREE_LEAF)
        record_address(record, "N_PRIMITIVE",
                       primitive_at(places, node->primitive));
    record_address(record, "N_NEXT", node_at(places, node->next));
    record_integer(record, "N_NEEDED", places->needed[i]);
    record_write(record);
}

static void layout_nodes(struct record_layout *layout, struct places *places)
{
    const struct scene *scene = places->scene;
    struct record record;

    record_begin(&record, layout, "N_SIZE", places->kept[scene->node_count],
                 0);
    places->nodes = record.address;
    places->node_size = record.size;
    for (size_t i = 0; i < scene->node_count && !layout->failed; i++)
        if (scene->nodes[i].operation != TREE_NOT)
            layout_node(&record, places, i);
    record_end(&record);
}

/* 0: none, 1: a full shadow, 2: parts of it are clear.  One primitive that
 * casts a shadow is enough for all. */
static size_t shadow_of(const struct scene *scene,
                        const struct region *region)
{
    const struct primitive
        *first = &scene->primitives[region->first_primitive];
    bool casts = false, clear = false;

    for (size_t i = 0; i < region->primitive_count; i++) {
        casts = casts || !first[i].no_shadow;
        clear = clear || pigment_is_clear(&first[i].pigment);
    }
    return casts ? 1 + clear : 0;
}

static void layout_step(struct record *steps, const struct tree_step *step)
{
    record_integer(steps, "T_OPERATION", (size_t)step->operation);
    record_integer(steps, "T_LEFT", step->left);
    record_integer(steps, "T_RIGHT", step->right);
    record_integer(steps, "T_RESULT", step->result);
    record_write(steps);
}

static void layout_tree(struct record *record, struct record *steps,
                        struct places *places, const struct region *region)
{
    struct tree_plan plan = { .steps = places->steps };
    size_t values;

    if (!plan_tree(places->scene, region, &plan))
        layout_fail(record->layout, "no memory");
    record_address(record, "R_STEPS", steps->address);
    record_integer(record, "R_STEP_COUNT", plan.step_count);
    record_integer(record, "R_RESULT", plan.result);
    for (size_t i = 0; i < plan.step_count; i++)
        layout_step(steps, &plan.steps[i]);
    values = region->primitive_count + plan.step_count;
    if (values > places->values)
        places->values = values;
}

/* The node that bounds a region: what is not bounds nothing. */
static const struct bound *bound_of(const struct places *places,
                                    const struct region *region)
{
    size_t solid = region->first_node;

    while (places->scene->nodes[solid].operation == TREE_NOT)
        solid++;
    return &places->bounds[solid];
}

static void layout_region(struct record *record, struct record *steps,
                          struct places *places, size_t i)
{
    const struct scene *scene = places->scene;
    const struct region *region = &scene->regions[i];

    record->line = region->line;
    record_bound(record, "R_BOUND", bound_of(places, region));
    record_integer(record, "R_SIMPLE", is_simple(scene, region));
    record_integer(record, "R_SHADOW", shadow_of(scene, region));
    record_address(record, "R_CLEAR", places->clear[i]);
    record_address(record, "R_FIRST",
                   primitive_at(places, region->first_primitive));
    record_integer(record, "R_PRIMITIVES", region->primitive_count);
    record_address(record, "R_NODES", node_at(places, region->first_node));
    record_address(record, "R_NODES_END",
                   node_at(places, region->first_node + region->node_count));
    layout_tree(record, steps, places, region);
    record_write(record);
}

/* A word for each region whose shadow is not full. */
static void layout_clear(struct record_layout *layout, struct places *places)
{
    const struct scene *scene = places->scene;
    uint64_t first;
    size_t count = 0;

    for (size_t i = 0; i < scene->region_count; i++)
        if (shadow_of(scene, &scene->regions[i]) == 2)
            places->clear[i] = ++count;
    first = layout_reserve(layout, count);
    for (size_t i = 0; i < scene->region_count; i++)
        if (places->clear[i] > 0)
            places->clear[i] = first + 64 * (places->clear[i] - 1);
    layout_word(layout, "scene_clear", first);
    layout_word(layout, "scene_clear_count",
                c205_from_integer((int64_t)count));
}

/* One opaque sphere that stands in the world's space, and casts a shadow? */
static bool is_sphere(const struct scene *scene, const struct region *region)
{
    const struct primitive
        *first = &scene->primitives[region->first_primitive];
    struct shape_words shape;

    shape_words(first, &shape);
    return first->kind == PRIMITIVE_SPHERE && !shape.transformed
           && is_simple(scene, region) && shadow_of(scene, region) == 1;
}

/* Of which nodes all regions below are such spheres, and few in a leaf? */
static void find_spheres(struct places *places, size_t most)
{
    const struct hierarchy *hierarchy = &places->hierarchy;
    const struct scene *scene = places->scene;
    const struct hierarchy_node *nodes = hierarchy->nodes;
    const size_t *order = hierarchy->order;

    for (size_t i = hierarchy->node_count; i-- > 0;) {
        bool all = nodes[i].count <= most;

        for (size_t k = 0; all && k < nodes[i].count; k++)
            all = is_sphere(scene,
                            &scene->regions[order[nodes[i].first + k]]);
        if (nodes[i].count == 0)
            all = places->spheres[i + 1]
                  && places->spheres[nodes[i + 1].next];
        places->spheres[i] = all;
    }
}

static void layout_hierarchy_node(struct record *record,
                                  const struct places *places, uint64_t first,
                                  size_t i)
{
    const struct hierarchy_node *nodes = places->hierarchy.nodes;
    const struct hierarchy_node *node = &nodes[i];
    uint64_t size = UINT64_C(64) * record->size;

    record_bound(record, "H_BOUND", &node->bound);
    record_integer(record, "H_REGION_COUNT", node->count);
    record_integer(record, "H_SPHERES", places->spheres[i]);
    if (node->count > 0) {
        record_address(record, "H_REGIONS",
                       places->regions
                           + UINT64_C(64) * places->region_size
                                 * node->first);
    } else {
        record_address(record, "H_REGIONS", first + size * nodes[i + 1].next);
        record_numbers(record, "H_WAY", node->way, 3);
    }
    record_write(record);
}

static void layout_hierarchy(struct record_layout *layout,
                             struct places *places)
{
    const struct hierarchy *hierarchy = &places->hierarchy;
    struct record record;
    uint64_t first;

    find_spheres(places, (size_t)layout_symbol(layout, "SPHERES_MOST"));
    record_begin(&record, layout, "H_SIZE", hierarchy->node_count, 0);
    first = record.address;
    for (size_t i = 0; i < hierarchy->node_count && !layout->failed; i++)
        layout_hierarchy_node(&record, places, first, i);
    record_end(&record);
    layout_word(layout, "scene_hierarchy",
                hierarchy->node_count > 0 ? first : 0);
}

/* In the hierarchy's order. */
static void layout_ordered(struct record_layout *layout,
                           struct places *places)
{
    const struct scene *scene = places->scene;
    struct record record, steps;

    record_begin(&steps, layout, "T_SIZE", scene->primitive_count, 0);
    record_begin(&record, layout, "R_SIZE", scene->region_count, 0);
    places->regions = record.address;
    places->region_size = record.size;
    layout_word(layout, "scene_regions", record.address);
    for (size_t i = 0; i < scene->region_count && !layout->failed; i++)
        layout_region(&record, &steps, places, places->hierarchy.order[i]);
    record_end(&record);
    record_end(&steps);
    layout_word(layout, "scene_region_count",
                c205_from_integer((int64_t)places->hierarchy.loose));
    layout_word(layout, "scene_region_total",
                c205_from_integer((int64_t)scene->region_count));
}

static void layout_records(struct record_layout *layout,
                           struct places *places)
{
    layout_nodes(layout, places);
    layout_clear(layout, places);
    layout_ordered(layout, places);
    layout_hierarchy(layout, places);
    layout_word(layout, "scene_values",
                layout_reserve(layout,
                               places->values
                                   * layout_symbol(layout, "VALUE_SIZE")));
}

static bool fill_bounds(struct places *places)
{
    for (size_t i = 0; i < places->scene->node_count; i++)
        places->bounds[i] = bound_none;
    return places->bounding == BOUNDING_NONE
           || bound_nodes(places->scene, places->bounds);
}

static bool plan_hierarchy(struct places *places)
{
    const struct scene *scene = places->scene;
    struct bound *bounds;
    bool good;

    if (places->bounding != BOUNDING_HIERARCHY)
        return hierarchy_none(scene->region_count, &places->hierarchy);
    bounds = malloc((scene->region_count + 1) * sizeof *bounds);
    for (size_t i = 0; bounds && i < scene->region_count; i++)
        bounds[i] = *bound_of(places, &scene->regions[i]);
    good = bounds
           && hierarchy_build(bounds, scene->region_count,
                              &places->hierarchy);
    free(bounds);
    return good;
}

void layout_regions(struct record_layout *layout, const struct scene *scene,
                    enum bounding bounding, uint64_t primitives)
{
    size_t room = scene->node_count + 1;
    struct places places = {
        .scene = scene,
        .bounding = bounding,
        .bounds = calloc(room, sizeof *places.bounds),
        .needed = calloc(room, sizeof *places.needed),
        .kept = calloc(room, sizeof *places.kept),
        .spheres = calloc(2 * scene->region_count + 1,
                          sizeof *places.spheres),
        .clear = calloc(scene->region_count + 1, sizeof *places.clear),
        .steps = calloc(scene->primitive_count + 1, sizeof *places.steps),
        .primitives = primitives,
        .primitive_size = (size_t)layout_symbol(layout, "P_SIZE"),
    };

    if (!places.bounds || !places.needed || !places.kept || !places.steps
        || !places.clear || !places.spheres || !fill_bounds(&places)
        || !plan_hierarchy(&places)) {
        layout_fail(layout, "no memory");
    } else {
        count_nodes(&places);
        for (size_t i = 0; i < scene->region_count; i++)
            find_needed(scene, &scene->regions[i], places.needed);
        layout_records(layout, &places);
    }
    free(places.bounds);
    free(places.needed);
    free(places.kept);
    free(places.spheres);
    free(places.clear);
    hierarchy_free(&places.hierarchy);
    free(places.steps);
}
