/* hierarchy.c - builds bounding volume hierarchies by a surface area heuristic. */
#include "rt/bvh/hierarchy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rt/bvh/cuts.h"

enum {
    EXACT = 64,       /* lists with more parts get the sphere around their box */
    HALVED_FROM = 64, /* from this depth on, lists are halved */
};

struct build {
    struct cutting cutting; /* uses the boxes around the spheres */
    const struct bound *bounds;
    struct hierarchy *hierarchy;
    struct bound *parts; /* room for the bounds of EXACT parts */
};

/* Returns the squared radius of the sphere around the box, times a constant. It is
 * proportional to the surface of the sphere. */
static double surface_of(const struct box *box)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double side = box->high[i] - box->low[i];
        sum += side * side;
    }
    return sum;
}

/* Returns the expected number of tests in a part, for a ray that hits the sphere around
 * the whole. Such a ray hits the part's sphere with a probability equal to the ratio of
 * the surfaces. */
static double cost_of(const struct cut_part *part, const struct box *whole)
{
    double surface = surface_of(whole);
    double chance = surface > 0 ? surface_of(&part->box) / surface : 1;
    return part->count == 1 ? 1 : 1 + chance * (double)part->count;
}

static void take_bound(const struct bound *bound, struct boxed *thing)
{
    for (int i = 0; i < 3; i++) {
        thing->box.low[i] = bound->center[i] - bound->radius;
        thing->box.high[i] = bound->center[i] + bound->radius;
        thing->place[i] = bound->center[i];
    }
}

/* ---- Nodes --------------------------------------------------------------- */

static void bound_many(const struct build *build, const size_t *row, size_t count,
                       const struct box *box, struct bound *whole)
{
    double reach = 0;
    for (int i = 0; i < 3; i++)
        whole->center[i] = (box->low[i] + box->high[i]) / 2;
    for (size_t i = 0; i < count; i++)
        reach = fmax(reach, bound_reach(&build->bounds[row[i]], whole->center));
    whole->radius = reach * (1 + 1e-12);
    memcpy(whole->low, box->low, sizeof whole->low);
    memcpy(whole->high, box->high, sizeof whole->high);
}

static void bound_row(const struct build *build, const size_t *row, size_t count,
                      const struct box *box, struct bound *whole)
{
    if (count > EXACT) {
        bound_many(build, row, count, box, whole);
        return;
    }
    for (size_t i = 0; i < count; i++)
        build->parts[i] = build->bounds[row[i]];
    bound_enclose(build->parts, count, whole);
}

static void find_way(struct hierarchy_node *nodes, size_t node)
{
    const struct bound *first = &nodes[node + 1].bound;
    const struct bound *second = &nodes[nodes[node + 1].next].bound;
    for (int i = 0; i < 3; i++)
        nodes[node].way[i] = second->center[i] - first->center[i];
}

/* Builds the node of the regions first .. first + count - 1 of the order, and the
 * subtree below it. A split by cost can be very uneven. Lists are therefore halved from
 * the depth HALVED_FROM on, so that no path is longer than HIERARCHY_DEPTH. */
static void build_node(const struct build *build, size_t first, size_t count,
                       size_t depth)
{
    struct hierarchy *hierarchy = build->hierarchy;
    size_t *row = hierarchy->order + first;
    size_t number = hierarchy->node_count++;
    struct hierarchy_node *node = &hierarchy->nodes[number];
    struct box box = box_about(build->cutting.things, row, count);
    struct cut cut = cut_find(&build->cutting, row, count, &box, (double)count);
    *node = (struct hierarchy_node){ .first = first, .count = count };
    bound_row(build, row, count, &box, &node->bound);
    if (cut.axis >= 0) {
        size_t lower = depth >= HALVED_FROM
                           ? count / 2
                           : cut_row(&build->cutting, row, count, &cut);
        node->count = 0;
        build_node(build, first, lower, depth + 1);
        build_node(build, first + lower, count - lower, depth + 1);
        find_way(hierarchy->nodes, number);
    }
    node->next = hierarchy->node_count;
}

/* ---- The whole hierarchy ------------------------------------------------- */

/* Moves unbounded regions to the front of the order. */
static void put_loose(struct hierarchy *hierarchy, const struct bound *bounds)
{
    size_t bound = 0, loose = 0;
    for (size_t i = 0; i < hierarchy->count; i++)
        loose += bound_is_none(&bounds[i]);
    hierarchy->loose = loose;
    loose = 0;
    for (size_t i = 0; i < hierarchy->count; i++)
        if (bound_is_none(&bounds[i]))
            hierarchy->order[loose++] = i;
        else
            hierarchy->order[hierarchy->loose + bound++] = i;
}

bool hierarchy_none(size_t count, struct hierarchy *hierarchy)
{
    *hierarchy = (struct hierarchy){
        .count = count,
        .loose = count,
        .order = malloc((count + 1) * sizeof *hierarchy->order),
    };
    for (size_t i = 0; hierarchy->order && i < count; i++)
        hierarchy->order[i] = i;
    return hierarchy->order;
}

/* Builds the hierarchy of all bounded regions. A hierarchy of a single leaf is removed,
 * because it would save no test. */
static void build_all(const struct build *build)
{
    struct hierarchy *hierarchy = build->hierarchy;
    size_t left;
    put_loose(hierarchy, build->bounds);
    left = hierarchy->count - hierarchy->loose;
    if (left > 0)
        build_node(build, hierarchy->loose, left, 1);
    if (hierarchy->node_count == 1) {
        hierarchy->node_count = 0;
        hierarchy->loose = hierarchy->count;
    }
}

bool hierarchy_build(const struct bound *bounds, size_t count,
                     struct hierarchy *hierarchy)
{
    struct boxed *things = malloc((count + 1) * sizeof *things);
    size_t *other = malloc((count + 1) * sizeof *other);
    struct build build = { { things, cost_of, other },
                           bounds,
                           hierarchy,
                           malloc(EXACT * sizeof *build.parts) };
    bool good = hierarchy_none(count, hierarchy);
    hierarchy->nodes = malloc((2 * count + 1) * sizeof *hierarchy->nodes);
    good = good && things && other && build.parts && hierarchy->nodes;
    for (size_t i = 0; good && i < count; i++)
        take_bound(&bounds[i], &things[i]);
    if (good)
        build_all(&build);
    free(things);
    free(other);
    free(build.parts);
    return good;
}

void hierarchy_free(struct hierarchy *hierarchy)
{
    free(hierarchy->order);
    free(hierarchy->nodes);
    *hierarchy = (struct hierarchy){ 0 };
}
