/* regions.c - writes the regions of a scene as records. */
#include "rt/layout/regions.h"

#include <math.h>
#include <stdlib.h>

#include "rt/layout/bounds.h"
#include "rt/bvh/hierarchy.h"
#include "rt/layout/nesting.h"
#include "rt/layout/trees.h"
#include "rt/scene/vector3.h"
#include "rt/shapes/shape_words.h"

/* The data that is used to write the records of a scene's regions. */
struct places {
    const struct scene *scene;
    const struct bound *bounds; /* bound of each node */
    struct tree_join *joins;    /* steps of each node, numbered in the whole scene */
    bool *needed;               /* true for a node that must be true for its tree to be
                                 * true */
    size_t *kept;               /* for each node: the number of earlier nodes that are
                                 * not complements */
    size_t *results;            /* for each region: the index of the tree's value */
    int *bodies;                /* R_BODY of each region */
    uint64_t *clear;            /* for each region: the address of its word in
                                 * scene_clear, or 0 */
    struct hierarchy hierarchy;
    bool *spheres; /* for each node of the hierarchy: only spheres are below it */
    const struct region_places *given;
    struct row steps, nodes, regions;
};

static uint64_t node_at(const struct places *places, size_t i)
{
    return row_at(&places->nodes, places->kept[i]);
}

/* ---- Steps --------------------------------------------------------------- */

static void layout_step(struct record *record, const struct row *values,
                        const struct tree_step *step)
{
    record_integer(record, "T_OPERATION", (size_t)step->operation);
    record_address(record, "T_LEFT", row_at(values, step->left));
    record_address(record, "T_RIGHT", row_at(values, step->right));
    record_address(record, "T_RESULT", row_at(values, step->result));
    record_write(record);
}

/* Writes the evaluation steps of region i, after the `before` steps of previous
 * regions. Returns the new number of steps. */
static size_t layout_tree(struct record *record, struct places *places, size_t i,
                          struct tree_step *steps, size_t before)
{
    const struct region *region = &places->scene->regions[i];
    struct tree_plan plan = { .steps = steps,
                              .joins = &places->joins[region->first_node] };
    if (!plan_tree(places->scene, region, &plan)) {
        layout_fail(record->layout, "out of memory");
        return before;
    }
    places->results[i] = plan.result;
    if (region_is_closed(places->scene, region))
        places->bodies[i] = plan.complement ? -1 : 1;
    for (size_t k = 0; k < region->node_count; k++)
        plan.joins[k].first_step += before;
    for (size_t k = 0; k < plan.step_count; k++)
        layout_step(record, &places->given->values, &plan.steps[k]);
    return before + plan.step_count;
}

static void layout_steps(struct record_layout *layout, struct places *places)
{
    size_t count = places->scene->primitive_count, written = 0;
    struct tree_step *steps = calloc(count + 1, sizeof *steps);
    struct record record;
    if (!steps) {
        layout_fail(layout, "out of memory");
        return;
    }
    record_begin(&record, layout, "T_SIZE", count, 0);
    places->steps = record_row(&record);
    for (size_t i = 0; i < places->scene->region_count && !layout->failed; i++)
        written = layout_tree(&record, places, i, steps, written);
    record_end(&record);
    free(steps);
}

/* ---- Nodes --------------------------------------------------------------- */

/* Marks the nodes that must be true for their tree to be true: the root, and each child
 * of a marked intersection. Complements are marked, too, but have no records. */
static void find_needed(const struct scene *scene, const struct region *region,
                        bool *needed)
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

static bool has_mesh(const struct scene *scene, size_t node)
{
    for (size_t i = node; i < scene->nodes[node].next; i++)
        if (scene->nodes[i].operation == TREE_LEAF
            && primitive_is_mesh(&scene->primitives[scene->nodes[i].primitive]))
            return true;
    return false;
}

static void layout_node(struct record *record, const struct places *places, size_t i)
{
    const struct tree_node *node = &places->scene->nodes[i];
    const struct tree_join *join = &places->joins[i];
    record_bound(record, "N_BOUND", &places->bounds[i]);
    if (join->step_count > 0)
        record_address(record, "N_STEPS", row_at(&places->steps, join->first_step));
    record_integer(record, "N_STEP_COUNT", join->step_count);
    if (node->operation == TREE_LEAF)
        record_address(record, "N_PRIMITIVE",
                       row_at(&places->given->primitives, node->primitive));
    record_integer(record, "N_NEEDED", places->needed[i]);
    record_address(record, "N_NEXT", node_at(places, node->next));
    record_address(record, "N_VALUE", row_at(&places->given->values, join->value));
    if (object_symbol(record->layout->program, "N_MESH"))
        record_integer(record, "N_MESH", has_mesh(places->scene, i));
    record_write(record);
}

static void layout_nodes(struct record_layout *layout, struct places *places)
{
    const struct scene *scene = places->scene;
    struct record record;
    record_begin(&record, layout, "N_SIZE", places->kept[scene->node_count], 0);
    places->nodes = record_row(&record);
    for (size_t i = 0; i < scene->node_count && !layout->failed; i++)
        if (scene->nodes[i].operation != TREE_NOT)
            layout_node(&record, places, i);
    record_end(&record);
}

/* ---- Regions ------------------------------------------------------------- */

/* Returns 0: no shadow, 1: a full shadow, 2: a shadow with transparent parts. A region
 * casts a shadow if any of its primitives does. */
static size_t shadow_of(const struct scene *scene, const struct region *region)
{
    const struct primitive *first = &scene->primitives[region->first_primitive];
    bool casts = false, clear = false;
    for (size_t i = 0; i < region->primitive_count; i++) {
        casts = casts || !first[i].no_shadow;
        clear = clear || pigment_is_clear(&first[i].pigment);
    }
    return casts ? 1 + clear : 0;
}

/* Returns the kinds of rays to which all the region's primitives are invisible
 * (R_HIDDEN_FROM). */
static unsigned hidden_from(const struct scene *scene, const struct region *region)
{
    unsigned rays = HIDDEN_FROM_IMAGE | HIDDEN_FROM_REFLECTIONS;
    for (size_t i = 0; i < region->primitive_count; i++)
        rays &= scene->primitives[region->first_primitive + i].hidden_from;
    return rays;
}

bool scene_hides(const struct scene *scene)
{
    for (size_t i = 0; i < scene->region_count; i++)
        if (hidden_from(scene, &scene->regions[i]) != 0)
            return true;
    return false;
}

/* Returns the bound of a region. A complement has the bound of its operand, because
 * both have the same surfaces. */
static const struct bound *bound_of(const struct places *places,
                                    const struct region *region)
{
    size_t solid = region->first_node;
    while (places->scene->nodes[solid].operation == TREE_NOT)
        solid++;
    return &places->bounds[solid];
}

/* Returns true if a region's box is tested in addition to its sphere. The mean
 * cross-section of a convex body over all directions is a quarter of its surface area.
 * The box is tested if its mean cross-section is less than `worth` times the
 * cross-section of the sphere. */
static bool is_boxed(const struct bound *bound)
{
    static const double worth = 0.8;
    double side[3];
    for (int i = 0; i < 3; i++)
        side[i] = fmax(bound->high[i] - bound->low[i], 0);
    return !bound_is_none(bound)
           && (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]) / 2
                  < worth * PI * bound->radius * bound->radius;
}

/* Writes the centre of a region's bounding box and half of each side length. */
static void layout_box(struct record *record, const struct bound *bound)
{
    double words[6];
    for (int i = 0; i < 3; i++) {
        words[i] = (bound->low[i] + bound->high[i]) / 2;
        words[3 + i] = (bound->high[i] - bound->low[i]) / 2;
    }
    record_numbers(record, "R_BOX", words, 6);
}

static void layout_region(struct record *record, const struct places *places, size_t i)
{
    const struct scene *scene = places->scene;
    const struct region *region = &scene->regions[i];
    const struct bound *bound = bound_of(places, region);
    uint64_t way = 0;
    record->line = region->line;
    record_bound(record, "R_BOUND", bound);
    if (region_is_simple(scene, region))
        way += layout_symbol(record->layout, "REGION_SIMPLE");
    if (is_boxed(bound)) {
        way += layout_symbol(record->layout, "REGION_BOXED");
        layout_box(record, bound);
    }
    record_integer(record, "R_FLAGS", (size_t)way);
    record_integer(record, "R_SHADOW", shadow_of(scene, region));
    record_address(record, "R_CLEAR", places->clear[i]);
    record_address(record, "R_FIRST",
                   row_at(&places->given->primitives, region->first_primitive));
    record_address(record, "R_NODES", node_at(places, region->first_node));
    record_address(record, "R_NODES_END",
                   node_at(places, region->first_node + region->node_count));
    record_address(record, "R_RESULT",
                   row_at(&places->given->values, places->results[i]));
    record_signed(record, "R_BODY", places->bodies[i]);
    if (object_symbol(record->layout->program, "R_HIDDEN_FROM"))
        record_integer(record, "R_HIDDEN_FROM", hidden_from(scene, region));
    record_write(record);
}

/* Reserves a word for each region whose shadow has transparent parts. */
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
    layout_word(layout, "scene_clear_count", c205_from_integer((int64_t)count));
}

/* Returns true if the region is an opaque sphere in world space that casts a full
 * shadow, is visible to all rays, and has the yield 0 (rt/shapes/coincident.h). */
static bool is_sphere(const struct scene *scene, const struct region *region)
{
    const struct primitive *first = &scene->primitives[region->first_primitive];
    struct shape_words shape;
    shape_words(first, &shape);
    return first->kind == PRIMITIVE_SPHERE && !shape.transformed
           && region_is_simple(scene, region) && region->yield == 0
           && shadow_of(scene, region) == 1 && hidden_from(scene, region) == 0;
}

/* Marks each node if all regions of the leaves below it satisfy is_sphere, and no leaf
 * has more than `most` regions. */
static void find_spheres(struct places *places, size_t most)
{
    const struct hierarchy *hierarchy = &places->hierarchy;
    const struct scene *scene = places->scene;
    const struct hierarchy_node *nodes = hierarchy->nodes;
    const size_t *order = hierarchy->order;
    for (size_t i = hierarchy->node_count; i-- > 0;) {
        bool all = nodes[i].count <= most;
        for (size_t k = 0; all && k < nodes[i].count; k++)
            all = is_sphere(scene, &scene->regions[order[nodes[i].first + k]]);
        if (nodes[i].count == 0)
            all = places->spheres[i + 1] && places->spheres[nodes[i + 1].next];
        places->spheres[i] = all;
    }
}

static void layout_hierarchy_node(struct record *record, const struct places *places,
                                  const struct row *row, size_t i)
{
    const struct hierarchy_node *nodes = places->hierarchy.nodes;
    const struct hierarchy_node *node = &nodes[i];
    record_bound(record, "H_BOUND", &node->bound);
    record_integer(record, "H_REGION_COUNT", node->count);
    record_integer(record, "H_SPHERES", places->spheres[i]);
    if (node->count > 0) {
        record_address(record, "H_REGIONS", row_at(&places->regions, node->first));
    } else {
        record_address(record, "H_REGIONS", row_at(row, nodes[i + 1].next));
        record_numbers(record, "H_DIRECTION", node->way, 3);
    }
    record_write(record);
}

static void layout_hierarchy(struct record_layout *layout, struct places *places)
{
    const struct hierarchy *hierarchy = &places->hierarchy;
    struct record record;
    struct row row;
    find_spheres(places, (size_t)layout_symbol(layout, "MAX_SPHERES"));
    record_begin(&record, layout, "H_SIZE", hierarchy->node_count, 0);
    row = record_row(&record);
    for (size_t i = 0; i < hierarchy->node_count && !layout->failed; i++)
        layout_hierarchy_node(&record, places, &row, i);
    record_end(&record);
    layout_word(layout, "scene_hierarchy", hierarchy->node_count > 0 ? row.first : 0);
}

/* Writes the regions in the order in which the bounding volume hierarchy lists them. */
static void layout_ordered(struct record_layout *layout, struct places *places)
{
    const struct scene *scene = places->scene;
    struct record record;
    record_begin(&record, layout, "R_SIZE", scene->region_count, 0);
    places->regions = record_row(&record);
    layout_word(layout, "scene_regions", record.address);
    for (size_t i = 0; i < scene->region_count && !layout->failed; i++)
        layout_region(&record, places, places->hierarchy.order[i]);
    record_end(&record);
    layout_word(layout, "scene_region_count",
                c205_from_integer((int64_t)places->hierarchy.loose));
    layout_word(layout, "scene_region_total",
                c205_from_integer((int64_t)scene->region_count));
}

/* ---- The whole scene ----------------------------------------------------- */

static bool plan_hierarchy(struct places *places, enum bounding bounding)
{
    const struct scene *scene = places->scene;
    struct bound *bounds;
    bool good;
    if (bounding != BOUNDING_HIERARCHY)
        return hierarchy_none(scene->region_count, &places->hierarchy);
    bounds = malloc((scene->region_count + 1) * sizeof *bounds);
    for (size_t i = 0; bounds && i < scene->region_count; i++)
        bounds[i] = *bound_of(places, &scene->regions[i]);
    good = bounds && hierarchy_build(bounds, scene->region_count, &places->hierarchy);
    free(bounds);
    return good;
}

static void plan_nodes(struct places *places)
{
    const struct scene *scene = places->scene;
    count_nodes(places);
    for (size_t i = 0; i < scene->region_count; i++)
        find_needed(scene, &scene->regions[i], places->needed);
}

static void layout_records(struct record_layout *layout, struct places *places)
{
    plan_nodes(places);
    layout_steps(layout, places);
    layout_nodes(layout, places);
    layout_clear(layout, places);
    layout_ordered(layout, places);
    layout_hierarchy(layout, places);
}

/* Writes the regions of a scene whose trees are in their final form. */
static void layout_scene(struct record_layout *layout, const struct scene *scene,
                         enum bounding bounding, const struct bound *bounds,
                         const struct region_places *given)
{
    size_t nodes = scene->node_count + 1, regions = scene->region_count + 1;
    struct places places = {
        .scene = scene,
        .bounds = bounds,
        .joins = calloc(nodes, sizeof *places.joins),
        .needed = calloc(nodes, sizeof *places.needed),
        .kept = calloc(nodes, sizeof *places.kept),
        .results = calloc(regions, sizeof *places.results),
        .bodies = calloc(regions, sizeof *places.bodies),
        .clear = calloc(regions, sizeof *places.clear),
        .spheres = calloc(2 * regions, sizeof *places.spheres),
        .given = given,
    };
    if (places.joins && places.needed && places.kept && places.results && places.bodies
        && places.clear && places.spheres && plan_hierarchy(&places, bounding))
        layout_records(layout, &places);
    else
        layout_fail(layout, "out of memory");
    free(places.joins);
    free(places.needed);
    free(places.kept);
    free(places.results);
    free(places.bodies);
    free(places.clear);
    free(places.spheres);
    hierarchy_free(&places.hierarchy);
}

static void layout_nested(struct record_layout *layout, const struct scene *scene,
                          const struct region_places *places)
{
    struct nested_scene nested = { .bounds = NULL };
    if (nesting_make(scene, &nested))
        layout_scene(layout, &nested.scene, BOUNDING_HIERARCHY, nested.bounds, places);
    else
        layout_fail(layout, "out of memory");
    nesting_free(&nested);
}

static void layout_as_written(struct record_layout *layout, const struct scene *scene,
                              enum bounding bounding,
                              const struct region_places *places)
{
    size_t nodes = scene->node_count;
    struct bound *bounds = malloc((nodes + 1) * sizeof *bounds);
    for (size_t i = 0; bounds && i < nodes; i++)
        bounds[i] = bound_none;
    if (bounds && (bounding == BOUNDING_NONE || bound_nodes(scene, bounds)))
        layout_scene(layout, scene, bounding, bounds, places);
    else
        layout_fail(layout, "out of memory");
    free(bounds);
}

void layout_regions(struct record_layout *layout, const struct scene *scene,
                    enum bounding bounding, const struct region_places *places)
{
    if (bounding == BOUNDING_HIERARCHY)
        layout_nested(layout, scene, places);
    else
        layout_as_written(layout, scene, bounding, places);
}
